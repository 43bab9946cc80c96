// `flatten`: one layout of a disk.

import type { FlattenOptionValues, LinearSolver, Solver } from '../generated.js';
import type {
  Layout,
  LayoutOptions,
  LayoutTimings,
  PinReport,
  Progress,
  StraightReport,
} from './layout.js';
import type { InputSummary } from './mesh.js';

/** A bound of t*pi for the interior angle of the layout at one boundary vertex of the input. */
export interface VertexBound {
  vertex: number;
  t: number;
}

/** What follows vertex `from` on the boundary, with the surface on the left, up to vertex `to`. */
export interface StraightRun {
  from: number;
  to: number;
}

/** The plain values are described, with their defaults, by FLATTEN_OPTIONS. */
export interface FlattenOptions extends LayoutOptions, Partial<FlattenOptionValues> {
  /** Bounds of single boundary vertices, in place of the common t. */
  bounds?: VertexBound[];
  /** Parts of the boundary that are straight in the layout, whatever t and the bounds say. */
  straight?: readonly StraightRun[];
  /** Moves and scales the layout into [0, 1] x [0, 1], before it is checked. Not with `pins`. Default: false. */
  normalize?: boolean;
  onProgress?: (progress: Progress) => void;
}

export interface NewtonStep {
  objective: number;
  constraint: number;
  gradient: number;
  active: number;
  /** Interior edges held at the Delaunay limit. */
  activeEdges: number;
  step: number;
  /** Angles that made the step shorter and weigh more from now on. */
  reweighted: number;
  /** 0 with a direct solver. */
  linearIterations: number;
}

/** What became of the Delaunay condition. */
export interface DelaunayReport {
  /** Interior edges. */
  edges: number;
  /** Edges that were not Delaunay, by an exact in-circle test. */
  violatedBefore: number;
  /** The same of the result; 0: the layout is a Delaunay triangulation. */
  violated: number;
  angularDistortionBefore: number;
  /** Edges, as two vertices of the input, that stay violated when the condition is met as far as possible. */
  resisting: [number, number][];
}

/**
 * What refining for lengths did. Energies are means over the surface of
 * (1 - b) (s1/s2 + s2/s1) / 2 + b (s1^2 + s2^2 + s1^-2 + s2^-2) / 4 with b the balance, at the scale of least energy
 * unless pins give one: 1 at best.
 */
export interface RefineReport {
  /** Of the layout that the angles give. */
  energyBefore: number;
  energy: number;
  /** Of Newton's method. */
  steps: number;
  /** What stood in the way of less energy, one sentence; empty where nothing did. */
  limit: string;
}

export interface ChartReport {
  faces: number;
  boundaryVertices: number;
  /** The largest bound used: 2 and above is a free boundary. */
  t: number;
  /** Boundary vertices with a bound below t. */
  bounds: VertexBound[];
  solver: Solver;
  linearSolver: LinearSolver;
  formulation: string;
  iterations: number;
  history: NewtonStep[];
  constraintResidual: number;
  converged: boolean;
  angularDistortion: number;
  lengthDistortion: number;
  quasiConformal: { mean: number; max: number };
  stretch: { l2: number; linf: number };
  symmetricDirichlet: number;
  areaDistortion: { min: number; max: number };
  degenerateTriangles: number;
  flippedTriangles: number;
  boundaryCrossings: number;
  /** Radians. */
  maxBoundaryAngle: number;
  /** Null unless it was asked for. */
  delaunay: DelaunayReport | null;
  /** Null without a balance above 0, and of a layout that is not valid. */
  refined: RefineReport | null;
  /** Null without pins. */
  pins: PinReport | null;
  /** Null where nothing is to be straight. */
  straight: StraightReport | null;
  /** What was done beyond the plain solver, one sentence each. */
  fallbacks: string[];
  /** Why the chart is not valid, one sentence; empty when it is. */
  problem: string;
  valid: boolean;
}

/** The same report as the command line writes. */
export interface Report {
  version: string;
  input: InputSummary;
  /** As asked. */
  options: FlattenOptionValues;
  /** That the solver used. */
  threads: number;
  charts: ChartReport[];
  valid: boolean;
  timings: LayoutTimings & {
    connectivity: number;
    solve: number;
    layout: number;
    refine: number;
    check: number;
  };
}

/**
 * `uv` is in the unit of the input unless it is normalized: without pins the layout has the area of the 3D surface. `vertexMap` is the identity for a plain
 * disk without unused vertices.
 */
export type FlattenResult = Layout<Report>;
