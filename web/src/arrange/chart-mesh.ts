import { boundaryEdges } from '../mesh/mesh';
import { type ChartArrays, pointOf, trianglesOf } from './charts';
import type { Point } from './motion';

/** One chart as a mesh of its own, with its layout. */
export interface ChartMesh {
  positions: Float64Array;
  indices: Uint32Array;
  texcoords: Float64Array;
  /** The number in the atlas of each of its vertices. */
  vertices: Uint32Array;
  /** The corner of the atlas that each of `indices` belongs to. */
  corners: Uint32Array;
  /** Its boundary edges, two of its vertices each. */
  outline: Uint32Array;
}

/** One for each of some charts. `positions`: 3 per vertex of the atlas. */
export function chartMeshes(
  arrays: ChartArrays,
  positions: Float64Array,
  charts: Uint32Array,
): ChartMesh[] {
  const triangles = trianglesOf(arrays.chartOfTriangle, charts);
  /** From 1; 0 for vertices that have not been seen. No vertex belongs to two charts. */
  const numbers = new Uint32Array(arrays.uv.length / 2);
  return Array.from(charts, (chart) =>
    chartMesh(arrays, positions, triangles.get(chart) ?? [], numbers),
  );
}

function chartMesh(
  { uv, indices }: ChartArrays,
  positions: Float64Array,
  triangles: number[],
  numbers: Uint32Array,
): ChartMesh {
  const corners = triangles.flatMap((f) => [3 * f, 3 * f + 1, 3 * f + 2]);
  const found: number[] = [];
  const own = Uint32Array.from(corners, (corner) => {
    const v = indices[corner];
    numbers[v] ||= found.push(v);
    return numbers[v] - 1;
  });
  const vertices = Uint32Array.from(found);
  const texcoords = new Float64Array(2 * vertices.length);
  const places = new Float64Array(3 * vertices.length);
  vertices.forEach((v, i) => {
    texcoords.set(pointOf(uv, v), 2 * i);
    places.set(positions.subarray(3 * v, 3 * v + 3), 3 * i);
  });
  return {
    positions: places,
    indices: own,
    texcoords,
    vertices,
    corners: Uint32Array.from(corners),
    outline: boundaryEdges(own),
  };
}

/** How far a vertex with this weight goes when the pin is dragged: both are complex numbers. */
export const follow = (weights: ArrayLike<number>, v: number, [x, y]: Point): Point => {
  const [a, b] = pointOf(weights, v);
  return [a * x - b * y, b * x + a * y];
};

/** An atlas before and after packing. */
export type Coordinates = Record<'uv' | 'unpacked', Float64Array>;

/** The coordinates with one chart bent from where it is now. */
export function bent(
  before: Coordinates,
  mesh: ChartMesh,
  weights: Float64Array,
  by: Point,
): Coordinates {
  const own = new Float64Array(mesh.texcoords.length);
  mesh.vertices.forEach((v, i) => {
    const [x, y] = follow(weights, i, by);
    own[2 * i] = before.uv[2 * v] + x;
    own[2 * i + 1] = before.uv[2 * v + 1] + y;
  });
  return reshaped(before, mesh, own);
}

/**
 * The coordinates with other ones for one chart, in single precision, as files and graphics cards hold them.
 * Unpacked, it keeps the area of its surface.
 */
export function reshaped(
  { uv, unpacked }: Coordinates,
  mesh: ChartMesh,
  shape: Float64Array,
): Coordinates {
  const changed = { uv: uv.slice(), unpacked: unpacked.slice() };
  reshape(changed, mesh, shape);
  return changed;
}

/** The same in place. */
export function reshape(changed: Coordinates, mesh: ChartMesh, shape: Float64Array): void {
  const own = shape.map(Math.fround);
  const { positions, indices } = mesh;
  const scale = Math.sqrt(areaOf(positions, 3, indices) / areaInUv(own, indices));
  mesh.vertices.forEach((v, i) => {
    for (const d of [0, 1]) {
      changed.uv[2 * v + d] = own[2 * i + d];
      changed.unpacked[2 * v + d] = scale * own[2 * i + d];
    }
  });
}

export const areaInUv = (uv: Float64Array, indices: Uint32Array) => areaOf(uv, 2, indices);

/** Of all triangles, whichever way they are turned. */
function areaOf(points: Float64Array, size: 2 | 3, indices: Uint32Array): number {
  const from = [0, 0, 0];
  const along = (to: number, d: number) => (d < size ? points[to + d] - from[d] : 0);
  let sum = 0;
  for (let c = 0; c < indices.length; c += 3) {
    const [q, r] = [size * indices[c + 1], size * indices[c + 2]];
    for (let d = 0; d < size; ++d) from[d] = points[size * indices[c] + d];
    const x = along(q, 1) * along(r, 2) - along(q, 2) * along(r, 1);
    const y = along(q, 2) * along(r, 0) - along(q, 0) * along(r, 2);
    const z = along(q, 0) * along(r, 1) - along(q, 1) * along(r, 0);
    sum += Math.hypot(x, y, z) / 2;
  }
  return sum;
}
