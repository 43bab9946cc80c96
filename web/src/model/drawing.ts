// What the views draw: arrays that go to the graphics card as they are. They are made in the
// workshop, so that no loop over all triangles blocks the page.

import type { ChartAreas } from '../mesh/chart-areas';
import type { Cells } from '../mesh/checker';
import type { Measure, Spread } from './measures';

/** Per corner of each triangle. */
export interface TriangleMarks {
  /** A place on the colour ramp for each of MEASURES. */
  heat: Float32Array;
  /** Number of the chart's colour. */
  chart: Float32Array;
  /** Number of the chart itself. */
  piece: Float32Array;
  /** Number, from 1, of the same corner of the mesh as it was opened; absent if all are the same. */
  source?: Float32Array;
}

/** How a mesh first appears. */
export interface FirstView {
  /** Unit vector from the mesh to the eye. */
  front: [number, number, number];
  /** Points, xyz each: if they fit in a view from there, all of the mesh does. */
  outline: Float32Array;
  /** The same for any direction, approximately. */
  hull: Float32Array;
}

/**
 * Per chart: xyz of its box's lowest and highest corners, and the sums of its vector areas and of
 * its areas.
 */
export const FRAME = { size: 10, low: 0, high: 3, area: 6, total: 9 };
/** The same in the plane: u and v of the lowest and highest corners. */
export const FLAT_FRAME = { size: 4, low: 0, high: 2 };

export interface MeshDrawing {
  /** xyz per corner, in the unit sphere. */
  position: Float32Array;
  /** xyz per corner. */
  normal: Float32Array;
  /** In checker cells, 2 per corner; absent until the mesh is flattened. */
  uv?: Float32Array;
  /** Where those lie in uv. */
  cells?: Cells;
  /** Boundary edges, xyz of both ends. */
  edges: Float32Array;
  /** Tightened vertices, xyz each. */
  dots: Float32Array;
  /** Only for a mesh that was just opened. */
  first?: FirstView;
  /** `FRAME` per chart. */
  frames: Float32Array;
}

/** In a plane where the layout is centred on 0 and its longer side is 1; points have xyz. */
export interface LayoutDrawing {
  position: Float32Array;
  edges: Float32Array;
  /** Edges that cannot be made Delaunay. */
  resisting: Float32Array;
  dots: Float32Array;
  /** Crossings of the boundary. */
  rings: Float32Array;
  /** Sides of the tiles. */
  tileSides: Float32Array;
  tiles: number;
  size: [number, number];
  /** In uv: the point at 0, and the length of a unit. */
  middle: [number, number];
  unit: number;
  /** `FLAT_FRAME` per chart. */
  frames: Float32Array;
  /** The layout is that of a file. */
  isOfFile: boolean;
}

/** A mesh before it is flattened. */
export interface Drawing {
  mesh: MeshDrawing;
}

/** A mesh with its layout. */
export interface FlatDrawing extends Drawing {
  layout: LayoutDrawing;
  marks: TriangleMarks;
  /** The chart of each boundary edge of an atlas, in the order of `edges`. */
  edgeCharts: Uint32Array;
  /** The vertex of the mesh at the beginning of each boundary edge of a disk, in the order of `edges`. */
  boundary: Uint32Array;
  /** How each measure is spread over the surface. */
  spreads: Record<Measure, Spread>;
  /** The number of each chart's colour; null for a disk. */
  chartColors: Float32Array | null;
  /** Of each chart; null for a disk. */
  areas: ChartAreas | null;
}
