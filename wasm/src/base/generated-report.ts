// Generated from core/schema by scripts/generate.mjs, do not edit.

import type {
  ChartShape,
  FlattenOptionValues,
  LinearSolver,
  MethodKey,
  PackOptionValues,
  Solver,
  StatusName,
  UnwrapOptionValues,
  VerifyRule,
} from './generated.js';
import type { VerifyOptionValues } from './generated-verify.js';

/** A bound of t pi for one boundary vertex, in place of the common t; if a vertex has several, the last one counts. */
export interface VertexBound {
  /** Vertex of the input. */
  vertex: number;
  /** Its boundary control coefficient. */
  t: number;
}

/** One step of the solver. */
export interface NewtonStep {
  /** Sum of w (x - a)², with the weights w, the angles x and their targets a. */
  objective: number;
  /** Largest violation of any constraint; for wheels, of the logarithm, in radians. */
  constraint: number;
  /** Largest derivative of the Lagrangian, relative to the largest weight times angle. */
  gradient: number;
  /** Boundary vertices held at their bound. */
  active: number;
  /** Interior edges held at the Delaunay limit. */
  activeEdges: number;
  /** Step length, above 0 and at most 1, the full step. */
  step: number;
  /** Angles that a full step would take to 0 or π: they shorten the step and weigh more from then on. */
  reweighted: number;
  /** Iterations of the linear solver; 0 when it is direct. */
  linearIterations: number;
}

/** The outcome of the Delaunay condition (9). */
export interface DelaunayReport {
  /** Interior edges. */
  edges: number;
  /** Edges that were not Delaunay, by an exact in-circle test. */
  violatedBefore: number;
  /** Edges that are not Delaunay in the result; with 0 the layout is a Delaunay triangulation. */
  violated: number;
  /** Angular distortion without the condition. */
  angularDistortionBefore: number;
  /** Edges, as two vertices of the input, that stay violated when the condition is met as far as possible. */
  resisting: [number, number][];
}

/** The outcome of refining for lengths; energies are means over the surface of (1 - b)(σ₁/σ₂ + σ₂/σ₁)/2 + b(σ₁² + σ₂² + σ₁⁻² + σ₂⁻²)/4, where b is the balance and σ₁, σ₂ are the singular values of the map from the surface, at the scale of least energy unless pins give one: 1 at best. */
export interface RefineReport {
  /** Energy of the layout that the angles give. */
  energyBefore: number;
  /** Energy of the result. */
  energy: number;
  /** Steps of Newton's method. */
  steps: number;
  /** What prevented a lower energy, one sentence; empty if nothing did. */
  limit: string;
}

/** How the pins were met. */
export interface PinReport {
  /** Number of pins. */
  count: number;
  /** Largest distance in uv from a pin to its vertex in the layout without pins, once that layout is moved, rotated and scaled to fit them best; 0 for two pins. */
  deviation: number;
}

/** How straight the runs are. */
export interface StraightReport {
  /** Number of runs. */
  runs: number;
  /** Vertices strictly inside of them, each with an angle of π. */
  vertices: number;
  /** Vertices that were not held straight because no layout, or none without much distortion, has all of them straight. */
  released: number;
  /** Largest difference of such an angle from π in the layout, in radians. */
  deviation: number;
}

