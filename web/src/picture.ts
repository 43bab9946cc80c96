import type { ChartReport } from 'abflat';
import { angleErrors } from './angle-error';
import { chartColors } from './chart-colors';
import type { Flattened, Outcome, Unwrapped } from './lay-out';
import type { DisplayMesh, FlatMesh } from './mesh';
import { boundaryEdges, vertexNormals } from './mesh';
import { weld } from './weld';

/** A mesh with its boundary, as the 3D view shows it before it is flattened. */
export interface Picture {
  mesh: DisplayMesh;
  /** Boundary edges, of an atlas those of its charts, as pairs of vertices. */
  edges: Uint32Array;
  /** Per vertex, where they are not those of the triangles. */
  normals?: Float32Array;
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
  /** The number of each triangle's colour when it is an atlas of charts in the unit square. */
  chartColors?: Float32Array;
  /** The chart of each triangle of an atlas. */
  charts?: Uint32Array;
  /** Unit squares that the atlas fills. */
  tiles?: number;
}

/** The arrays of a result, as abflat gives them. */
interface Layout {
  uv: Float64Array;
  indices: Uint32Array;
  vertexMap: Uint32Array;
  positions?: Float64Array;
}

/** Vertices at one place are one: the boundary is that of the surface. */
export function meshPicture(mesh: DisplayMesh): Picture {
  return { mesh, edges: edgesOfOne(mesh.indices, weld(mesh.positions, 3)) };
}

export function outcomePicture(outcome: Outcome): FlatPicture {
  return outcome.mode === 'unwrap' ? atlasPicture(outcome) : diskPicture(outcome);
}

function diskPicture({ result, mesh }: Flattened): FlatPicture {
  return flatPicture(result, mesh, result.report.charts[0]);
}

function atlasPicture({ result, mesh: input }: Unwrapped): FlatPicture {
  const { uv, indices, vertexMap, chartOfTriangle } = result;
  const positions = result.positions ?? pick(input.positions, 3, vertexMap);
  const mesh = { positions, indices, uv };
  const none = new Uint32Array();
  return {
    mesh,
    edges: edgesOfOne(indices, weld(uv, 2)),
    // A seam is no edge of the surface.
    normals: pick(vertexNormals(input), 3, vertexMap),
    errors: angleErrors(mesh),
    tightened: none,
    resisting: none,
    charts: chartOfTriangle,
    tiles: result.report.atlas.tiles,
    chartColors: chartColors(indices, chartOfTriangle, weld(positions, 3)),
  };
}

/** The number of each chart's colour. */
export function colorOfCharts(
  { charts, chartColors }: FlatPicture,
  chartCount: number,
): Float32Array {
  const colors = new Float32Array(chartCount);
  charts?.forEach((chart, f) => {
    if (chart < chartCount) colors[chart] = chartColors?.[f] ?? 0;
  });
  return colors;
}

/** Boundary edges where some vertices are one: `same` names the one for each. */
function edgesOfOne(indices: Uint32Array, same: Uint32Array): Uint32Array {
  const joined = new Uint32Array(indices.length);
  let size = 0;
  for (let c = 0; c < indices.length; c += 3) {
    const [i, j, k] = [same[indices[c]], same[indices[c + 1]], same[indices[c + 2]]];
    if (i === j || j === k || k === i) continue; // no area, no edges
    joined[size++] = i;
    joined[size++] = j;
    joined[size++] = k;
  }
  return boundaryEdges(joined.subarray(0, size));
}

/** `input` has the positions when the layout comes without; without a `chart` nothing is marked. */
export function flatPicture(
  layout: Layout,
  input: DisplayMesh,
  chart: ChartReport | null,
): FlatPicture {
  const { uv, indices, vertexMap } = layout;
  const positions = layout.positions ?? pick(input.positions, 3, vertexMap);
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

/** The rows of `size` numbers that `rows` names. */
function pick<T extends Float64Array | Float32Array>(
  values: T,
  size: number,
  rows: Uint32Array,
): T {
  const Kind = values.constructor as new (length: number) => T;
  const picked = new Kind(size * rows.length);
  rows.forEach((row, i) => {
    picked.set(values.subarray(size * row, size * row + size), size * i);
  });
  return picked;
}
