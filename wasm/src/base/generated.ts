// Generated from core/schema by scripts/generate.mjs, do not edit.

/** Those of the module, in the order of the C++ enum (index = number of the code), then the package's own. */
export const STATUS_NAMES = [
  'Ok',
  'InvalidOption',
  'UnreadableFile',
  'ParseError',
  'InvalidMesh',
  'EmptyMesh',
  'DegenerateFace',
  'NonManifoldEdge',
  'InconsistentOrientation',
  'MultipleComponents',
  'ClosedSurface',
  'MultipleBoundaryLoops',
  'HasHandles',
  'InfeasibleBound',
  'OutOfMemory',
  'Aborted',
  'CannotWrite',
  'Internal',
  'AtlasTooSmall',
  'NoTexcoords',
  'UnsupportedHost',
] as const;

export const MODULE_STATUS_COUNT = 20;

export type StatusName = (typeof STATUS_NAMES)[number];

/** Exit code of the command line program and meaning of every status. */
export const STATUSES: Readonly<Record<StatusName, { readonly exit: number; readonly text: string }>> = {
  Ok: { exit: 0, text: 'no error' },
  InvalidOption: { exit: 2, text: 'an option is unknown or out of its range' },
  UnreadableFile: { exit: 3, text: 'the file does not exist, cannot be opened or has an unsupported format' },
  ParseError: { exit: 3, text: 'the file breaks the rules of its format; the message names the line, or the byte of a binary file' },
  InvalidMesh: { exit: 3, text: 'mesh arrays are inconsistent: an index out of range, a coordinate that is not finite, a face with fewer than three corners' },
  EmptyMesh: { exit: 4, text: 'the mesh has no faces' },
  DegenerateFace: { exit: 4, text: 'a face uses the same vertex twice' },
  NonManifoldEdge: { exit: 4, text: 'an edge has more than two faces' },
  InconsistentOrientation: { exit: 4, text: 'two adjacent faces have opposite orientation' },
  MultipleComponents: { exit: 4, text: 'the mesh has more than one edge-connected component' },
  ClosedSurface: { exit: 4, text: 'the surface has no boundary' },
  MultipleBoundaryLoops: { exit: 4, text: 'the surface has more than one boundary loop' },
  HasHandles: { exit: 4, text: 'the surface has genus above 0' },
  InfeasibleBound: { exit: 4, text: 't is below 1 - 2/(number of boundary vertices); the message names the smallest possible t' },
  OutOfMemory: { exit: 4, text: 'there is not enough memory for the mesh' },
  Aborted: { exit: 4, text: 'the caller cancelled the run' },
  CannotWrite: { exit: 5, text: 'the output cannot be written' },
  Internal: { exit: 4, text: 'a bug in abflat; please report it with the mesh' },
  AtlasTooSmall: { exit: 4, text: 'the charts do not fit the atlas; the message names a resolution or texel density at which they fit' },
  NoTexcoords: { exit: 4, text: 'no face of the mesh has texcoords, so it has no layout' },
  UnsupportedHost: { exit: 4, text: 'WebAssembly or its 128-bit vectors (SIMD) are missing, as in browsers before Chrome 91, Firefox 89 and Safari 16.4, or may not be used here' },
};

export type Untangle = 'auto' | 'none' | 'local' | 'global' | 'best';

export type LinearSolver = 'schur' | 'eigen';

/** The options of flattening that are plain values, with their defaults. */
export interface FlattenOptionValues {
  t: number | 'auto';
  balance: number;
  untangle: Untangle;
  linearSolver: LinearSolver;
  memory: number | 'auto';
  adjacent: boolean;
  delaunay: boolean;
  threads: number;
}

export const FLATTEN_DEFAULTS: Readonly<FlattenOptionValues> = {
  t: 'auto',
  balance: 0,
  untangle: 'auto',
  linearSolver: 'schur',
  memory: 'auto',
  adjacent: false,
  delaunay: false,
  threads: 0,
};