/** A chart of flatten. */
export interface ChartReport {
  /** Triangles of the chart. */
  faces: number;
  /** Vertices on its boundary. */
  boundaryVertices: number;
  /** The largest bound used; 2 and above is a free boundary. */
  t: number;
  /** Boundary vertices with a bound below t, as used. */
  bounds: VertexBound[];
  /** What made the layout. */
  solver: Solver;
  /** The linear solver that was used. */
  linearSolver: LinearSolver;
  /** The form of the wheel condition that was used. */
  formulation: 'log';
  /** Newton steps of the last solve. */
  iterations: number;
  /** These steps. */
  history: NewtonStep[];
  /** Largest violation of any constraint at the end. */
  constraintResidual: number;
  /** Whether the tolerances were met. */
  converged: boolean;
  /** Mean over corners of ((x - α)/α)², with x the angle in uv and α that in 3D. */
  angularDistortion: number;
  /** Mean over edges of (sL/l - 1)², with L the length in uv, l that in 3D and s = Σl/ΣL. */
  lengthDistortion: number;
  /** Ratio σ₁/σ₂ of the singular values of the map (1 = conformal). */
  quasiConformal: { mean: number; max: number; sheared: number };
  /** Stretch of Sander et al. 2001 at equal total area (1 = isometric). */
  stretch: { l2: number; linf: number };
  /** Mean by 3D area of (σ₁² + σ₂² + σ₁⁻² + σ₂⁻²)/4 (1 = isometric). */
  symmetricDirichlet: number;
  /** Ratio of uv area to 3D area at equal total area. */
  areaDistortion: { min: number; max: number };
  /** Triangles of zero area in 3D: their target angles are made up, and no distortion counts them. */
  degenerateTriangles: number;
  /** Triangles that are not positively oriented, by an exact predicate; 0 in a valid layout. */
  flippedTriangles: number;
  /** Pairs of boundary edges that cross or touch, by an exact predicate; 0 in a valid layout. */
  boundaryCrossings: number;
  /** Largest interior angle of the layout's boundary, in radians. */
  maxBoundaryAngle: number;
  /** The outcome of the Delaunay condition; null unless asked for. */
  delaunay: DelaunayReport | null;
  /** The outcome of refining for lengths; null unless a balance above 0 asks for it and the layout is valid. */
  refined: RefineReport | null;
  /** How the pins were met; null without pins. */
  pins: PinReport | null;
  /** How straight the runs are; null unless asked for. */
  straight: StraightReport | null;
  /** What was done beyond the plain solver, one sentence each. */
  fallbacks: string[];
  /** Why the chart is not valid, one sentence; empty when it is. */
  problem: string;
  /** Whether the chart is valid and the solver converged. */
  valid: boolean;
}

/** Seconds that each stage of flatten took. */
export interface Timings {
  /** Reading the input, in seconds. */
  read: number;
  /** Finding the surface and its boundary, in seconds. */
  connectivity: number;
  /** Flattening: the angles alone, or in unwrap all of it, in seconds. */
  solve: number;
  /** Turning angles into positions, in seconds. */
  layout: number;
  /** Trading angles for lengths, in seconds. */
  refine: number;
  /** Checking and measuring the result, in seconds. */
  check: number;
  /** Writing the result, in seconds. */
  write: number;
  /** The whole run, in seconds. */
  total: number;
}

/** Whether flatten accepts a mesh. */
export interface Verdict {
  /** Whether flatten accepts the mesh. */
  ok: boolean;
  /** Status code; `Ok` if it is accepted. */
  code: StatusName;
  /** Why it is not accepted, one sentence with counts and the first place; otherwise empty. */
  message: string;
}

/** What a mesh is, topologically. */
export interface MeshSummary {
  /** Name of the input. */
  path: string;
  /** Number of vertices. */
  vertices: number;
  /** Vertices that no face uses. */
  unreferencedVertices: number;
  /** Number of faces. */
  faces: number;
  /** Number of triangles, once polygons are triangulated. */
  triangles: number;
  /** Edge-connected components. */
  components: number;
  /** Number of boundary loops. */
  boundaryLoops: number;
  /** Number of boundary edges. */
  boundaryEdges: number;
  /** Edges with more than two faces. */
  nonManifoldEdges: number;
  /** Edges whose two faces run in the same direction. */
  orientationConflicts: number;
  /** Faces of zero area. */
  degenerateFaces: number;
  /** Vertices - edges + faces. */
  eulerCharacteristic: number;
  /** Sum over components; -1 if the surface is not manifold, or not oriented consistently. */
  genus: number;
  /** Texcoords of the file. */
  texcoords: number;
  /** Shading normals of the file; those of facets, as in STL, do not count. */
  normals: number;
  /** Smoothing groups that faces use, off among them; 0 if the file has normals. */
  smoothingGroups: number;
  /** Materials that faces use. */
  materials: number;
  /** Whether the mesh is one topological disk, which flatten accepts. */
  disk: Verdict;
}

