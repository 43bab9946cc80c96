// `unwrap`: an atlas of any mesh.

import type { Solver, UnwrapOptionValues, UnwrapStage } from '../generated.js';
import type { RefineReport } from './flatten.js';
import type {
  Layout,
  LayoutOptions,
  LayoutTimings,
  PinReport,
  Progress,
  StraightReport,
} from './layout.js';
import type { InputSummary } from './mesh.js';

/** `stage` and `fraction` tell where the run is; numbers of Newton's method are 0. */
export interface UnwrapProgress extends Omit<Progress, 'stage'> {
  stage: UnwrapStage;
}

/** What an earlier call gave for the same mesh: its result, or this much of it. */
export interface KnownLayout {
  unpacked: Float64Array;
  /** Only `fixedCharts` need it. */
  uv?: Float64Array;
  indices: Uint32Array;
  vertexMap: Uint32Array;
  chartOfTriangle: Uint32Array;
  report: {
    options: Pick<UnwrapOptionValues, 't' | 'straightSeams'> &
      Partial<Pick<UnwrapOptionValues, 'balance'>>;
  };
}

/** The plain values are described, with their defaults, by UNWRAP_OPTIONS. */
export interface UnwrapOptions extends LayoutOptions, Partial<UnwrapOptionValues> {
  /** Where to cut: `auto` (the default), `uv`, `material`, `none`, `sharp=DEGREES`, or `auto,sharp=60`. */
  seams?: string;
  /** Edges to cut beside those, two vertices of the input each. */
  seamEdges?: Uint32Array;
  /** Faces of the input whose uv islands stay exactly as they are, `'uv'`: all that have coordinates; all others are packed around them. */
  fixedFaces?: Uint32Array | 'uv';
  /** Charts of `known` that stay exactly where they are; all others are packed around them. */
  fixedCharts?: Uint32Array;
  /** Charts that have the triangles and the outline of one of these, and the same `t`, `balance` and `straightSeams`, are not flattened again. */
  known?: KnownLayout;
  onProgress?: (progress: UnwrapProgress) => void;
}

/** What was done to see the surface in the mesh, which itself keeps all of it. Faces and vertices are those of the input. */
export interface RepairReport {
  /** At the place of another vertex: one vertex of the surface. */
  mergedVertices: number;
  /** Fewer than three places. */
  collapsedFaces: number[];
  /** Touch themselves: split there. */
  splitFaces: number[];
  /** Have the places of an earlier face, the second number: charts of their own. */
  duplicateFaces: [number, number][];
  /** Edges of more than two faces, which are cut. */
  nonManifoldEdges: [number, number][];
  /** Edges whose two faces run in the same direction, which are cut. */
  orientationConflicts: [number, number][];
  /** Of zero area. */
  degenerateTriangles: number;
}

/** Measures are as in ChartReport, at the chart's own scale. */
export interface UnwrapChart {
  /** Triangles. */
  faces: number;
  /** A face of the input that is in it. */
  firstFace: number;
  /** Of the outer boundary. */
  boundaryVertices: number;
  filledHoles: number;
  /** In 3D. */
  area: number;
  solver: Solver;
  /** Stays where it was. */
  fixed: boolean;
  iterations: number;
  angularDistortion: number;
  quasiConformal: { mean: number; max: number };
  symmetricDirichlet: number;
  /** Null where refining gained nothing, as with a balance of 0. */
  refined: RefineReport | null;
  /** Null without pins. */
  pins: PinReport | null;
  /** Null where nothing is to be straight. */
  straight: StraightReport | null;
  fallbacks: string[];
  /** Why the chart is not valid, one sentence; empty when it is. */
  problem: string;
  valid: boolean;
}

/** The same report as the command line writes. */
export interface UnwrapReport {
  version: string;
  input: InputSummary;
  /** As asked. */
  options: UnwrapOptionValues;
  threads: number;
  repair: RepairReport;
  seams: {
    edges: number;
    /** Length divided by the root of the surface's area. */
    relativeLength: number;
    /** -1 where the surface is cut because it is no manifold. */
    genus: number;
    /** Two for each handle. */
    handleLoops: number;
    /** Of these loops and of what else makes each component a disk, divided by the root of the area. */
    handleLength: number;
    /** Boundary loops in charts that no seam joins to the outer one. */
    filledHoles: number;
  };
  charts: UnwrapChart[];
  /** What was done otherwise than asked, one sentence each. */
  notes: string[];
  /** Means over all charts by 3D area. */
  angularDistortion: number;
  quasiConformalMean: number;
  symmetricDirichlet: number;
  atlas: {
    /** Texels along a side. */
    resolution: number;
    /** Texels. */
    padding: number;
    /** Unit squares, ten in a row: UDIM 1001 and on. */
    tiles: number;
    /** Share of the tiles that charts cover. */
    utilization: number;
    /** Texels per unit of length of the mesh. */
    texelDensity: number;
    /** Charts that were cut in two so that all are packed denser. */
    packingCuts: number;
    /** Length of these seams, over the root of the area. */
    packingCutLength: number;
    /** Without them; 0 where there are none. */
    uncutTexelDensity: number;
  };
  /** Every chart is valid and none overlap. */
  valid: boolean;
  timings: LayoutTimings & {
    surface: number;
    seams: number;
    solve: number;
    pack: number;
    check: number;
  };
  /** MB that were held at most by the end of each stage: of the module's heap, which never shrinks; natively of the process. */
  peakMemory: Record<UnwrapStage, number | null>;
}

/**
 * `uv` is in [0, 1], with `udim` in the square of a tile. Without `obj` its numbers are single precision ones, where the charts stay valid: copied to a
 * Float32Array they are what was checked. A vertex of the input is there once for every uv that it has. Triangles are in the
 * order of the input's faces, and a triangle mesh keeps all of them.
 */
export interface UnwrapResult extends Layout<UnwrapReport> {
  /** Index into report.charts of each triangle; 2^32 - 1 for one without area that nothing touches. */
  chartOfTriangle: Uint32Array;
  /** Edges that were cut, two vertices of the input each. */
  seams: Uint32Array;
  /** `uv` before packing, in double precision: every chart in the unit of the input, with the area that it has in 3D; NaN where it is fixed. */
  unpacked: Float64Array;
}