/** Type, default, bounds and help text of every option, in the order of the C++ side; `range` says the bounds in words. */
export const FLATTEN_OPTIONS = {
  t: { type: 'number', default: 'auto', above: 0, words: { auto: 0 }, text: 'boundary control coefficient: every interior angle of the boundary is at most t*pi (1 = convex; 2 or more = free boundary, classic ABF; auto = free, or the bounds of least distortion if a free boundary would cross itself)', range: 'above 0, or auto' },
  balance: { type: 'number', default: 0, atLeast: 0, atMost: 1, text: 'trade-off between angles and lengths: 0 keeps the angles as flattening found them, 1 keeps areas and lengths as well as possible (least symmetric Dirichlet energy)', range: 'at least 0 and at most 1' },
  untangle: { type: 'choice', default: 'auto', choices: ['auto', 'none', 'local', 'global', 'best'], text: 'how boundary crossings are removed: auto = best when t is auto, none when it is a number; none = keep crossings; the result is not valid; local = tighten only the bounds of the arcs that cross; global = tighten all bounds alike; best = local or global, whichever distorts less', range: 'auto, none, local, global, best' },
  linearSolver: { type: 'choice', default: 'schur', choices: ['schur', 'eigen'], text: 'how the linear systems of Newton\'s method are solved: schur = elimination to two rows per vertex, then sparse factorisation; for large meshes, conjugate gradients preconditioned by one; eigen = the same elimination, factored by Eigen\'s SimplicialLDLT', range: 'schur, eigen' },
  memory: { type: 'number', default: 'auto', above: 0, words: { auto: 0 }, text: 'memory for the factor of the solver\'s matrix, in MB; if it does not fit, the solver uses single precision, or conjugate gradients with multigrid (auto = 3072 in WebAssembly, no limit natively)', range: 'above 0, or auto' },
  adjacent: { type: 'boolean', default: false, text: 'condition (5): keep boundary angles below 2 pi even if the boundary is free, so that adjacent triangles do not overlap', range: '' },
  delaunay: { type: 'boolean', default: false, text: 'condition (9): make every interior edge of the layout Delaunay, where the connectivity allows it', range: '' },
  threads: { type: 'integer', default: 0, atLeast: 0, atMost: 256, text: 'maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one', range: 'at least 0 and at most 256, whole' },
} as const;

export type FillHoles = 'auto' | 'never' | 'always';

export type SeamCosts = 'sight' | 'length';

export type SymmetricSeams = 'auto' | 'never' | 'always';

export type Rectify = 'auto' | 'never' | 'always';

export type PackingCuts = 'auto' | 'never';

export type Up = 'auto' | 'y' | 'z';

export type Rotate = 'auto' | 'free' | 'quarter' | 'none';

export type Stack = 'none' | 'identical' | 'mirrored';

/** The options of unwrapping that are plain values, with their defaults. */
export interface UnwrapOptionValues {
  maxStretch: number;
  maxSheared: number | 'auto';
  frontLeeway: number;
  balance: number;
  orient: boolean;
  fillHoles: FillHoles;
  seamCosts: SeamCosts;
  symmetricSeams: SymmetricSeams;
  t: number | 'auto';
  straightSeams: boolean;
  rectify: Rectify;
  resolution: number | readonly [width: number, height: number];
  padding: number;
  margin: number | 'auto';
  texelDensity: number | 'auto';
  udim: boolean;
  snapToTexels: boolean;
  packingCuts: PackingCuts;
  minUtilization: number | 'auto';
  up: Up;
  rotate: Rotate;
  stack: Stack;
  memory: number | 'auto';
  threads: number;
}

export const UNWRAP_DEFAULTS: Readonly<UnwrapOptionValues> & { readonly resolution: number } = {
  maxStretch: 1.02,
  maxSheared: 'auto',
  frontLeeway: 14,
  balance: 0.2,
  orient: false,
  fillHoles: 'auto',
  seamCosts: 'sight',
  symmetricSeams: 'auto',
  t: 'auto',
  straightSeams: false,
  rectify: 'auto',
  resolution: 1024,
  padding: 2,
  margin: 'auto',
  texelDensity: 'auto',
  udim: false,
  snapToTexels: false,
  packingCuts: 'auto',
  minUtilization: 'auto',
  up: 'auto',
  rotate: 'auto',
  stack: 'none',
  memory: 'auto',
  threads: 0,
};

