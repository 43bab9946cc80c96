import type { FlattenOptionValues } from './generated.js';

/** A triangle mesh as arrays. `positions`: xyz per vertex. `indices`: 3 vertices per triangle, counter-clockwise. */
export interface MeshArrays {
  positions: Float32Array | Float64Array;
  indices: Uint32Array | Uint16Array;
}

/** The bytes of an OBJ or OFF file. `name` is used to tell the format and in messages. */
export interface MeshFile {
  bytes: Uint8Array | ArrayBuffer;
  name?: string;
}

export type MeshInput = MeshArrays | MeshFile;

export interface Progress {
  stage: 'read' | 'connectivity' | 'solve' | 'layout' | 'check' | 'write';
  /** 0 outside the solve stage. */
  newtonStep: number;
  constraintResidual: number;
  /** Rough share of the work done, 0..1. */
  fraction: number;
}

export interface CallOptions {
  /** Aborting rejects with a DOMException named AbortError; the next call works. */
  signal?: AbortSignal;
  /** Move the whole input buffers to the worker instead of copying them (they are detached by the call). */
  transfer?: boolean;
}

/** A bound of t*pi for the interior angle of the layout at one boundary vertex of the input. */
export interface VertexBound {
  vertex: number;
  t: number;
}

/** The plain values are described, with their defaults, by FLATTEN_OPTIONS. */
export interface FlattenOptions extends CallOptions, Partial<FlattenOptionValues> {
  /** Bounds of single boundary vertices, in place of the common t. */
  bounds?: VertexBound[];
  onProgress?: (progress: Progress) => void;
  /** Also return the input as OBJ text with the new texcoords. */
  obj?: boolean;
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

export interface ChartReport {
  faces: number;
  boundaryVertices: number;
  /** The largest bound used: 2 and above is a free boundary. */
  t: number;
  /** Boundary vertices with a bound below t. */
  bounds: VertexBound[];
  /** `activeSet`, `interiorPoint` or `tutte`. */
  solver: string;
  linearSolver: string;
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
  /** What was done beyond the plain solver, one sentence each. */
  fallbacks: string[];
  /** Why the chart is not valid, one sentence; empty when it is. */
  problem: string;
  valid: boolean;
}

/** The same report as the command line writes. Seconds in `timings`. */
export interface Report {
  version: string;
  input: {
    path: string;
    vertices: number;
    faces: number;
    triangles: number;
    components: number;
    boundaryLoops: number;
    boundaryEdges: number;
    genus: number;
  };
  /** As asked. */
  options: FlattenOptionValues;
  charts: ChartReport[];
  valid: boolean;
  timings: {
    read: number;
    connectivity: number;
    solve: number;
    layout: number;
    check: number;
    write: number;
    total: number;
  };
}

export interface FlattenResult {
  /** 2 per output vertex, in the unit of the input (the layout has the area of the 3D surface). */
  uv: Float64Array;
  /** 3 output vertices per triangle; polygons of a file are triangulated. */
  indices: Uint32Array;
  /** Input vertex of each output vertex: the identity for a plain disk without unused vertices. */
  vertexMap: Uint32Array;
  /** 3 per output vertex, only for file input (arrays know their own positions through vertexMap). */
  positions?: Float64Array;
  /** OBJ text (UTF-8) when asked for with `obj: true`. */
  obj?: Uint8Array;
  report: Report;
}

/** What a mesh is; `disk.ok` tells whether `flatten` accepts it, `disk.message` why not. */
export interface MeshSummary {
  path: string;
  vertices: number;
  unreferencedVertices: number;
  faces: number;
  triangles: number;
  components: number;
  boundaryLoops: number;
  boundaryEdges: number;
  nonManifoldEdges: number;
  orientationConflicts: number;
  degenerateFaces: number;
  eulerCharacteristic: number;
  genus: number;
  disk: { ok: boolean; code: string; message: string };
}

export interface SampleOptions {
  signal?: AbortSignal;
  /** At least 1, the default; the number of faces grows about linearly with it. */
  detail?: number;
}

/** Positions: 3 per vertex. Indices: 3 per triangle. */
export interface TriangleMesh {
  positions: Float64Array;
  indices: Uint32Array;
}

/** A worker that takes one call after the other, in the order they were made. */
export interface Abflat {
  flatten(mesh: MeshInput, options?: FlattenOptions): Promise<FlattenResult>;
  inspect(mesh: MeshInput, options?: CallOptions): Promise<MeshSummary>;
  /** The triangles of an OBJ or OFF file, to show it even if it is not a disk. */
  load(file: MeshFile, options?: CallOptions): Promise<TriangleMesh>;
  /** A mesh generated by abflat; for names see SAMPLE_NAMES. */
  sample(name: string, options?: SampleOptions): Promise<TriangleMesh>;
  /** Ends the worker; calls that are not finished, and later ones, reject with AbortError. */
  terminate(): void;
}

export interface CreateOptions {
  /** Most bytes that the worker may use for a mesh: 16 MB to 4 GB, the default. */
  maxMemory?: number;
  /** Where abflat.wasm is, when it is not beside the module; in Node a path is fine as well. */
  wasmUrl?: string | URL;
  /** Where the worker's script is, when it is not beside the module. */
  workerUrl?: string | URL;
}