/** What reports say about the input. */
export interface InputSummary {
  /** Name of the input. */
  path: string;
  /** Number of vertices. */
  vertices: number;
  /** Number of faces. */
  faces: number;
  /** Number of triangles, once polygons are triangulated. */
  triangles: number;
  /** Edge-connected components. */
  components: number;
  /** Number of boundary loops. */
  boundaryLoops: number;
  /** Number of boundary edges. */
  boundaryEdges: number;
  /** Sum over components; -1 if the surface is not manifold, or not oriented consistently. */
  genus: number;
}

/** The report of flatten. */
export interface Report {
  /** Version of abflat. */
  version: string;
  /** The input. */
  input: InputSummary;
  /** The options as asked. */
  options: FlattenOptionValues;
  /** Threads that the solver used. */
  threads: number;
  /** One entry per chart; a disk has one. */
  charts: ChartReport[];
  /** Whether every chart is valid and converged. */
  valid: boolean;
  /** Seconds that each stage took. */
  timings: Timings;
}

/** Repairs made to find the surface, for unwrapping only: the mesh itself is not changed; faces and vertices are those of the input. */
export interface RepairReport {
  /** Duplicate vertices, treated as one vertex of the surface. */
  mergedVertices: number;
  /** Faces without area, such as those with fewer than three distinct corners, and slivers whose short edge is too short to be seen; they get the uv of a face beside them. */
  collapsedFaces: number[];
  /** Faces that touch themselves or list a corner twice. */
  splitFaces: number[];
  /** Faces that repeat an earlier one, the second number; they become charts of their own. */
  duplicateFaces: [number, number][];
  /** Edges with more than two faces, by their vertices; all but the faces that continue each other were cut off. */
  nonManifoldEdges: [number, number][];
  /** Edges whose two faces run in the same direction, by their vertices; they were cut. */
  orientationConflicts: [number, number][];
  /** Faces that were turned to run like their neighbours (orient). */
  turnedFaces: number[];
  /** Triangles of zero area, whose angles are made up. */
  degenerateTriangles: number;
}

/** Where the surface was cut, beyond its boundary. */
export interface SeamSummary {
  /** Edges that were cut. */
  edges: number;
  /** Length of these edges, divided by the square root of the mesh's area. */
  relativeLength: number;
  /** Genus of the surface, summed over components; -1 if it was cut because it is not manifold. */
  genus: number;
  /** Loops cut to open handles, two per handle. */
  handleLoops: number;
  /** Length of these loops and of the other cuts that make each component a disk, divided by the square root of the area. */
  handleLength: number;
  /** Boundary loops in charts that no seam joins to the outer boundary. */
  filledHoles: number;
  /** Whether seams on the two sides of a plane mirror each other, as far as the mesh does. */
  symmetric: boolean;
}

