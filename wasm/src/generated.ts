// Generated from core/schema/abflat.json by scripts/generate.mjs, do not edit.

/** In the order of the C++ enum: index = number of the code. */
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
] as const;

export type StatusName = (typeof STATUS_NAMES)[number];

/** Exit code of the command line program and meaning of every status. */
export const STATUSES: Readonly<Record<StatusName, { readonly exit: number; readonly text: string }>> = {
  Ok: { exit: 0, text: 'no error' },
  InvalidOption: { exit: 2, text: 'an option is unknown or out of its range' },
  UnreadableFile: { exit: 3, text: 'the file does not exist, cannot be opened or has an unknown format' },
  ParseError: { exit: 3, text: 'the content is not what its format promises; the message names the line, or the byte of a binary file' },
  InvalidMesh: { exit: 3, text: 'mesh arrays contradict themselves: an index out of range, a coordinate that is not finite, a face with fewer than three corners' },
  EmptyMesh: { exit: 4, text: 'the mesh has no faces' },
  DegenerateFace: { exit: 4, text: 'a face uses the same vertex twice' },
  NonManifoldEdge: { exit: 4, text: 'an edge has more than two faces' },
  InconsistentOrientation: { exit: 4, text: 'two neighbouring faces run along their common edge in the same direction' },
  MultipleComponents: { exit: 4, text: 'the mesh has more than one edge-connected component' },
  ClosedSurface: { exit: 4, text: 'the surface has no boundary' },
  MultipleBoundaryLoops: { exit: 4, text: 'the surface has more than one boundary loop' },
  HasHandles: { exit: 4, text: 'the surface has genus above 0' },
  InfeasibleBound: { exit: 4, text: 't is below 1 - 2/(number of boundary vertices); the message says the least t possible' },
  OutOfMemory: { exit: 4, text: 'the mesh needs more memory than there is' },
  Aborted: { exit: 4, text: 'the caller cancelled the run' },
  CannotWrite: { exit: 5, text: 'the output cannot be written' },
  Internal: { exit: 4, text: 'a defect of abflat; please report it with the mesh' },
  AtlasTooSmall: { exit: 4, text: 'the charts do not fit the atlas; the message says which resolution or texel density they fit at' },
};

/** Exit codes of the command line program. */
export const EXIT_CODES = [
  { code: 0, name: 'Valid', text: 'a valid result was written' },
  { code: 1, name: 'NotValid', text: 'a result was written, but it is not valid or the solver did not converge; the report says which' },
  { code: 2, name: 'Usage', text: 'the command line cannot be understood' },
  { code: 3, name: 'Unreadable', text: 'the input cannot be read: the message names file, place and what is wrong' },
  { code: 4, name: 'NotFlattenable', text: 'the mesh was read but cannot be flattened, or not packed as asked: the message says why' },
  { code: 5, name: 'CannotWrite', text: 'the output cannot be written; an existing file is left as it was' },
] as const;

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
  t: { type: 'number', default: 'auto', above: 0, words: { auto: 0 }, text: 'boundary control coefficient: every interior angle of the layout\'s boundary is at most t*pi (1 = convex; 2 and above = free boundary, classic ABF; auto = free unless the boundary would cross itself, otherwise the bounds that distort least)', range: 'above 0, or auto' },
  balance: { type: 'number', default: 0, atLeast: 0, atMost: 1, text: 'trade-off between angles and lengths: 0 keeps the angles as flattening found them, 1 keeps areas and lengths as well as possible (least symmetric Dirichlet energy)', range: 'at least 0 and at most 1' },
  untangle: { type: 'choice', default: 'auto', choices: ['auto', 'none', 'local', 'global', 'best'], text: 'how boundary crossings are removed: auto = best when t is auto, none when it is a number; none = crossings stay, and the result is not valid; local = tighten the bounds of the arcs that cross, and only those; global = tighten all bounds alike; best = local or global, whichever distorts less', range: 'auto, none, local, global, best' },
  linearSolver: { type: 'choice', default: 'schur', choices: ['schur', 'eigen'], text: 'how the linear systems of Newton\'s method are solved: schur = elimination to two rows a vertex, then a sparse factorisation, or conjugate gradients with one for large meshes; eigen = the same elimination, factored by Eigen\'s SimplicialLDLT', range: 'schur, eigen' },
  memory: { type: 'number', default: 'auto', above: 0, words: { auto: 0 }, text: 'memory for a factor of the solver\'s matrix, in MB; if that is too little, the solver goes on in single precision, or without a factor by conjugate gradients with multigrid (auto = 3072 in WebAssembly, no limit natively)', range: 'above 0, or auto' },
  adjacent: { type: 'boolean', default: false, text: 'condition (5): even a free boundary has no angle above 2 pi, so neighbouring triangles do not overlap there', range: '' },
  delaunay: { type: 'boolean', default: false, text: 'condition (9): make every interior edge of the layout Delaunay, as far as the connectivity allows', range: '' },
  threads: { type: 'integer', default: 0, atLeast: 0, atMost: 256, text: 'most threads to use, 0 for one per processor; results do not depend on it, small meshes use fewer, and a build without threads uses one', range: 'at least 0 and at most 256, whole' },
} as const;