/** Type, default, bounds and help text of every option, in the order of the C++ side; `range` says the bounds in words. */
export const UNWRAP_OPTIONS = {
  maxStretch: { type: 'number', default: 1.02, above: 1, text: 'largest stretch of a chart: its mean symmetric Dirichlet energy / 4, where 1 keeps all lengths; smaller values give more seams and charts', range: 'above 1' },
  maxSheared: { type: 'number', default: 'auto', above: 0, atMost: 1, words: { auto: -1 }, text: 'largest share of a chart\'s surface that may be sheared, that is, have a quasi-conformal distortion above 1.25, as if a square became a rectangle of 5 by 4; charts with more are cut further (1 = no limit; auto = 0.1, or 5 times what maxStretch is above 1, if that is more)', range: 'above 0 and at most 1, or auto' },
  frontLeeway: { type: 'number', default: 14, atLeast: 1, atMost: 100, text: 'how much more the front of a figure, such as a face, may be stretched so that no seam crosses it: so many times maxStretch - 1, and as many times maxSheared; half as much again on a mask that then needs no seam at all (1 = no more than elsewhere)', range: 'at least 1 and at most 100' },
  balance: { type: 'number', default: 0.2, atLeast: 0, atMost: 1, text: 'trade-off between angles and lengths: 0 keeps the angles as flattening found them, 1 keeps areas and lengths as well as possible (least symmetric Dirichlet energy)', range: 'at least 0 and at most 1' },
  orient: { type: 'boolean', default: false, text: 'turn faces so that neighbours run alike, in the layout and in the output, before seams are placed; normals stay as they are', range: '' },
  fillHoles: { type: 'choice', default: 'auto', choices: ['auto', 'never', 'always'], text: 'whether holes in charts, such as eye sockets and windows, are treated as filled and need no seams: auto = fill small or flat holes, unless a seam reaches them or the chart would be stretched too much; never = connect every hole to the outer boundary by a seam; always = fill them, however much that stretches', range: 'auto, never, always' },
  seamCosts: { type: 'choice', default: 'sight', choices: ['sight', 'length'], text: 'what automatic seams are to have little of: sight = how much they are in sight: creases hide seams, flat faces and the face of a figure do not; length = their length alone, as papers and patterns have it', range: 'sight, length' },
  symmetricSeams: { type: 'choice', default: 'auto', choices: ['auto', 'never', 'always'], text: 'whether automatic seams of a symmetric mesh are symmetric; parts without a mirror image do not matter: auto = symmetric unless that makes seams more than a tenth costlier; never = place each seam where it is best for its own side; always = symmetric whatever that costs', range: 'auto, never, always' },
  t: { type: 'number', default: 'auto', above: 0, words: { auto: 0 }, text: 'boundary control coefficient: every interior angle of the boundary is at most t*pi (1 = convex; 2 or more = free boundary, classic ABF; auto = free, or the bounds of least distortion if a free boundary would cross itself)', range: 'above 0, or auto' },
  straightSeams: { type: 'boolean', default: false, text: 'make seams and boundaries straight in the atlas, from junction to junction and corner to corner; curves that turn by more than 90 degrees in all, such as the rim of a round lid, stay curved', range: '' },
  rectify: { type: 'choice', default: 'auto', choices: ['auto', 'never', 'always'], text: 'whether outlines that are nearly straight become exactly so, and strips rectangles: auto = where that hardly stretches, and stays within the bound of stretch; never = leave outlines as they come out; always = however much that stretches', range: 'auto, never, always' },
  resolution: { type: 'size', default: 1024, atLeast: 16, atMost: 32768, text: 'side of the texture in texels, or its width and height', range: 'at least 16 and at most 32768, whole, or two of these, as in [2048, 1024]' },
  padding: { type: 'integer', default: 2, atLeast: 0, atMost: 256, text: 'free texels between charts, and between far parts of one chart', range: 'at least 0 and at most 256, whole' },
  margin: { type: 'integer', default: 'auto', atLeast: 0, atMost: 256, words: { auto: -1 }, text: 'free texels between charts and the edge of their tile (auto = half the padding, rounded up)', range: 'at least 0 and at most 256, whole, or auto' },
  texelDensity: { type: 'number', default: 'auto', above: 0, words: { auto: 0 }, text: 'texels per mesh unit; use the same value for meshes that belong together (auto = as many as fit in one tile)', range: 'above 0, or auto' },
  udim: { type: 'boolean', default: false, text: 'use as many UDIM tiles as the texel density needs: from 1001 on, ten per row, u from 0 to 10', range: '' },
  snapToTexels: { type: 'boolean', default: false, text: 'stretch level charts to whole texels, so that their sides lie on borders of texels', range: '' },
  packingCuts: { type: 'choice', default: 'auto', choices: ['auto', 'never'], text: 'whether charts may be cut so that all pack tighter: auto = where that gains enough texels, see minUtilization; never = every chart stays whole', range: 'auto, never' },
  minUtilization: { type: 'number', default: 'auto', atLeast: 0, atMost: 1, words: { auto: -1 }, text: 'share of the tile that charts should cover: charts are cut until they do, or until cutting stops helping, and then a note says why (0 = leave charts whole, like packingCuts = never; auto = cut long charts across, and others along creases, where that gains at least 5 % texels per unit for each of the first four cuts, 1.5 % per further cut, and 4 % per seam in plain sight as long as the square root of the surface area)', range: 'at least 0 and at most 1, or auto' },
  up: { type: 'choice', default: 'auto', choices: ['auto', 'y', 'z'], text: 'which axis of the mesh points up: charts that stand are laid out upright, and a face is looked for at the sides: auto = z in STL files, y in all others; y = the y axis; z = the z axis', range: 'auto, y, z' },
  rotate: { type: 'choice', default: 'auto', choices: ['auto', 'free', 'quarter', 'none'], text: 'how charts, which lie level and upright, are turned to pack tighter: auto = by quarter turns, and charts whose outlines are not straight by any angle where that gains 4 % texels per unit or more; free = by any angle where that gains 3 % texels per unit or more, with up to 40 charts 5 %; quarter = by quarter turns only; none = not at all', range: 'auto, free, quarter, none' },
  stack: { type: 'choice', default: 'none', choices: ['none', 'identical', 'mirrored'], text: 'which parts and charts of equal shape lie on each other and share their texels: none = each has texels of its own; identical = those that are moved and turned; mirrored = mirror images as well, whose triangles run clockwise in the atlas', range: 'none, identical, mirrored' },
  memory: { type: 'number', default: 'auto', above: 0, words: { auto: 0 }, text: 'memory for the factor of the solver\'s matrix, in MB; if it does not fit, the solver uses single precision, or conjugate gradients with multigrid (auto = 3072 in WebAssembly, no limit natively)', range: 'above 0, or auto' },
  threads: { type: 'integer', default: 0, atLeast: 0, atMost: 256, text: 'maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one', range: 'at least 0 and at most 256, whole' },
} as const;