/** A chart of unwrap; its measures are at the chart's own scale. */
export interface UnwrapChart {
  /** Triangles of the chart. */
  faces: number;
  /** A face of the input that is in it. */
  firstFace: number;
  /** Vertices of its outer boundary. */
  boundaryVertices: number;
  /** Holes that are treated as filled. */
  filledHoles: number;
  /** Area in 3D; null beyond the range of doubles. */
  area: number | null;
  /** What it looks like. */
  shape: ChartShape;
  /** What made the layout. */
  solver: Solver;
  /** Whether it stays where the input, an earlier run or pins put it. */
  fixed: boolean;
  /** The chart that it lies on, whose texels it shares; -1 if it has texels of its own. */
  stackedOn: number;
  /** Whether it lies there mirrored, so that its triangles run clockwise. */
  mirrored: boolean;
  /** Newton steps of the last solve. */
  iterations: number;
  /** Mean over corners of ((x - α)/α)², with x the angle in uv and α that in 3D. */
  angularDistortion: number;
  /** Ratio σ₁/σ₂ of the singular values of the map (1 = conformal). */
  quasiConformal: { mean: number; max: number; sheared: number };
  /** Mean by 3D area of (σ₁² + σ₂² + σ₁⁻² + σ₂⁻²)/4 (1 = isometric). */
  symmetricDirichlet: number;
  /** How many times as far above 1 as maxStretch its stretch may be: frontLeeway in the front of a figure, less where only a part is, more on a mask without a seam. */
  leeway: number;
  /** The outcome of refining for lengths; of the whole chart if packing has cut it; null if refining gained nothing. */
  refined: RefineReport | null;
  /** How the pins were met; null without pins. */
  pins: PinReport | null;
  /** How straight the runs are; null unless asked for. */
  straight: StraightReport | null;
  /** What was done beyond the plain solver, one sentence each. */
  fallbacks: string[];
  /** Why the chart is not valid, one sentence; empty when it is. */
  problem: string;
  /** Whether the chart is valid and the solver converged. */
  valid: boolean;
}

/** How the charts were packed. */
export interface AtlasReport {
  /** Texels along the longer side of a tile. */
  resolution: number;
  /** Texels of a tile from u = 0 to 1. */
  width: number;
  /** Texels of a tile from v = 0 to 1. */
  height: number;
  /** Texels between charts. */
  padding: number;
  /** Texels between charts and the edge of their tile. */
  margin: number;
  /** Unit squares, ten in a row: UDIM 1001 and on. */
  tiles: number;
  /** Share of the tiles that charts cover; what charts share counts once. */
  utilization: number;
  /** Charts that lie on others of the same shape (stack). */
  stacked: { charts: number; places: number; mirrored: number };
  /** Texels per mesh unit, for faces without a density of their own. */
  texelDensity: number;
  /** Charts that were cut in two so that all pack tighter. */
  packingCuts: number;
  /** Length of these cuts, divided by the square root of the area. */
  packingCutLength: number;
  /** Texel density without them; 0 if there are none. */
  uncutTexelDensity: number;
}

/** One number for each stage of unwrap. */
export interface UnwrapStages {
  /** Reading the input. */
  read: number;
  /** Finding the surface in the mesh. */
  surface: number;
  /** Choosing seams. */
  seams: number;
  /** Flattening: the angles alone, or in unwrap all of it. */
  solve: number;
  /** Packing the charts. */
  pack: number;
  /** Checking and measuring the result. */
  check: number;
  /** Writing the result. */
  write: number;
}

/** Seconds that each stage of unwrap took. */
export interface UnwrapTimings extends UnwrapStages {
  /** The whole run, in seconds. */
  total: number;
}

/** The report of unwrap. */
export interface UnwrapReport {
  /** Version of abflat. */
  version: string;
  /** The input. */
  input: InputSummary;
  /** The options as asked. */
  options: UnwrapOptionValues;
  /** Threads that the solver used. */
  threads: number;
  /** Repairs made to find the surface. */
  repair: RepairReport;
  /** Where the surface was cut. */
  seams: SeamSummary;
  /** One entry per chart. */
  charts: UnwrapChart[];
  /** Where the result differs from what was asked, and other remarks, one sentence each. */
  notes: string[];
  /** Angular distortion, the mean over all charts by 3D area. */
  angularDistortion: number;
  /** Quasi-conformal distortion σ₁/σ₂, the mean over all charts by 3D area. */
  quasiConformalMean: number;
  /** Share of the 3D area where σ₁/σ₂ exceeds 1.25. */
  sheared: number;
  /** Symmetric Dirichlet energy / 4, the mean over all charts by 3D area, each chart at its own scale. */
  symmetricDirichlet: number;
  /** How the charts were packed. */
  atlas: AtlasReport;
  /** Whether every chart is valid and none overlap. */
  valid: boolean;
  /** Seconds that each stage took. */
  timings: UnwrapTimings;
  /** Peak memory in MB by the end of each stage: natively of the process, in the package of the module's heap, which never shrinks, in MB. */
  peakMemory: Record<keyof UnwrapStages, number | null>;
}

