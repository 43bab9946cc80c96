import type { ChartMesh } from '../arrange/chart-mesh';
import { follow } from '../arrange/chart-mesh';
import type { Point } from '../arrange/motion';

/** A chart that is bent by one of its pins. */
export interface Bending {
  chart: number;
  mesh: ChartMesh;
  /** a and b of each vertex of the mesh, as `pinWeights` returns them. */
  weights: Float64Array;
}

/** For each corner of the layout, what the shader needs; nothing for other charts. */
export function cornerWeights({ mesh, weights }: Bending, into: Float32Array): void {
  into.fill(0);
  mesh.corners.forEach((corner, i) => {
    const v = mesh.indices[i];
    into[2 * corner] = weights[2 * v];
    into[2 * corner + 1] = weights[2 * v + 1];
  });
}

/** The ends of the boundary edges of the bent chart, in the plane that is drawn. */
export function bentOutline(
  { mesh, weights }: Bending,
  by: Point,
  toPlane: (uv: Point) => Point,
): Float32Array {
  const { outline, texcoords } = mesh;
  const ends = new Float32Array(3 * outline.length);
  outline.forEach((v, i) => {
    const [x, y] = follow(weights, v, by);
    ends.set(toPlane([texcoords[2 * v] + x, texcoords[2 * v + 1] + y]), 3 * i);
  });
  return ends;
}

/** Adds what bends the chart to `vPlace`; `bend` is how far the pin was dragged in the plane. */
export const BEND_GLSL = /* glsl */ `
  uniform vec2 bend;
  attribute vec2 weight;
  vec2 bent() {
    return vec2(weight.x * bend.x - weight.y * bend.y, weight.y * bend.x + weight.x * bend.y);
  }
`;
