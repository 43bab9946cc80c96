// Everything that the page's scripts say to people, by room and with the numbers and names that go into it. What is always on the page
// is in index.html. Errors that only a developer can meet stay where they are thrown.

import { type Bound, bound, count, counted, measure } from './format';

// Rooms: base, view, drawing, mesh, files, workshop, opening, export

/** Said where a part of the page or a worker is missing. */
export const LOST = {};

// Rooms: model, controls, plot, details

/** The measures of the heat maps. */
export const HEAT_MAPS = {
  angle: {
    title: 'Angle error',
    explanation: 'Relative change of a triangle’s angles',
  },
  area: {
    title: 'Area',
    explanation:
      'Area in uv divided by area in 3D: below 1 a place has fewer texels than the average',
  },
  stretch: {
    title: 'Stretch',
    explanation: 'Symmetric Dirichlet energy / 4 of each triangle; 1 keeps all lengths',
  },
};

/** The less common options of an atlas. */
export const OPTION_LABELS = {
  fillHoles: 'Fill holes',
  symmetricSeams: 'Symmetric seams',
  t: 'Boundary t',
  texelDensity: 'Texel density',
  straightSeams: 'Straight seams',
  rotate: 'Rotation',
  udim: 'UDIM tiles',
};

/** `label`: without its capital letter. */
export const OPTIONS = {
  off: (label: string) => `no ${label}`,
  setTo: (label: string, value: string | number) => `${label} ${value}`,
  uvsKept: 'UVs of the file kept',
  keepUvs: 'Keep UVs of the file',
  aboutKeepUvs:
    'Faces with UVs in the file keep them exactly; all others are unwrapped and packed around them',
  tilesNeedDensity: '. Needs a numeric texel density',
};

