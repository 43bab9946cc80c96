import type { Build } from './builds.js';
import type { FlattenOptionValues, UnwrapOptionValues } from './generated.js';

/** A triangle mesh as arrays. `positions`: xyz per vertex. `indices`: 3 vertices per triangle, counter-clockwise. */
export interface MeshArrays {
  positions: Float32Array | Float64Array;
  indices: Uint32Array | Uint16Array;
  /** The coordinates that it has, 2 per vertex, NaN for a vertex without: for `seams: 'uv'` and `fixedFaces`. */
  texcoords?: Float32Array | Float64Array;
  /** A number per triangle: for `seams: 'material'`. */
  materials?: Uint32Array | Uint16Array;
}

/** The bytes of an OBJ, PLY, STL or OFF file. `name` is used to tell the format and in messages. */
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

/** A place in the layout for a vertex of the input. */
export interface Pin {
  vertex: number;
  uv: readonly [number, number];
  /** A face that uses the vertex: tells which of its texcoords is meant where it lies on a seam. */
  face?: number;
}

/** What follows vertex `from` on the boundary, with the surface on the left, up to vertex `to`. */
export interface StraightRun {
  from: number;
  to: number;
}

export interface LayoutOptions extends CallOptions {
  /**
   * None, or two and more; in an atlas that of each chart, which then stays where its pins are. Two are met by moving,
   * turning and scaling the layout, more by the nearest one to the angles in the sense of least squares.
   */
  pins?: readonly Pin[];
  /** Also return the input as OBJ text with the new texcoords. */
  obj?: boolean;
  /** Also return the input as PLY with the new texcoords; the layout is rounded to single precision where it stays valid. */
  ply?: boolean;
}

