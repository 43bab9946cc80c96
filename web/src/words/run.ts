// What happens to a mesh, and the history of that.

import { type Bound, bound, count, counted, ended } from './format';

/** What laying out a mesh in one piece and in charts is called; `verb` is on a button. */
export const LAYING_OUT = {
  flatten: { doing: 'Flattening', done: 'Flattened', verb: 'Flatten' },
  unwrap: { doing: 'Unwrapping', done: 'Unwrapped', verb: 'Unwrap' },
  pack: { doing: 'Repacking', done: 'Repacked', verb: 'Repack' },
};

/** The same for the UVs of a file as they are. */
export const LOOKING_AT_UVS = { doing: 'Checking', done: 'Checked', verb: 'File UVs' };

/** The settings of a layout, which are listed in one line. */
export const SETTINGS = {
  seamEdges: (edges: number) => counted(edges, 'seam edge'),
  seams: (sources: string) => `seams ${sources}`,
  stretch: (most: number) => `stretch up to ${most}`,
  size: (pixels: number, padding: number) => `${pixels}\u202fpx, padding ${padding}`,
  balance: (balance: number) => `balance ${balance}`,
  delaunay: 'Delaunay',
  uvsOfFile: 'UVs as in the file',
  changedUvs: 'UVs changed by hand',
  margin: (margin: number | 'auto') => `margin ${margin}`,
  rotation: (rotation: string) => `rotation ${rotation}`,
  sizes: (sizes: string) => `sizes ${sizes}`,
  tiles: (tiles: string) => `tiles ${tiles.toLowerCase()}`,
  ownBounds: (vertices: number) => `own bounds of ${counted(vertices, 'vertex', 'vertices')}`,
  t: (t: Bound) => `t = ${bound(t)}`,
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
  pack: 'Packing islands',
  check: 'Checking',
  write: 'Writing',
};

export const SOLVER_PROGRESS = {
  atStep: (stage: string, step: number, residual: number) =>
    `${stage}, step ${step}, residual ${residual.toExponential(0)}`,
  left: (doing: string, seconds: number) =>
    `${doing}, about ${seconds < 90 ? `${seconds}\u202fs` : `${Math.round(seconds / 60)}\u202fmin`} left`,
};

/** What happens to a mesh, and how that ends. */
export const RUN = {
  reading: (title: string) => `Reading ${title}`,
  layingOut: (doing: string, settings: string) => `${doing} with ${settings}`,
  checked: (change: string, time: string) => `${change}, checked in ${time}`,
  laidOut: (done: string, time: string) => `${done} in ${time}`,
  but: (badge: string) => `, ${badge.toLowerCase()}`,
  ownBounds: (bounds: number) => `; ${counted(bounds, 'own bound')}`,
  repacked: '; repacked, because there was too little room',
  unstacked: (charts: number) => `; ${counted(charts, 'island')} no longer stacked`,
  kept: 'kept',
  locked: 'locked',
  keptAsInFile: 'as in the file',
  keptAndFixed: (kept: number, fixed: number, fixedAs: string) =>
    `; ${count(kept)} kept, ${count(fixed)} ${fixedAs}`,
  someCharts: (some: number, charts: number, what: string) =>
    `; ${count(some)} of ${counted(charts, 'island')} ${what}`,
  shownAgain: (title: string) => `${title} is as you left it`,
  asLeft: 'This layout is as you left it',
  cancelled: 'Cancelled',
  notOpened: (title: string) => `${title} was not opened`,
  nothingOpened: 'Nothing was opened',
  notLaidOut: (done: string) => `Not ${done.toLowerCase()}`,
  tryAgain: 'Try again',
  /** `done`: what was not; null: the mesh was not opened. */
  failed: (title: string, done: string | null, why: string) =>
    `${title} was not ${done === null ? 'opened' : done.toLowerCase()}: ${ended(why)}`,
};

/** Why an atlas has too little room, and what helps. */
export const NO_ROOM = {
  /** `isOne`: a single chart is too large; `most`: the density that fits; `enough`: a resolution that does, if one is offered. */
  tooDense: (
    density: number,
    resolution: number,
    isOne: boolean,
    most: number,
    enough: number | undefined,
  ) => {
    const what = isOne ? 'one island does not fit a tile' : 'the islands do not fit one tile';
    const ways = [
      `Set Texel density, under More, to auto or to at most ${most}`,
      ...(enough ? [`choose a resolution of ${count(enough)}\u202fpx`] : []),
      ...(isOne ? [] : ['switch on UDIM tiles']),
    ];
    const either = [ways.slice(0, -1).join(', '), ways.at(-1)].filter(Boolean).join(', or ');
    return `at ${density} texels per unit, ${what} of ${count(resolution)}\u202fpx. ${either}.`;
  },
};

/** Steps in the history. */
export const CHANGES = {
  opened: (title: string) => `Open ${title}`,
  followedLink: 'Settings of a link',
  t: (t: Bound) => `Boundary t ${bound(t)}`,
  balance: (balance: number) => `Balance ${balance}`,
  delaunay: (isOn: boolean) => (isOn ? 'Delaunay' : 'Delaunay off'),
  bounds: (vertices: number) => `Bounds of ${counted(vertices, 'vertex', 'vertices')}`,
  noBounds: 'No painted bounds',
  maxStretch: (most: number) => `Max stretch ${most}`,
  resolution: (pixels: number) => `Resolution ${pixels}\u202fpx`,
  padding: (texels: number) => `Padding ${texels}`,
  seams: (sources: string) => `Seams: ${sources.replaceAll(',', ', ')}`,
  seamEdges: (edges: number) => `Seams of ${counted(edges, 'edge')}`,
  noSeamEdges: 'Seams as chosen',
  keepUvs: 'Keep UVs of the file',
  keepNoUvs: 'Keep UVs of the file off',
  fileUvs: 'UVs as in the file',
  packIslands: 'Repack',
  margin: (texels: number | 'auto') => `Margin ${texels}`,
  sizes: (sizes: string) => `Sizes ${sizes}`,
  tiles: (tiles: string) => `Tiles: ${tiles.toLowerCase()}`,
  packedAgain: 'Repacked',
  switched: (label: string, isOn: boolean) => (isOn ? label : `${label} off`),
  set: (label: string, value: unknown) => `${label} ${value}`,
  undone: (step: string) => `Undone: ${step}`,
  redone: (step: string) => `Redone: ${step}`,
};

/** The titles of the undo and redo buttons; `what` is null if there is nothing to do. */
export const STEP_BUTTONS = {
  undo: (what: string | null) => (what === null ? 'Undo (Ctrl+Z)' : `Undo: ${what} (Ctrl+Z)`),
  redo: (what: string | null) =>
    what === null ? 'Redo (Ctrl+Shift+Z)' : `Redo: ${what} (Ctrl+Shift+Z)`,
};