export type FillHoles = 'auto' | 'never' | 'always';

export type SymmetricSeams = 'auto' | 'never' | 'always';

/** The options of unwrapping that are plain values, with their defaults. */
export interface UnwrapOptionValues {
  maxStretch: number;
  balance: number;
  fillHoles: FillHoles;
  symmetricSeams: SymmetricSeams;
  t: number | 'auto';
  straightSeams: boolean;
  resolution: number;
  padding: number;
  texelDensity: number | 'auto';
  udim: boolean;
  minUtilization: number | 'auto';
  rotate: boolean;
  memory: number | 'auto';
  threads: number;
}

export const UNWRAP_DEFAULTS: Readonly<UnwrapOptionValues> = {
  maxStretch: 1.02,
  balance: 0.2,
  fillHoles: 'auto',
  symmetricSeams: 'auto',
  t: 'auto',
  straightSeams: false,
  resolution: 1024,
  padding: 2,
  texelDensity: 'auto',
  udim: false,
  minUtilization: 'auto',
  rotate: true,
  memory: 'auto',
  threads: 0,
};

/** Type, default, bounds and help text of every option, in the order of the C++ side; `range` says the bounds in words. */
export const UNWRAP_OPTIONS = {
  maxStretch: { type: 'number', default: 1.02, above: 1, text: 'largest stretch of a chart, as its mean symmetric Dirichlet energy / 4, where 1 keeps all lengths; smaller values give more seams and charts', range: 'above 1' },
  balance: { type: 'number', default: 0.2, atLeast: 0, atMost: 1, text: 'trade-off between angles and lengths: 0 keeps the angles as flattening found them, 1 keeps areas and lengths as well as possible (least symmetric Dirichlet energy)', range: 'at least 0 and at most 1' },
  fillHoles: { type: 'choice', default: 'auto', choices: ['auto', 'never', 'always'], text: 'whether holes in charts, such as eye sockets and windows, are treated as filled, so that they need no seams: auto = where the hole is small or lies in something flat, the chart stays within maxStretch and no seam reaches the hole; never = a seam joins every hole to the outer boundary; always = however much it stretches', range: 'auto, never, always' },
  symmetricSeams: { type: 'choice', default: 'auto', choices: ['auto', 'never', 'always'], text: 'whether a mesh that is its own mirror image gets symmetric automatic seams: auto = unless they would be longer; never = each seam where it serves its own side best; always = even if they are longer', range: 'auto, never, always' },
  t: { type: 'number', default: 'auto', above: 0, words: { auto: 0 }, text: 'boundary control coefficient: every interior angle of the layout\'s boundary is at most t*pi (1 = convex; 2 and above = free boundary, classic ABF; auto = free unless the boundary would cross itself, otherwise the bounds that distort least)', range: 'above 0, or auto' },
  straightSeams: { type: 'boolean', default: false, text: 'make seams and boundaries straight lines in the atlas, from junction to junction and corner to corner; what turns by more than 90 degrees in all, such as the rim of a round lid, stays as it is', range: '' },
  resolution: { type: 'integer', default: 1024, atLeast: 16, atMost: 32768, text: 'texels along a side of the texture that charts are packed for', range: 'at least 16 and at most 32768, whole' },
  padding: { type: 'integer', default: 2, atLeast: 0, atMost: 256, text: 'free texels between charts at that resolution', range: 'at least 0 and at most 256, whole' },
  texelDensity: { type: 'number', default: 'auto', above: 0, words: { auto: 0 }, text: 'texels per unit of length of the mesh, the same for meshes that belong together (auto = as many as fit one tile)', range: 'above 0, or auto' },
  udim: { type: 'boolean', default: false, text: 'use as many UDIM tiles as that texel density needs: 1001 and on, ten in a row, u from 0 to 10', range: '' },
  minUtilization: { type: 'number', default: 'auto', atLeast: 0, atMost: 1, words: { auto: -1 }, text: 'share of the tile that charts should cover: they are cut further until they do, or until cutting no longer helps (0 = never; auto = where that brings at least 1.5 % more texels per unit for each new chart, and 4 % for a seam as long as the root of the surface\'s area)', range: 'at least 0 and at most 1, or auto' },
  rotate: { type: 'boolean', default: true, text: 'rotating charts to pack tighter', range: '' },
  memory: { type: 'number', default: 'auto', above: 0, words: { auto: 0 }, text: 'memory for a factor of the solver\'s matrix, in MB; if that is too little, the solver goes on in single precision, or without a factor by conjugate gradients with multigrid (auto = 3072 in WebAssembly, no limit natively)', range: 'above 0, or auto' },
  threads: { type: 'integer', default: 0, atLeast: 0, atMost: 256, text: 'most threads to use, 0 for one per processor; results do not depend on it, small meshes use fewer, and a build without threads uses one', range: 'at least 0 and at most 256, whole' },
} as const;
