import type { ChartReport } from 'abflat';
import { angleErrors } from './angle-error';
import type { DisplayMesh, FlatMesh } from './mesh';
import { boundaryEdges } from './mesh';
import type { Outcome } from './session';

/** A mesh with its boundary, as the 3D view shows it before it is flattened. */
export interface Picture {
  mesh: DisplayMesh;
  /** Boundary edges as pairs of vertices. */
  edges: Uint32Array;
}

/** A layout with all that is marked in it. */
export interface FlatPicture extends Picture {
  mesh: FlatMesh;
  /** Per triangle. */
  errors: Float32Array;
  /** Vertices with a tightened bound. */
  tightened: Uint32Array;
  /** Edges that cannot be made Delaunay, as pairs of vertices. */
  resisting: Uint32Array;
}

/** The arrays of a result, as abflat gives them. */
interface Layout {
  uv: Float64Array;
  indices: Uint32Array;
  vertexMap: Uint32Array;
  positions?: Float64Array;
}

export function meshPicture(mesh: DisplayMesh): Picture {
  return { mesh, edges: boundaryEdges(mesh.indices) };
}

export function outcomePicture({ result, mesh }: Outcome): FlatPicture {
  return flatPicture(result, mesh, result.report.charts[0]);
}

/** `input` has the positions when the layout comes without; without a `chart` nothing is marked. */
export function flatPicture(
  layout: Layout,
  input: DisplayMesh,
  chart: ChartReport | null,
): FlatPicture {
  const { uv, indices, vertexMap } = layout;
  const positions = layout.positions ?? pick(input.positions, vertexMap);
  const mesh = { positions, indices, uv };
  const edges = boundaryEdges(indices);
  const bounded = new Set(chart?.bounds.map(({ vertex }) => vertex));
  // Each boundary vertex begins one boundary edge.
  const tightened = edges.filter((v, i) => i % 2 === 0 && bounded.has(vertexMap[v]));
  const resisting = edgesOf(layout, chart?.delaunay?.resisting ?? []);
  return { mesh, edges, errors: angleErrors(mesh), tightened, resisting };
}

/** Edges of the layout, as pairs of its vertices, that are `asked` for by vertices of the input. */
function edgesOf({ indices, vertexMap }: Layout, asked: [number, number][]): Uint32Array {
  const key = (a: number, b: number) => `${Math.min(a, b)} ${Math.max(a, b)}`;
  const left = new Set(asked.map(([a, b]) => key(a, b)));
  const found: number[] = [];
  for (let h = 0; left.size > 0 && h < indices.length; ++h) {
    const [a, b] = [indices[h], indices[h % 3 === 2 ? h - 2 : h + 1]];
    if (left.delete(key(vertexMap[a], vertexMap[b]))) found.push(a, b);
  }
  return Uint32Array.from(found);
}

function pick(positions: Float64Array, vertexMap: Uint32Array): Float64Array {
  const picked = new Float64Array(3 * vertexMap.length);
  vertexMap.forEach((v, i) => {
    picked.set(positions.subarray(3 * v, 3 * v + 3), 3 * i);
  });
  return picked;
}