export type IslandSizes = 'keep' | 'even';

/** The options of packing a layout that are plain values, with their defaults. */
export interface PackOptionValues {
  resolution: number | readonly [width: number, height: number];
  padding: number;
  margin: number | 'auto';
  texelDensity: number | 'auto';
  udim: boolean;
  snapToTexels: boolean;
  rotate: Rotate;
  islandSizes: IslandSizes;
  keepPlaces: boolean;
  threads: number;
}

export const PACK_DEFAULTS: Readonly<PackOptionValues> & { readonly resolution: number } = {
  resolution: 1024,
  padding: 2,
  margin: 'auto',
  texelDensity: 'auto',
  udim: false,
  snapToTexels: false,
  rotate: 'auto',
  islandSizes: 'keep',
  keepPlaces: false,
  threads: 0,
};

/** Type, default, bounds and help text of every option, in the order of the C++ side; `range` says the bounds in words. */
export const PACK_OPTIONS = {
  resolution: { type: 'size', default: 1024, atLeast: 16, atMost: 32768, text: 'side of the texture in texels, or its width and height', range: 'at least 16 and at most 32768, whole, or two of these, as in [2048, 1024]' },
  padding: { type: 'integer', default: 2, atLeast: 0, atMost: 256, text: 'free texels between islands', range: 'at least 0 and at most 256, whole' },
  margin: { type: 'integer', default: 'auto', atLeast: 0, atMost: 256, words: { auto: -1 }, text: 'free texels between islands and the edge of their tile (auto = half the padding, rounded up)', range: 'at least 0 and at most 256, whole, or auto' },
  texelDensity: { type: 'number', default: 'auto', above: 0, words: { auto: 0 }, text: 'texels per mesh unit; use the same value for meshes that belong together (auto = as many as fit in one tile)', range: 'above 0, or auto' },
  udim: { type: 'boolean', default: false, text: 'use as many UDIM tiles as the texel density needs: from 1001 on, ten per row, u from 0 to 10', range: '' },
  snapToTexels: { type: 'boolean', default: false, text: 'stretch level islands to whole texels, so that their sides lie on borders of texels', range: '' },
  rotate: { type: 'choice', default: 'auto', choices: ['auto', 'free', 'quarter', 'none'], text: 'how islands are turned from how they lie to pack tighter: auto = by quarter turns, and charts whose outlines are not straight by any angle where that gains 4 % texels per unit or more; free = by any angle where that gains 3 % texels per unit or more, with up to 40 charts 5 %; quarter = by quarter turns only; none = not at all', range: 'auto, free, quarter, none' },
  islandSizes: { type: 'choice', default: 'keep', choices: ['keep', 'even'], text: 'how large islands are beside each other: keep = as large to each other as they are; even = the same texel density for all; islands that lie on each other share one scale', range: 'keep, even' },
  keepPlaces: { type: 'boolean', default: false, text: 'islands stay where they are, and the layout is only judged; of the other options only resolution and udim count then', range: '' },
  threads: { type: 'integer', default: 0, atLeast: 0, atMost: 256, text: 'maximum number of threads, 0 for one per processor; results do not depend on it; small meshes use fewer, and builds without threads use one', range: 'at least 0 and at most 256, whole' },
} as const;