/** Seconds that each stage of pack took. */
export interface PackTimings {
  /** Reading the input, in seconds. */
  read: number;
  /** Packing the charts, in seconds. */
  pack: number;
  /** Checking and measuring the result, in seconds. */
  check: number;
  /** Writing the result, in seconds. */
  write: number;
  /** The whole run, in seconds. */
  total: number;
}

/** The report of pack. */
export interface PackReport {
  /** Version of abflat. */
  version: string;
  /** The input. */
  input: InputSummary;
  /** The options as asked. */
  options: PackOptionValues;
  /** Threads that the solver used. */
  threads: number;
  /** Uv islands: faces joined where they have an edge and its texcoords in common. */
  islands: number;
  /** Islands that lay on others, by half of the smaller one or more, and still do. */
  stacked: { islands: number; stacks: number };
  /** Islands most of whose area runs clockwise; they stay mirrored. */
  mirrored: number;
  /** Islands that overlapped others by less, or ones of other materials, and no longer do. */
  separated: number;
  /** Faces without texcoords at every corner, which stay as they are. */
  unmapped: number;
  /** Faces of islands as they lie now, decided exactly; one may be counted for several reasons. */
  faces: { overlapping: number; flipped: number; empty: number; outside: number };
  /** Length in uv divided by what it was before; the mean by area, where islands differ. */
  scale: number;
  /** Share of their tiles that islands covered in the input, or of all tiles around the layout if one is larger than a tile; what a stack covers counts once. */
  utilizationBefore: number;
  /** Share of the tiles that they cover now. */
  utilization: number;
  /** Texels along the longer side of a tile. */
  resolution: number;
  /** Texels of a tile from u = 0 to 1. */
  width: number;
  /** Texels of a tile from v = 0 to 1. */
  height: number;
  /** Texels between islands. */
  padding: number;
  /** Texels between islands and the edge of their tile. */
  margin: number;
  /** Unit squares, ten in a row: UDIM 1001 and on. */
  tiles: number;
  /** Texels per mesh unit, the mean by area; 0 if the faces have no area. */
  texelDensity: number;
  /** Remarks about the input and the result, one sentence each; why a layout is not valid comes last. */
  notes: string[];
  /** Whether no two islands overlap that did not lie on each other, and each lies in a tile. */
  valid: boolean;
  /** Seconds that each stage took. */
  timings: PackTimings;
}

/** Something that a layout does not keep to. */
export interface VerifyFinding {
  /** What is asked. */
  rule: VerifyRule;
  /** What was found and where, one sentence. */
  message: string;
  /** Faces of the input where it was found: all, or the first hundred. */
  faces: number[];
  /** The islands of these. */
  islands: number[];
  /** What was measured; null where nothing is measured. */
  value: number | null;
  /** What it should be at least, or at most; null where nothing is measured. */
  limit: number | null;
}

/** Seconds that each stage of verify took. */
export interface VerifyTimings {
  /** Reading the input, in seconds. */
  read: number;
  /** Checking and measuring the result, in seconds. */
  check: number;
  /** The whole run, in seconds. */
  total: number;
}

