import type { Color } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { perCorner } from './mesh';

/** Edges as lines of a width in css pixels. */
export class EdgeLines {
  private readonly material: LineMaterial;
  readonly object: LineSegments2;

  constructor(width: number, depthTest: boolean) {
    // Transparent only so that they are drawn after the translucent surface.
    this.material = new LineMaterial({ linewidth: width, depthTest, transparent: true });
    this.object = new LineSegments2(new LineSegmentsGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.visible = false;
    this.object.renderOrder = 1;
  }

  /** `points` has 3 coordinates per vertex, `edges` are pairs of vertices. */
  show(points: Float32Array, edges: Uint32Array): void {
    const ends = perCorner(points, 3, edges);
    this.object.geometry.dispose();
    this.object.geometry = new LineSegmentsGeometry();
    this.object.geometry.setPositions(ends);
    this.object.visible = edges.length > 0;
  }

  /** In css pixels. */
  setWidth(width: number): void {
    this.material.linewidth = width;
  }

  setColor(color: Color): void {
    this.material.color = color;
  }

  setResolution(width: number, height: number): void {
    this.material.resolution.set(width, height);
  }
}