/** The slider for the limit of stretch, and the size of an atlas. */
export const STRETCH_LIMIT = {
  more: 'more seams',
  fewer: 'fewer seams',
  lengths: (percent: number) => `lengths \u00b1${percent}\u202f%`,
  notEnforced: 'not enforced',
  about: 'Limit for the average stretch of each chart. A lower limit gives more seams and charts',
  aboutNotEnforced: (lengths: string) =>
    `Auto is off, so no cuts enforce ${lengths}. Press Auto, or Cut further next to the result`,
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

export const MODE_HINTS = { flatten: 'one chart', unwrap: 'charts in a square' };

/** Why a mesh cannot be flattened, in two words, by abflat's status. */
export const DISK_PROBLEMS = {
  DegenerateFace: 'Degenerate faces',
  NonManifoldEdge: 'Non-manifold edges',
  InconsistentOrientation: 'Flipped faces',
  MultipleComponents: 'Several components',
  ClosedSurface: 'Closed surface',
  MultipleBoundaryLoops: 'Several boundaries',
  HasHandles: 'Handles',
};

export const NO_DISK = {
  useUnwrap: (problem = 'Not a disk') => `${problem}: use Unwrap`,
};

/** What the user should know about the opened file. */
export const OPENED_NOTICE = {
  close: 'Close this notice',
  tabs: 'Open as tabs',
  aboutTabs: 'Each with a layout of its own',
  oneAtlas: 'One atlas',
  aboutOneAtlas: 'All as one mesh, in one layout',
  compressed: (name: string, compressions: string[]) =>
    `${name} was compressed with ${compressions.join(' and ')}. The export is uncompressed.`,
  oneOfMany: (name: string, meshes: number) => `You chose ${meshes} meshes. ${name} is open.`,
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

/** What the worker is doing, by abflat's stage. */
export const STAGES = {
  read: 'Reading',
  connectivity: 'Analysing the surface',
  surface: 'Analysing the surface',
  seams: 'Finding seams',
  solve: 'Solving',
  layout: 'Laying out',
  refine: 'Refining',
  pack: 'Packing charts',
  check: 'Checking',
  write: 'Writing',
};

export const SOLVER_PROGRESS = {
  atStep: (stage: string, step: number, residual: number) =>
    `${stage}, step ${step}, residual ${residual.toExponential(0)}`,
};

/** The titles of the undo and redo buttons; `what` is null if there is nothing to do. */
export const STEP_BUTTONS = {
  undo: (what: string | null) => (what === null ? 'Undo (Ctrl+Z)' : `Undo: ${what} (Ctrl+Z)`),
  redo: (what: string | null) =>
    what === null ? 'Redo (Ctrl+Shift+Z)' : `Redo: ${what} (Ctrl+Shift+Z)`,
};

/** The choice of a glTF's texcoord set. */
export const UV_SETS = {
  added: (set: number) => `UV ${set}, new`,
  replaced: (set: number) => `UV ${set}, replaced`,
};

export const VALIDITY = { valid: 'valid', notValid: 'not valid', column: 'Valid' };

/** What runs in a tab of the details. */
export const TAB_JOBS = { stop: 'Stop', stopped: 'Stopped', starting: 'Starting' };

export const BADGES = { valid: 'Valid', stretched: 'Stretched', notValid: 'Not valid' } as const;

/** Why a result has its badge. */
export const VERDICT = {
  noCrossings: 'No flipped triangles, no crossings',
  noOverlaps: 'No flipped triangles, no overlaps',
  lengthsChange: (share: number) =>
    `Lengths change by ${count(100 * share)}\u202f% on average: seams would help`,
  stretched: (most: string, limit: number, charts: number, all: number) => {
    const upTo = charts > 1 ? 'up to ' : '';
    const where = all > 1 ? ` in ${count(charts)} of ${count(all)} charts` : '';
    return `Stretch ${upTo}${most}${where}; the limit is ${limit}`;
  },
  defects: (bad: number, all: number, problem: string) =>
    `${count(bad)} of ${counted(all, 'chart')}: ${problem}`,
};

/** What the user can do about a verdict. */
export const REMEDIES = {
  cut: {
    label: 'Cut further',
    title: 'Keep these seams and add automatic ones until every chart is within the limit',
  },
  unwrap: { label: 'Unwrap', title: 'Cut the mesh into charts that stretch less' },
};

/** The numbers of a layout in one piece. */
export const DISK_METRICS = {
  angle: {
    label: 'Angular distortion',
    title: 'Mean over all corners of ((x - α)/α)², x in the layout, α in 3D',
  },
  length: {
    label: 'Length distortion',
    title:
      'Mean over all edges of (sL/l - 1)², L in the layout, l in 3D, s the ratio of their sums',
  },
  stretch: {
    label: 'Stretch',
    title: 'Symmetric Dirichlet energy / 4, mean over the surface; 1 keeps all lengths',
  },
  crossings: { label: 'Crossings', title: 'Pairs of boundary edges that cross or touch' },
  flipped: {
    label: 'Flipped',
    title: 'Triangles of the layout that are not positively oriented',
  },
  steps: { label: 'Newton steps', title: 'Steps of the solver' },
};

/** The numbers of an atlas. */
export const ATLAS_METRICS = {
  charts: { label: 'Charts', title: 'Charts in the atlas; red if one is not valid' },
  seamLength: {
    label: 'Seam length',
    title:
      'Divided by the square root of the surface area, so it does not depend on the size of the mesh',
  },
  stretch: {
    label: 'Stretch',
    title:
      'Symmetric Dirichlet energy / 4, mean over the surface, each chart at its own scale; 1 keeps all lengths',
  },
  angle: {
    label: 'Angular distortion',
    title: 'Mean over the surface of ((x - α)/α)², x in the layout, α in 3D',
  },
  utilization: {
    label: 'Utilisation',
    title: 'Share of the square, or of all tiles, that the charts cover',
  },
  texelDensity: { label: 'Texel density', title: 'Texels per mesh unit at this resolution' },
};

/** The numbers of every layout. */
export const METRICS = {
  faces: { label: 'Faces', title: 'Faces of the input: triangles, quads and larger polygons' },
  energy: {
    label: 'Energy',
    title:
      'Energy minimised for the balance b, averaged over the refined surface, before and after: (1 - b)·(σ₁/σ₂ + σ₂/σ₁)/2 + b·(σ₁² + σ₂² + 1/σ₁² + 1/σ₂²)/4',
  },
  time: { label: 'Time', title: 'Total time in the worker, including reading and writing' },
  toWorst: (title: string) => `${title}. Click to see where it is worst`,
  notes: (n: number) => counted(n, 'note'),
  of: (owner: string) => `Numbers of ${owner}`,
};

/** The notes on an atlas; `places` name faces or edges. */
export const ATLAS_NOTES = {
  problem: (face: number, problem: string) => `chart containing face ${face}: ${problem}`,
  moreProblems: (n: number) => `${counted(n, 'more chart is', 'more charts are')} not valid`,
  merged: (n: number) =>
    `${counted(n, 'duplicate vertex was', 'duplicate vertices were')} treated as one`,
  collapsed: (n: number, places: string) =>
    `${counted(n, 'degenerate face uses', 'degenerate faces use')} the UVs of neighbouring faces: ${places}`,
  split: (n: number, places: string) =>
    `${counted(n, 'face touches itself and was split', 'faces touch themselves and were split')} there: ${places}`,
  duplicates: (n: number, places: string) =>
    `${counted(n, 'duplicate face has its own chart', 'duplicate faces have their own charts')}: ${places}`,
  nonManifold: (n: number, places: string) =>
    `${counted(n, 'edge has', 'edges have')} more than two faces and ${n === 1 ? 'became a seam' : 'became seams'}: ${places}`,
  conflicts: (n: number, places: string) =>
    `${counted(n, 'edge lies', 'edges lie')} between faces of opposite orientation and ${n === 1 ? 'became a seam' : 'became seams'}: ${places}`,
  noArea: (n: number) =>
    `${counted(n, 'triangle has', 'triangles have')} no area and got artificial angles`,
  faces: (n: number, names: string) => `${n === 1 ? 'face' : 'faces'} ${names}`,
  edges: (n: number, names: string) => `${n === 1 ? 'edge' : 'edges'} ${names}`,
  andMore: (names: string, more: number) => `${names} and ${count(more)} more`,
  handles: (genus: number, loops: number, length: number) =>
    `${genus > 0 ? `genus ${genus}: ` : ''}handles are cut open by ${counted(loops, 'loop')} of length ${measure(length)}`,
  filledHoles: (n: number) =>
    counted(
      n,
      'hole was treated as filled and needs no seam',
      'holes were treated as filled and need no seams',
    ),
  fallback: (charts: number, text: string) => `${counted(charts, 'chart')}: ${text}`,
};

/** The notes on a layout in one piece. */
export const DISK_NOTES = {
  delaunay: (
    edges: number,
    violated: [before: number, now: number],
    distortion: [before: number, now: number],
  ) => {
    const before = `${count(violated[0])} of ${counted(edges, 'interior edge')} before`;
    const change = `angular distortion ${measure(distortion[0])} before, ${measure(distortion[1])} now`;
    return `edges that are not Delaunay: ${before}, ${count(violated[1])} now; ${change}`;
  },
  tightened: (n: number, least: number) => {
    const vertices = counted(n, 'boundary vertex was', 'boundary vertices were');
    return `${vertices} tightened, ${n === 1 ? '' : 'down '}to t\u00a0=\u00a0${bound(least)}`;
  },
};

/** The columns of the charts' table. */
export const CHART_COLUMNS = {
  chart: { name: 'Chart', title: 'Sort by number. Charts of the same colour never touch' },
  faces: { name: 'Faces', title: 'Number of triangles' },
  area: { name: 'Area', title: "Share of the surface's area" },
  stretch: { name: 'Stretch', title: 'Mean symmetric Dirichlet energy / 4: 1 keeps all lengths' },
  angle: { name: 'Angle', title: 'Angular distortion: mean over corners of ((x - α)/α)²' },
  valid: { name: 'Valid', title: 'No flipped triangles, no crossings' },
};

/** The table of charts, and what is said above it. */
export const CHART_LIST = {
  caption: 'Charts',
  more: (n: number) => `${counted(n, 'more chart')}: sort by another column to see others.`,
  show: (chart: number) => `Show chart ${chart}`,
  summary: (charts: number, largest: number, cutEdges: number, stretchRatio: number) => {
    const which = charts > 1 ? ', the largest' : '';
    const sizes = `${counted(charts, 'chart')}${which} of ${counted(largest, 'triangle')}`;
    const cuts = cutEdges > 0 ? `cut along ${counted(cutEdges, 'edge')}` : 'nothing was cut';
    return `${sizes}; ${cuts}; average stretch ratio ${measure(stretchRatio)}`;
  },
};

export const LOCKS = {
  column: 'Locked',
  lock: (chart: number) => `Lock chart ${chart}`,
  about: 'Locked: the chart keeps its shape and place, whatever else changes',
  locked: (chart: number) => `Locked chart ${chart}`,
  unlocked: (chart: number) => `Unlocked chart ${chart}`,
  summary: (n: number) => (n > 0 ? `${counted(n, 'chart')} locked` : 'Locked charts stay in place'),
};

/** By abflat's names. */
export const SOLVERS = {
  activeSet: 'Active set',
  interiorPoint: 'Interior point',
  tutte: "Tutte's embedding",
};

/** How the solver found a layout. */
export const SOLVER = {
  hint: 'Point at a step to see its numbers.',
  summary: (solver: string, steps: number, converged: boolean, residual: number) => {
    const end = converged
      ? `converged to ${measure(residual)}`
      : `not converged (${measure(residual)})`;
    return `${solver}, ${counted(steps, 'step')}, ${end}`;
  },
};

/** The charts of the solver's steps. */
export const CONVERGENCE = {
  step: 'Step',
  residual: 'Residual',
  aboutResidual:
    'How far each solver step is from meeting the constraints and from the least distortion.',
  constraint: 'Constraint',
  gradient: 'Gradient',
  constraintResidual: 'Constraint residual',
  gradientResidual: 'Gradient residual',
  activeSet: 'Active set',
  aboutActiveSet: 'How many boundary vertices and interior edges each step holds at their bounds.',
  vertices: 'Boundary vertices',
  edges: 'Interior edges',
  atStep: (step: number, constraint: number, gradient: number, vertices: number, edges: number) =>
    `Step ${step}: constraint ${measure(constraint)}, gradient ${measure(gradient)}, ${count(vertices)}${
      edges > 0 ? ` + ${count(edges)}` : ''
    } at their bound`,
};

/** The tab that plots distortion over t. */
export const SWEEP = {
  start: 'Plot against t',
  hint: 'Select a point to use its t.',
  progress: (done: number, all: number) => `${done} of ${all}`,
  skipped: (values: Bound[]) => `${values.join(', ')}: not possible for this mesh`,
};

/** The chart of distortion over t. */
export const SWEEP_CHART = {
  title: 'Angular distortion',
  about:
    'Angular distortion of layouts with several t. Layouts that are not valid are drawn as circles.',
  t: 't',
  auto: 'auto',
  notPossible: 'not possible',
  yes: 'yes',
  no: 'no',
  point: (t: Bound, distortion: number, verdict: string) =>
    `t = ${bound(t)}: ${measure(distortion)}, ${verdict}.`,
};

/** The tab that compares methods. */
export const METHODS = {
  start: 'Compare methods',
  progress: (fraction: number) => `${Math.round(100 * fraction)}\u202f%`,
  caption: 'Methods',
  method: 'Method',
};

/** The columns of the methods' table. */
export const METHOD_COLUMNS = {
  time: { name: 'Time', title: 'Time for the layout only' },
  angle: { name: 'Angle', title: 'Angular distortion: mean over corners of ((x - α)/α)²' },
  length: { name: 'Length', title: 'Length distortion: mean over edges of (sL/l - 1)²' },
  area: {
    name: 'Area',
    title: 'Area distortion: mean by 3D area of |log(area in the layout / area in 3D)|',
  },
  flips: { name: 'Flips', title: 'Flipped triangles' },
  crossings: { name: 'Cross.', title: 'Pairs of boundary edges that cross or touch' },
};

/** Copying all numbers of a result. */
export const REPORT = {
  copied: 'Statistics copied as JSON',
  notCopied: 'Nothing was copied: the browser keeps this page from the clipboard.',
  allow:
    'Allow it in the settings beside the address. If there is no such setting, open the page over https or from localhost.',
};

// Rooms: session, seams, selection, help, and the top room
