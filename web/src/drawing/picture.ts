import type { ChartReport } from 'abflat';
import { chartColors } from '../colors/chart-colors';
import { type ChartAreas, chartAreas } from '../mesh/chart-areas';
import {
  areasOf,
  boundaryEdges,
  type DisplayMesh,
  type FlatMesh,
  type TriangleAreas,
  vertexNormals,
} from '../mesh/mesh';
import { edgesOfOne, weldInCharts } from '../mesh/outline-edges';
import { pick, positionsOf } from '../mesh/positions-of';
import { meshCorners } from '../mesh/source-corners';
import { toUnitSquare } from '../mesh/unit-square';
import { weld } from '../mesh/weld';
import type { FaceDensities } from '../model/face-densities';
import type { LayoutArrays, Unwrapped } from '../model/model';
import { type Heat, heatOf } from './heat';

/** A mesh with its boundary, as the 3D view shows it before it is flattened. */
export interface Picture {
  mesh: DisplayMesh;
  /** Boundary edges, or for an atlas those of its charts, as pairs of vertices. */
  edges: Uint32Array;
  /** Per vertex, if they differ from those of the triangles. */
  normals?: Float32Array;
}

/** A layout with everything that is marked in it. */
export interface FlatPicture extends Picture {
  mesh: FlatMesh;
  sizes: TriangleAreas;
  heat: Heat;
  /** Vertices with a tightened bound. */
  tightened: Uint32Array;
  /** The vertex of the input at the beginning of each boundary edge; only for a disk. */
  boundary?: Uint32Array;
  /** Edges that cannot be made Delaunay, as pairs of vertices. */
  resisting: Uint32Array;
  /** For an atlas of charts in the unit square, the number of each chart's colour. */
  chartColors?: Float32Array;
  /** For an atlas, the chart of each triangle. */
  charts?: Uint32Array;
  areas?: ChartAreas;
  /** Unit squares that the atlas fills. */
  tiles?: number;
  /** See `TriangleMarks`. */
  source?: Float32Array;
  /** Per triangle, bits of what is wrong with it in uv and is to be marked. */
  faults?: Uint8Array;
  /** The layout is that of the file, which may be anywhere and have no uv for some triangles. */
  isOfFile?: boolean;
}

/** Vertices at the same point count as one, so the boundary is that of the surface. */
export function meshPicture(mesh: DisplayMesh): Picture {
  return { mesh, edges: edgesOfOne(mesh.indices, weld(mesh.positions, 3)) };
}

/** The parts of an unwrapped mesh that are drawn. */
export type AtlasArrays = Pick<
  Unwrapped['result'],
  'uv' | 'indices' | 'vertexMap' | 'positions' | 'chartOfTriangle'
> &
  Pick<FlatPicture, 'faults'>;

export interface AtlasSize extends Pick<FlatPicture, 'isOfFile'> {
  tiles: number;
  /** Texels along a side of a tile. */
  resolution: number;
  chartCount: number;
  /** The number of each chart's colour, if it has one already; -1 for others. */
  colors?: Float32Array;
  /** The texel density that each face asks for, relative to the others. */
  asked?: FaceDensities;
}

export function atlasPicture(
  atlas: AtlasArrays,
  { tiles, resolution, chartCount, colors, asked, isOfFile }: AtlasSize,
  input: DisplayMesh,
): FlatPicture {
  const { uv, indices, vertexMap, chartOfTriangle, faults } = atlas;
  const positions = positionsOf(atlas, input);
  const mesh = { positions, indices, uv };
  const sizes = areasOf(mesh);
  const none = new Uint32Array();
  const edges = edgesOfOne(
    isOfFile ? cornersOfCharts(indices, chartOfTriangle, chartCount) : indices,
    weldInCharts(atlas),
  );
  const places = weld(positions, 3);
  return {
    mesh,
    sizes,
    edges,
    // The surface is smooth across seams.
    normals: pick(vertexNormals(input), 3, vertexMap),
    heat: heatOf(mesh, chartOfTriangle, sizes, resolution),
    tightened: none,
    resisting: none,
    charts: chartOfTriangle,
    areas: chartAreas(sizes, chartOfTriangle, chartCount, { asked, faces: input.faces }),
    tiles,
    ...(faults && { faults }),
    ...(isOfFile && { isOfFile }),
    source: meshCorners(input, atlas),
    chartColors: chartColors({ indices, chartOfTriangle, chartCount, edges, places, uv }, colors),
  };
}

/** Those of triangles that have a chart. */
export const cornersOfCharts = (indices: Uint32Array, charts: Uint32Array, chartCount: number) =>
  indices.filter((_, c) => charts[Math.floor(c / 3)] < chartCount);

/** The part of a report that is about vertices and edges. */
export type MarkedChart = Pick<ChartReport, 'bounds' | 'delaunay'>;

/** `input` has the positions if the layout comes without; without a `chart`, nothing is marked. */
export function flatPicture(
  layout: LayoutArrays,
  input: DisplayMesh,
  chart: MarkedChart | null,
): FlatPicture {
  const { indices, vertexMap } = layout;
  const positions = positionsOf(layout, input);
  // Another method has the size of the mesh; as a result has it, pictures lie on both alike.
  const uv = chart ? layout.uv : toUnitSquare(layout.uv, indices);
  const mesh = { positions, indices, uv };
  const edges = boundaryEdges(indices);
  const boundary = Uint32Array.from(
    { length: edges.length / 2 },
    (_, e) => vertexMap[edges[2 * e]],
  );
  const bounded = new Set(chart?.bounds.map(({ vertex }) => vertex));
  // Each boundary vertex begins one boundary edge.
  const tightened = edges.filter((v, i) => i % 2 === 0 && bounded.has(vertexMap[v]));
  const resisting = edgesOf(layout, chart?.delaunay?.resisting ?? []);
  const source = meshCorners(input, layout);
  const sizes = areasOf(mesh);
  const heat = heatOf(mesh, undefined, sizes);
  return { mesh, sizes, edges, heat, tightened, boundary, resisting, source };
}

/**
 * Edges of the layout, as pairs of its vertices, for the edges in `asked`, given by vertices of the
 * input.
 */
function edgesOf({ indices, vertexMap }: LayoutArrays, asked: [number, number][]): Uint32Array {
  const key = (a: number, b: number) => `${Math.min(a, b)} ${Math.max(a, b)}`;
  const left = new Set(asked.map(([a, b]) => key(a, b)));
  const found: number[] = [];
  for (let h = 0; left.size > 0 && h < indices.length; ++h) {
    const a = indices[h];
    const b = indices[h % 3 === 2 ? h - 2 : h + 1];
    if (left.delete(key(vertexMap[a], vertexMap[b]))) found.push(a, b);
  }
  return Uint32Array.from(found);
}