/** The plain values are described, with their defaults, by FLATTEN_OPTIONS. */
export interface FlattenOptions extends LayoutOptions, Partial<FlattenOptionValues> {
  /** Bounds of single boundary vertices, in place of the common t. */
  bounds?: VertexBound[];
  /** Parts of the boundary that are straight in the layout, whatever t and the bounds say. */
  straight?: readonly StraightRun[];
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

/** What became of pins. */
export interface PinReport {
  count: number;
  /** Largest distance in uv from a pin to where the layout without pins, moved, turned and scaled to fit them, has it. */
  deviation: number;
}

/** What became of straight runs. */
export interface StraightReport {
  runs: number;
  /** Strictly inside of them, each with an angle of pi. */
  vertices: number;
  /** Vertices that could be straight but are not: no layout, or none without much distortion, has all of them. */
  released: number;
  /** Largest difference of an angle from pi, radians. */
  deviation: number;
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

/** Seconds; the stages between depend on the call. */
export interface LayoutTimings {
  read: number;
  write: number;
  total: number;
}

/** A count is null where the input is not known. */
export interface InputSummary {
  path: string;
  vertices: number;
  faces: number;
  triangles: number;
  components: number;
  boundaryLoops: number;
  boundaryEdges: number;
  genus: number;
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
  timings: LayoutTimings & { connectivity: number; solve: number; layout: number; check: number };
}

/** What every layout has; `R` is its report. */
export interface Layout<R> {
  /** 2 per output vertex. */
  uv: Float64Array;
  /** 3 output vertices per triangle; polygons of a file are triangulated. */
  indices: Uint32Array;
  /** Input vertex of each output vertex. */
  vertexMap: Uint32Array;
  /** 3 per output vertex, only for file input (arrays know their own positions through vertexMap). */
  positions?: Float64Array;
  /** OBJ text (UTF-8) when asked for with `obj: true`. */
  obj?: Uint8Array;
  /** PLY when asked for with `ply: true`: in the encoding of the input, binary where that is no PLY. */
  ply?: Uint8Array;
  report: R;
}

/**
 * `uv` is in the unit of the input: without pins the layout has the area of the 3D surface. `vertexMap` is the identity for a plain
 * disk without unused vertices.
 */
export type FlattenResult = Layout<Report>;

/** `stage` and `fraction` tell where the run is; numbers of Newton's method are 0. */
export interface UnwrapProgress extends Omit<Progress, 'stage'> {
  stage: 'read' | 'surface' | 'seams' | 'solve' | 'pack' | 'check' | 'write';
}

/** What an earlier call gave for the same mesh: its result, or this much of it. */
export interface KnownLayout {
  unpacked: Float64Array;
  indices: Uint32Array;
  vertexMap: Uint32Array;
  chartOfTriangle: Uint32Array;
  report: { options: Pick<UnwrapOptionValues, 't' | 'straightSeams'> };
}

/** The plain values are described, with their defaults, by UNWRAP_OPTIONS. */
export interface UnwrapOptions extends LayoutOptions, Partial<UnwrapOptionValues> {
  /** Where to cut: `auto` (the default), `uv`, `material`, `none`, `sharp=DEGREES`, or `auto,sharp=60`. */
  seams?: string;
  /** Edges to cut beside those, two vertices of the input each. */
  seamEdges?: Uint32Array;
  /** Faces of the input whose uv islands stay exactly as they are; all others are packed around them. */
  fixedFaces?: Uint32Array;
  /** Charts that have the triangles and the outline of one of these, and the same `t` and `straightSeams`, are not flattened again. */
  known?: KnownLayout;
  onProgress?: (progress: UnwrapProgress) => void;
}

/** What was done to see the surface in the mesh, which itself keeps all of it. Faces and vertices are those of the input. */
export interface RepairReport {
  /** At the place of another vertex: one vertex of the surface. */
  mergedVertices: number;
  /** Fewer than three places. */
  collapsedFaces: number[];
  /** Use a place twice. */
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
  /** As in ChartReport, or `known`: the layout is that of an earlier call, or `given`: that of the input. */
  solver: string;
  /** Stays where it was. */
  fixed: boolean;
  iterations: number;
  angularDistortion: number;
  quasiConformal: { mean: number; max: number };
  symmetricDirichlet: number;
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
    handleLoops: number;
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
  peakMemory: Record<
    'read' | 'surface' | 'seams' | 'solve' | 'pack' | 'check' | 'write',
    number | null
  >;
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
  /** That the file has. */
  texcoords: number;
  /** That faces have. */
  materials: number;
  disk: { ok: boolean; code: string; message: string };
}

/** `abflat*` are this package's own layouts, with t = auto, 1 and 2; the others are references from the literature. */
export type MethodKey =
  | 'abflatAuto'
  | 'abflatConvex'
  | 'abflatFree'
  | 'tutte'
  | 'meanValue'
  | 'harmonic'
  | 'lscm';

/** `stage` is the method at work; numbers of Newton's method are 0 for the references. */
export interface CompareProgress extends Omit<Progress, 'stage'> {
  stage: 'read' | MethodKey;
}

export interface CompareOptions extends CallOptions {
  onProgress?: (progress: CompareProgress) => void;
}

/** One method on the mesh. Measures are null where there is no layout, or where they are infinite. */
export interface MethodResult {
  method: MethodKey;
  /** For people: "LSCM, free boundary". */
  title: string;
  /** To lay out, check and measure, without reading and connectivity. */
  seconds: number;
  /** Mean over corners of ((x - alpha)/alpha)^2, x in uv and alpha in 3D. */
  angularDistortion: number | null;
  /** Mean over edges of (s L/l - 1)^2, L in uv, l in 3D, s = sum l / sum L. */
  lengthDistortion: number | null;
  /** Mean by 3D area of |log(uv area / 3D area)| at equal total area: 0 keeps all areas, log 2 = 0.69 is off by a factor of two. */
  areaDistortion: number | null;
  /** Extremes of uv area / 3D area at equal total area; negative where a triangle is flipped. */
  areaRatio: { min: number | null; max: number | null };
  /** Ratio of the singular values, mean by 3D area and maximum; 1 is conformal. */
  quasiConformal: { mean: number | null; max: number | null };
  /** Mean by 3D area, divided by 4; 1 is an isometry. */
  symmetricDirichlet: number | null;
  flippedTriangles: number;
  boundaryCrossings: number;
  /** No flipped triangle, no crossing, and the method converged. */
  valid: boolean;
  /** Why it is not valid or what went wrong, one sentence; empty when it is valid. */
  problem: string;
  /** 2 per output vertex as in FlattenResult, scaled to the area of the 3D surface; empty where there is no layout. */
  uv: Float64Array;
}

/** The same mesh flattened by every method, in a fixed order: the abflat layouts first. */
export interface Comparison {
  version: string;
  input: MeshSummary;
  methods: MethodResult[];
  /** 3 output vertices per triangle, the same for all methods. */
  indices: Uint32Array;
  /** Input vertex of each output vertex. */
  vertexMap: Uint32Array;
  /** 3 per output vertex, only for file input. */
  positions?: Float64Array;
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

/** `faces`: the face of the file that each triangle is of. */
export interface LoadedMesh extends TriangleMesh {
  faces: Uint32Array;
}

/** A worker that takes one call after the other, in the order they were made. */
export interface Abflat {
  /** Which build of the module runs. */
  readonly build: Build;
  flatten(mesh: MeshInput, options?: FlattenOptions): Promise<FlattenResult>;
  /** Cuts any mesh into charts, flattens them and packs them into the unit square. */
  unwrap(mesh: MeshInput, options?: UnwrapOptions): Promise<UnwrapResult>;
  /** The layouts of abflat beside those of well-known methods; fails where `flatten` would. */
  compare(mesh: MeshInput, options?: CompareOptions): Promise<Comparison>;
  inspect(mesh: MeshInput, options?: CallOptions): Promise<MeshSummary>;
  /** The triangles of an OBJ, PLY, STL or OFF file, to show it even if it is not a disk. */
  load(file: MeshFile, options?: CallOptions): Promise<LoadedMesh>;
  /** A mesh generated by abflat; for names see SAMPLE_NAMES. */
  sample(name: string, options?: SampleOptions): Promise<TriangleMesh>;
  /** Ends the worker; calls that are not finished, and later ones, reject with AbortError. */
  terminate(): void;
}

export interface CreateOptions {
  /** Which build of the module to use; without it the fastest that runs here. */
  build?: Build;
  /** Most bytes that the worker may use for a mesh: 16 MB to 4 GB, the default. */
  maxMemory?: number;
  /** Where abflat.wasm is, or that of another build, when it is not beside the module; in Node a path is fine as well. */
  wasmUrl?: string | URL;
  /** Where `worker.js` is, when it is not beside the module. It runs every build. */
  workerUrl?: string | URL;
}