/** What made the layout of a chart. */
export type Solver = 'activeSet' | 'interiorPoint' | 'tutte' | 'known' | 'given' | 'projection';

/** What a chart looks like. */
export type ChartShape = 'other' | 'rectangle' | 'strip' | 'disc' | 'ring';

/** A stage of a run of flatten. */
export type FlattenStage = 'read' | 'connectivity' | 'solve' | 'layout' | 'refine' | 'check' | 'write';

/** A stage of a run of unwrap. */
export type UnwrapStage = 'read' | 'surface' | 'seams' | 'solve' | 'pack' | 'check' | 'write';

/** A stage of a run of pack. */
export type PackStage = 'read' | 'pack' | 'check' | 'write';

/** A stage of a run of bake. */
export type BakeStage = 'read' | 'write';

/** A stage of a run of verify. */
export type VerifyStage = 'read' | 'check';

/** A stage of a run of compare. */
export type CompareStage = 'read';

/** What verify asks of a layout. */
export type VerifyRule = 'flipped' | 'empty' | 'overlap' | 'overlapBetween' | 'stacked' | 'outside' | 'padding' | 'margin' | 'thin' | 'density' | 'densityRatio' | 'stretch' | 'utilization' | 'islands' | 'unmapped' | 'geometry' | 'order' | 'attributes';

/** A method of compare. */
export type MethodKey = 'abflatAuto' | 'abflatConvex' | 'abflatFree' | 'abflatBalanced' | 'symmetricDirichlet' | 'mips' | 'tutte' | 'meanValue' | 'harmonic' | 'lscm';

export interface UnwrapArrays {
  /** Edges to cut in addition, given as two input vertices each. */
  seamEdges?: Uint32Array;
  /** Input faces whose uv islands stay exactly as they are, or `'uv'` for all that have texcoords; all others are packed around them. */
  fixedFaces?: Uint32Array | 'uv';
  /** Charts of `known` that stay exactly where they are; all others are packed around them. */
  fixedCharts?: Uint32Array;
  /** Per input face, the texel density wanted for it relative to the others, from 0.001 to 1000; a chart has as many texels as its faces ask for together, and charts that stay where they are also keep their size. */
  faceDensities?: Float32Array | Float64Array;
}

/** Element types, what they are numbers of, and what may stand for them, in the order of the C++ side. */
export const UNWRAP_ARRAYS = {
  seamEdges: { type: 'index', of: 'vertex pairs', multiple: 2 },
  fixedFaces: { type: 'index', of: 'face numbers', multiple: 1, word: 'uv' },
  fixedCharts: { type: 'index', of: 'chart numbers', multiple: 1 },
  faceDensities: { type: 'number', multiple: 1 },
} as const;

export const WRITTEN_FORMATS = ['obj', 'ply'] as const;

export type WrittenFormat = (typeof WRITTEN_FORMATS)[number];

export interface FileOptions {
  /** Also return the input as OBJ with the new texcoords. */
  obj?: boolean;
  /** Also return the input as PLY with the new texcoords. The layout is rounded to single precision if it stays valid. */
  ply?: boolean;
}

export interface Files {
  /** OBJ when asked for with `obj: true`, UTF-8. */
  obj?: Uint8Array;
  /** PLY when asked for with `ply: true`, in the encoding of the input, or binary if that is not a PLY. */
  ply?: Uint8Array;
}
