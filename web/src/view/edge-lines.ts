import { type Color, InstancedInterleavedBuffer, InterleavedBufferAttribute, Sphere } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

/** Edges as lines with a width in css pixels. */
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

  /** xyz of both ends of each edge. */
  show(ends: Float32Array): void {
    this.object.geometry.dispose();
    // Like setPositions(), which would also loop over all edges for a box and a sphere.
    const geometry = new LineSegmentsGeometry();
    const buffer = new InstancedInterleavedBuffer(ends, 6, 1);
    geometry.setAttribute('instanceStart', new InterleavedBufferAttribute(buffer, 3, 0));
    geometry.setAttribute('instanceEnd', new InterleavedBufferAttribute(buffer, 3, 3));
    geometry.instanceCount = ends.length / 6;
    geometry.boundingSphere = new Sphere();
    this.object.geometry = geometry;
    this.object.visible = ends.length > 0;
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