/** The report of verify. */
export interface VerifyReport {
  /** Version of abflat. */
  version: string;
  /** The mesh that the program compares it with, empty if there is none. */
  against: string;
  /** The input. */
  input: InputSummary;
  /** The options as asked. */
  options: VerifyOptionValues;
  /** Uv islands: faces joined where they have an edge and its texcoords in common. */
  islands: number;
  /** Islands most of whose area runs clockwise. */
  mirrored: number;
  /** Faces without texcoords at every corner. */
  unmapped: number;
  /** Faces of islands, decided exactly on the numbers in the file; one may be counted for several reasons. */
  faces: { overlapping: number; flipped: number; empty: number; outside: number };
  /** Islands that overlap. */
  overlapping: { themselves: number; pairs: number; stacked: number };
  /** UDIM numbers of the tiles that islands are in, 1001 for u and v from 0 to 1. */
  tiles: number[];
  /** In texels; null if there is none. */
  distance: { islands: number | null; edge: number | null };
  /** Width of the narrowest island in texels, across the shorter side of its smallest box; null if there is none. */
  narrowest: number | null;
  /** Texels per mesh unit; null if no face has area. */
  texelDensity: { mean: number | null; min: number | null; max: number | null; ratio: number | null };
  /** Symmetric Dirichlet energy / 4, the mean over all islands by 3D area, each island at its own scale; faces without area in uv are left out; null if no face has area. */
  symmetricDirichlet: number | null;
  /** The same, of the island where it is largest; null if no face has area. */
  worstStretch: number | null;
  /** Ratio σ₁/σ₂ of the singular values of the map (1 = conformal); null if no face has area. */
  quasiConformal: { mean: number | null; max: number | null };
  /** Share of the tiles that islands cover; stacked ones count once, other overlaps twice. */
  utilization: number;
  /** What the layout does not keep to; of each rule all, or the first hundred. */
  findings: VerifyFinding[];
  /** Remarks about the input, one sentence each. */
  notes: string[];
  /** Whether nothing was found. */
  valid: boolean;
  /** Seconds that each stage took. */
  timings: VerifyTimings;
}

/** How one method flattens a mesh; measures are null without a layout, and where they are infinite. */
export interface MethodResult {
  /** The method. */
  method: MethodKey;
  /** Its display name, such as "LSCM, free". */
  title: string;
  /** Time to lay out, check and measure, without reading and connectivity, in seconds. */
  seconds: number;
  /** Mean over corners of ((x - α)/α)², with x the angle in uv and α that in 3D; null without a layout or where infinite. */
  angularDistortion: number | null;
  /** Mean over edges of (sL/l - 1)², with L the length in uv, l that in 3D and s = Σl/ΣL; null without a layout or where infinite. */
  lengthDistortion: number | null;
  /** Mean by 3D area of |log(uv area / 3D area)| at equal total area: 0 keeps all areas, log 2 = 0.69 is off by a factor of two; null without a layout or where infinite. */
  areaDistortion: number | null;
  /** Ratio of uv area to 3D area at equal total area; negative where a triangle is flipped; null without a layout or where infinite. */
  areaRatio: { min: number | null; max: number | null };
  /** Ratio σ₁/σ₂ of the singular values of the map (1 = conformal); null without a layout or where infinite. */
  quasiConformal: { mean: number | null; max: number | null; sheared: number | null };
  /** Mean by 3D area of (σ₁² + σ₂² + σ₁⁻² + σ₂⁻²)/4 (1 = isometric); null without a layout or where infinite. */
  symmetricDirichlet: number | null;
  /** Triangles that are not positively oriented, by an exact predicate; 0 in a valid layout. */
  flippedTriangles: number;
  /** Pairs of boundary edges that cross or touch, by an exact predicate; 0 in a valid layout. */
  boundaryCrossings: number;
  /** Whether there is no flipped triangle and no crossing, and the method converged. */
  valid: boolean;
  /** Why the layout is not valid or what went wrong, one sentence; empty when it is valid. */
  problem: string;
  /** 2 per output vertex, scaled to the area of the 3D surface; empty without a layout. */
  uv: Float64Array;
}

/** The report of compare. */
export interface ComparisonReport {
  /** Version of abflat. */
  version: string;
  /** The input. */
  input: MeshSummary;
  /** One entry per method, in a fixed order: the layouts of abflat first. */
  methods: MethodResult[];
}
