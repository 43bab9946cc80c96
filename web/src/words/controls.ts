// What a layout is asked for.

import { type Bound, bound, count, counted } from './format';

/** What a mesh lacks that cannot be flattened, by abflat's status. */
export const DISK_NEEDS = {
  DegenerateFace: 'Needs a mesh without degenerate faces',
  NonManifoldEdge: 'Needs a mesh without non-manifold edges',
  InconsistentOrientation: 'Needs faces that are all oriented alike',
  MultipleComponents: 'Needs a mesh in one piece',
  ClosedSurface: 'Needs an open surface',
  MultipleBoundaryLoops: 'Needs a surface with a single boundary',
  HasHandles: 'Needs a surface without handles',
};

export const NO_DISK = {
  not: 'Lay out the mesh in one piece',
  /** `reason` is a sentence. */
  flatten: (reason: string, need = 'Needs a mesh that is a disk') => `${need}. ${reason}`,
};

/** The less common options of an atlas. */
export const OPTION_LABELS = {
  fillHoles: 'Fill holes',
  symmetricSeams: 'Symmetric seams',
  t: 'Boundary t',
  texelDensity: 'Texel density',
  up: 'Up axis',
  rotate: 'Rotation',
  rectify: 'Rectify',
  packingCuts: 'Cut to pack tighter',
  stack: 'Stack equal islands',
  straightSeams: 'Straight seams',
  udim: 'UDIM tiles',
};

/** `label`: without its capital letter. */
export const OPTIONS = {
  off: (label: string) => `no ${label}`,
  setTo: (label: string, value: string | number) => `${label} ${value}`,
  keepingUvs: 'keep UVs of the file',
  keepUvs: 'Keep UVs of the file',
  aboutKeepUvs:
    'Faces with UVs in the file keep them exactly; all others are unwrapped and packed around them',
  tilesNeedDensity: '. Needs a numeric texel density',
  tiles: 'Tiles',
  aboutTiles: 'UDIM tiles: all islands share, or each object or material has one of its own',
};

/** The slider for the limit of stretch, and the size of an atlas. */
export const STRETCH_LIMIT = {
  more: 'more seams',
  fewer: 'fewer seams',
  lengths: (percent: number) => `lengths off by up to ${percent}\u202f%`,
  notEnforced: 'not enforced',
  about: 'Limit for the average stretch of each island. A lower limit adds seams and islands',
  aboutNotEnforced:
    'Auto is off, so nothing is cut to meet this limit. Press Auto, or Cut further next to the result',
  readOut: (limit: number, hint: string) => `${limit}: ${hint}`,
  pixels: (n: number) => `${count(n)}\u202fpx`,
};

/** The slider between angles and lengths. */
export const BALANCE = {
  angles: 'angles as flattened',
  lengths: 'lengths and areas as well as possible',
  between: 'angles traded for lengths',
  readOut: (balance: number, meaning: string) => `${balance}: ${meaning}`,
};

/** What t means for the boundary's interior angles. */
export const BOUND = {
  convex: 'convex',
  free: 'free',
  upTo: (degrees: number) => `up to ${degrees}°`,
  found: (meaning: string) => `auto: ${meaning}`,
  readOut: (t: Bound, hint: string) => `${bound(t)}, ${hint}`,
  beforeTick: 't = ',
};

/** Bounds that are painted on a boundary. */
export const BOUNDS = {
  invitation: 'Drag along the boundary',
  value: (t: number, meaning: string) => `${bound(t)}, ${meaning}`,
  erasing: (vertices: number) => `${counted(vertices, 'vertex', 'vertices')}: erase`,
  painting: (vertices: number, value: string) =>
    `${counted(vertices, 'vertex', 'vertices')}: paint ${value}`,
  erased: (vertices: number) => `Erased the bounds of ${counted(vertices, 'vertex', 'vertices')}`,
  painted: (vertices: number) => `Painted the bounds of ${counted(vertices, 'vertex', 'vertices')}`,
  cleared: 'Cleared all painted bounds',
  unchanged: 'No bounds changed',
  noBoundary: 'No boundary here',
  notPainted: (reason: string) => `Bounds cannot be painted: ${reason}`,
};

interface NumberRange {
  readonly type: string;
  readonly above?: number;
  readonly atLeast?: number;
  readonly atMost?: number;
}

/** Fields for numbers. */
export const NUMBERS = {
  unnamed: 'The number',
  auto: 'auto',
  /** "a whole number from 0 to 256" */
  range: ({ above, atLeast = 0, atMost, type }: NumberRange) => {
    const low = above === undefined ? `from ${atLeast}` : `above ${above}`;
    const high = atMost === undefined ? '' : ` to ${atMost}`;
    return `${type === 'integer' ? 'a whole number ' : ''}${low}${high}`;
  },
  refused: (name: string, typed: string, range: string, kept: string) => {
    const unused = typed === '' ? '' : `${typed} was ignored: `;
    return `${unused}${name} must be ${range}. It is still ${kept}.`;
  },
};
