import type { Color } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

/** Boundary edges as lines of a width in css pixels. */
export class BoundaryLines {
  private readonly material: LineMaterial;
  readonly object: LineSegments2;

  constructor(width: number, dimension: 2 | 3) {
    this.material = new LineMaterial({ linewidth: width, depthTest: dimension === 3 });
    this.object = new LineSegments2(new LineSegmentsGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.visible = false;
    this.object.renderOrder = 1;
  }

  /** `points` has `dimension` coordinates per vertex, `edges` are pairs of vertices. */
  show(points: Float32Array, dimension: 2 | 3, edges: Uint32Array): void {
    const ends = new Float32Array(3 * edges.length);
    edges.forEach((v, i) => {
      for (let d = 0; d < dimension; ++d) ends[3 * i + d] = points[dimension * v + d];
    });
    this.object.geometry.dispose();
    this.object.geometry = new LineSegmentsGeometry();
    this.object.geometry.setPositions(ends);
    this.object.visible = edges.length > 0;
  }

  setColor(color: Color): void {
    this.material.color = color;
  }

  setResolution(width: number, height: number): void {
    this.material.resolution.set(width, height);
  }
}
