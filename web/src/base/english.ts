// Everything that the page's scripts say to people, by room and with the numbers and names that go into it. What is always on the page
// is in index.html. Errors that only a developer can meet stay where they are thrown.

import { type Bound, bound, count, counted, ended, listed, measure } from './format';
import { MESH_NAMES } from './generated-formats';

const MESHES = `${MESH_NAMES.slice(0, -1).join(', ')} or ${MESH_NAMES.at(-1)}`;

// Rooms: base, view, drawing, mesh, files, workshop, opening, export

/** Said where a part of the page or a worker is missing. */
export const LOST = {
  notLoaded: 'a part of this page could not be loaded. Check the connection, then try again.',
  stopped: 'its worker stopped, possibly because memory ran out. Close other tabs, then try again.',
  noWorker: 'A worker could not be loaded.',
};

export const ALERT = { close: 'Close this message' };

export const THEME = { use: (theme: string) => `Use the ${theme} theme` };

export const GRID = {
  notDrawn: 'This browser cannot draw the numbered grid.',
  lines: (texels: number) => `grid ${counted(texels, 'texel')}`,
  cells: (texels: number) => `cells of ${counted(texels, 'texel')}`,
};

export const SHADINGS = {
  materials: 'Materials',
  image: (name: string) => `Image: ${name}`,
  otherImage: 'Other image\u2026',
};

/** An image of the user's own. Sizes are width and height in pixels. */
export const OWN_IMAGE = {
  pressEnter: 'Press Enter to choose an image',
  shown: (name: string) => `Showing ${name}`,
  oneOfMany: (name: string, images: number) => `You chose ${images} images. ${name} is shown.`,
  scaledDown: (name: string, [width, height]: number[], [most, high]: number[]) =>
    `${name} is ${count(width)} × ${count(height)} pixels, more than your graphics card supports. It is shown at ${count(most)} × ${count(high)}.`,
  damaged: (name: string) =>
    `${name} is damaged or too large to show. Save it again as PNG, JPEG or WebP.`,
  unknown: (name: string) => `This browser cannot decode ${name}. Save it as PNG, JPEG or WebP.`,
};

/** `title`: what is measured; values and shares come as texts. */
export const HEAT_LEGEND = {
  andLess: (value: string) => `${value} or less`,
  andMore: (value: string) => `${value} or more`,
  fromTo: (title: string, from: string, to: string) => `${title} ${from} to ${to}`,
  percent: (value: string) => `${value}\u202f%`,
  underPercent: (value: string) => `under ${value}\u202f%`,
  ofSurface: (range: string, share: string) => `${range}: ${share} of the surface`,
  selectBar: 'A bar highlights its faces',
  worst: 'The worst 1\u202f% of the surface',
};

/** Meanings of marks. */
export const MARKS = {
  invalidCharts: (n: number) => counted(n, 'chart is not valid', 'charts are not valid'),
  tightened: (n: number) => counted(n, 'tightened vertex', 'tightened vertices'),
  crossings: (n: number) => counted(n, 'crossing'),
  resisting: (n: number) => `${counted(n, 'edge')} cannot be made Delaunay`,
  delaunay: (before: number, after: number) =>
    `Delaunay: distortion ${measure(before)} \u2192 ${measure(after)}`,
};

/** Why a glTF or GLB cannot be read or written. */
export const GLTF = {
  needs: (name: string, wanted: string | undefined) =>
    `${name} needs ${wanted}: open or drop both files together.`,
  truncated: (name: string, there: number, length: number) =>
    `${name} is truncated: it has only ${count(there)} of ${count(length)} bytes. Copy or download it again.`,
  unknownExtension: (name: string, extension: string) =>
    `${name} requires ${extension}, which this page cannot read. Save it without that extension.`,
  otherVersion: (name: string) => `${name} is not glTF 2.0. Save it as glTF 2.0 or GLB.`,
  /** `reason` is a sentence of the browser. */
  notJson: (name: string, reason: string) =>
    `${name} is not a glTF file, because it is not valid JSON: ${ended(reason)} Export or download it again.`,
  notGlb: (name: string) =>
    `${name} is not a GLB file, because it does not begin with "glTF". Export or download it again.`,
  noTriangles: (name: string) => `${name} has no triangles, so there is nothing to unwrap.`,
  damaged: (name: string, reason: string) =>
    `${name} is damaged or too large to read (${reason}). Export or download it again.`,
  undecodable: (name: string, compressions: string[], reason: string) =>
    `${name} is damaged: its ${compressions.join(' and ')} data cannot be decoded (${reason}). Export or download it again.`,
  attributeMissing: 'an attribute is missing',
  senselessView: (view: number) => `buffer view ${view} is invalid`,
  tooLarge: 'Its coordinates are too large for GLB. Scale the mesh down, or choose OBJ',
};

/** Files that a mesh names. */
export const LOOK_FILES = {
  missing: (mesh: string, files: string[]) => {
    const what = files.some((file) => /\.mtl$/i.test(file)) ? 'Materials' : 'Textures';
    const them = files.length > 1 ? 'them' : 'it';
    return `${what} not shown: ${listed(files)} not found. UVs are unaffected. Drop ${them} together with ${mesh} to see ${them}.`;
  },
  undecoded: (files: string[]) =>
    `This browser cannot decode ${listed(files)}: save ${files.length > 1 ? 'them' : 'it'} as PNG or JPEG.`,
  /** One without a name. */
  image: (number: number) => `image ${number}`,
};

/** Pictures of an atlas. */
export const ATLAS_PICTURE = {
  tooLarge: (most: number) =>
    `a picture can have at most ${most} pixels per side. Lower the resolution, or save SVG`,
  noMemory:
    'the browser does not have enough memory for a picture this large. Lower the resolution, or save SVG',
};

/** Choosing or dropping files. */
export const CHOSEN_FILES = {
  noMesh: (names: string[]) => {
    const what =
      names.length === 1
        ? `${names[0]} is not a mesh`
        : `None of these ${names.length} files is a mesh`;
    return `${what}. Open an ${MESHES} file, along with any files it needs.`;
  },
  emptyFolder: 'The folder is empty. Drop a mesh, or a folder that contains one.',
  tooMany: (most: number) =>
    `The folder holds more than ${most} files. Drop only the mesh and the files it needs.`,
  unreadable: 'The file was moved or deleted, so it cannot be read. Open it again.',
};

/** Files that take time to get. */
export const GATHERING = {
  got: (name: string) => `Got ${name}`,
  notOpened: (name: string) => `${name} was not opened`,
  cancelled: 'Cancelled',
};

export const JOINING = {
  meshes: (n: number) => counted(n, 'mesh', 'meshes'),
  joining: (n: number) => `Joining ${counted(n, 'mesh', 'meshes')}`,
};

/** Meshes from the web. Sizes are in bytes. */
export const FETCHING = {
  started: (name: string, host: string) => `Fetching ${name} from ${host}`,
  progress: (name: string, received: number, total: number | null) => {
    const size = (bytes: number) => (bytes / 1e6).toFixed(1);
    return `Fetching ${name}: ${size(received)}${total === null ? '' : ` of ${size(total)}`}\u202fMB`;
  },
  tooManyNamed: (found: number, most: number) =>
    `The mesh refers to ${found} other files, but at most ${most} can be fetched. Download all of them, then open the folder.`,
};

/** Why nothing is fetched from an address. */
export const ADDRESSES = {
  password: (host: string) =>
    `The address of the mesh on ${host} contains a password, so it was not opened. Download the file, then open it.`,
  notHttps: (address: string) =>
    `${address} was not opened, because it does not begin with https://. Use an https address, or download the file.`,
  invalid: (text: string) => `"${text}" is not an address. Check the link.`,
};

/** Why fetching failed. */
export const FETCH_FAILED = {
  empty: (name: string, host: string) =>
    `${name} at ${host} is empty. Check the address, or ask who published it.`,
  webPage: (name: string, host: string) =>
    `${host} sent a web page instead of ${name}. Use the address of the file itself.`,
  offline: (name: string, host: string) =>
    `${name} could not be fetched from ${host}, because there is no network connection. Connect, then open it again.`,
  unreachable: (name: string, host: string) =>
    `${name} could not be fetched from ${host}: the server cannot be reached, or does not allow other sites to read the file (CORS). Download the file, then open it.`,
  notThere: (name: string, host: string, status: number) =>
    `${host} has no ${name} (${status}). Check the address.`,
  notAllowed: (name: string, host: string, status: number) =>
    `${host} requires you to sign in for ${name} (${status}). Sign in there, download the file, then open it.`,
  refused: (name: string, host: string, status: number) =>
    `${host} did not send ${name} (${status}). Try again later, or download the file and open it.`,
  interrupted: (name: string) => `The connection was lost while fetching ${name}. Open it again.`,
};

/** Everything that is asked in a sheet of its own. */
export const QUESTION = { cancel: 'Cancel' };

/** Asked before anything is fetched. Sizes come as texts. */
export const WEB_SHEET = {
  openFrom: (name: string, host: string) => `Open ${name} from ${host}?`,
  /** `size`: '' if it is not known. */
  whatHappens: (host: string, size: string, namesFiles: boolean) =>
    `Your browser fetches this mesh${size && ` (${size})`}${namesFiles ? ' and the files it refers to' : ''} from ${host}, which sees your IP address. Your own meshes never leave your machine.`,
  open: 'Open',
  fetchLarge: (size: string) => `Fetch ${size}?`,
  large: (name: string, size: string) =>
    `${name} is larger than most meshes: ${size} or more. Fetching and unwrapping it may take a long time.`,
  fetch: 'Fetch',
  megabytes: (size: string) => `${size}\u202fMB`,
};

export const MESH_TABS = {
  tab: (title: string, isUnsaved: boolean) =>
    `${title}${isUnsaved ? ', edits not exported' : ''} (Delete closes it)`,
  unsaved: ', edits not exported',
  close: (title: string) => `Close ${title} without exporting it?`,
  whatIsLost: 'Its edits have not been exported. Closing it discards them.',
  closeIt: 'Close without exporting',
};

export const SAMPLES = {
  samples: 'Samples',
  sample: (title: string) => `Sample: ${title}`,
};

/** What there is to see in each sample. */
export const ABOUT_SAMPLES: Record<string, string> = {
  hemisphere: 'half a sphere',
  'wavy-strip': 'long and bent',
  head: 'cut at the neck',
  'alpha-band': 'overlaps when flat',
  'three-balls': 'tight necks',
  pumpkin: 'closed, textured',
};

/** `format` in capitals; `set`: a texcoord set of a glTF, by the name that its choice gives it. */
export const EXPORT = {
  export: (format: string) => `Export ${format}`,
  exportLast: 'Export last layout',
  previous: (settings: string) => `Exports the layout still on screen: ${settings}`,
  writing: (format: string) => `Writing ${format}`,
  exported: (name: string, size: string) => `Exported ${name}, ${size}`,
  shapeOnly: ', shape and UVs only',
  uncompressed: ', uncompressed',
  notExported: 'Not exported',
  cancelled: 'Export cancelled',
  rounded:
    'GLB stores single precision, and rounding makes some triangles flip or overlap. OBJ keeps all digits',
  replaced: (set: number) => `New UVs replaced UV\u00a0${set}`,
  replacedPainted: (set: number) => `New UVs replaced UV\u00a0${set}, which textures use`,
  added: (set: number) => `New UVs are UV\u00a0${set}`,
  addedToPainted: (set: number) => `New UVs are UV\u00a0${set}; textures keep theirs`,
};

/** Files that were saved. */
export const SAVED = {
  saved: (name: string, size: string) => `Saved ${name}, ${size}`,
  kilobytes: (bytes: number) => `${count(Math.ceil(bytes / 1024))}\u202fKB`,
  pixels: (width: number, height: number) => `${count(width)}\u202f×\u202f${count(height)}\u202fpx`,
};

export const VIEWS_PICTURE = {
  notMade: 'The browser could not make the picture. Make the window smaller.',
  noMemory: 'The browser ran out of memory for the picture. Close other tabs.',
};

// Rooms: model, controls, plot, details

/** The measures of the heat maps. */
export const HEAT_MAPS = {
  angle: {
    title: 'Angle error',
    explanation: 'Relative change of a triangle’s angles',
  },
  area: {
    title: 'Area',
    explanation: 'UV area divided by 3D area; below 1, a face has fewer texels than average',
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
  up: 'Up axis',
  rotate: 'Rotation',
  rectify: 'Rectify',
  packingCuts: 'Cut to pack tighter',
  stack: 'Stack equal charts',
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
};

/** The slider for the limit of stretch, and the size of an atlas. */
export const STRETCH_LIMIT = {
  more: 'more seams',
  fewer: 'fewer seams',
  lengths: (percent: number) => `lengths off by up to ${percent}\u202f%`,
  notEnforced: 'not enforced',
  about: 'Limit for the average stretch of each chart. A lower limit adds seams and charts',
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

export const MODE_HINTS = { flatten: 'one chart', unwrap: 'charts in one texture' };

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
  /** `reason` is a sentence. */
  flatten: (reason: string, need = 'Needs a mesh that is a disk') => `${need}. ${reason}`,
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

/** The choices of a glTF's texcoord sets. */
export const UV_SETS = {
  read: (set: number) => `UV ${set}`,
  title: (name: string, set: number) => `${name}, UV ${set}`,
  added: (set: number) => `UV ${set}, new`,
  replaced: (set: number) => `UV ${set}, replaced`,
};

export const VALIDITY = { valid: 'valid', notValid: 'not valid', column: 'Valid' };

/** What runs in a tab of the details. */
export const TAB_JOBS = { stop: 'Stop', stopped: 'Stopped', starting: 'Starting' };

export const BADGES = {
  valid: 'Valid',
  uneven: 'Uneven',
  stretched: 'Stretched',
  notValid: 'Not valid',
  none: 'No result',
} as const;

/** Why a result has its badge. */
export const VERDICT = {
  noCrossings: 'No flipped triangles, no crossings',
  noOverlaps: 'No flipped triangles, no overlaps',
  stacked: (charts: number) => `${counted(charts, 'chart')} stacked, no other overlaps`,
  uneven: (least: number, most: number) =>
    `Texel density ${measure(least)} to ${measure(most)}: repack to even out`,
  unevenBesideKept: (least: number, most: number) =>
    `Texel density ${measure(least)} to ${measure(most)}: kept UVs keep theirs`,
  lengthsChange: (share: number) =>
    `Lengths change by ${count(100 * share)}\u202f% on average: seams would help`,
  stretched: (most: string, limit: number, charts: number, all: number) => {
    const upTo = charts > 1 ? 'up to ' : '';
    const where = all > 1 ? ` in ${count(charts)} of ${count(all)} charts` : '';
    return `Stretch ${upTo}${most}${where}; limit ${limit}`;
  },
  outside: (charts: number) =>
    `${counted(charts, 'chart')} outside ${charts === 1 ? 'its tile' : 'their tiles'}`,
  overlapping: (charts: number) => counted(charts, 'chart overlaps another', 'charts overlap'),
  /** `problem` is that of the first. */
  defects: (charts: number, problem: string) =>
    charts === 1
      ? `1 chart is not valid: ${problem}`
      : `${count(charts)} charts are not valid. In the first, ${problem}`,
};

/** What is wrong with a chart, in the words of abflat. */
export const DEFECTS = { both: (one: string, other: string) => `${one}, and ${other}` };

/** What the user can do about a verdict. */
export const REMEDIES = {
  cut: {
    label: 'Cut further',
    title: 'Keep these seams and add automatic ones until every chart is within the limit',
  },
  pack: {
    label: 'Repack',
    title: 'Pack the same charts again, all at the same texel density',
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
      'Symmetric Dirichlet energy / 4, mean over the surface, each chart at its own scale; 1 keeps all lengths. The stretch ratio in Details ignores changes of size; there, 1 keeps all angles',
  },
  angle: {
    label: 'Angular distortion',
    title: 'Mean over the surface of ((x - α)/α)², x in the layout, α in 3D',
  },
  utilization: {
    label: 'Utilisation',
    title: 'Share of the square, or of all tiles, that the charts cover',
  },
  texelDensity: {
    label: 'Texel density',
    title: 'Texels per mesh unit at this resolution, on average over the surface',
  },
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
  previous: 'Figures of the previous layout',
  ofResult: "Figures of abflat's layout",
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
    `${counted(n, 'face touches itself', 'faces touch themselves')}: ${places}`,
  duplicates: (n: number, places: string) =>
    `${counted(n, 'duplicate face has its own chart', 'duplicate faces have their own charts')}: ${places}`,
  nonManifold: (n: number, places: string) =>
    `${counted(n, 'edge has', 'edges have')} more than two faces and ${n === 1 ? 'became a seam' : 'became seams'}: ${places}`,
  conflicts: (n: number, places: string) =>
    `${counted(n, 'edge lies', 'edges lie')} between faces of opposite orientation and ${n === 1 ? 'became a seam' : 'became seams'}: ${places}`,
  noArea: (n: number) =>
    `${counted(n, 'triangle has', 'triangles have')} no area and ${n === 1 ? 'was' : 'were'} given artificial angles`,
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
  stacked: (others: number[]) =>
    `Stacked with ${others.length > 1 ? 'charts' : 'chart'} ${listed(others.map(count))}`,
  summary: (charts: number, largest: number, cutEdges: number, stretchRatio: number) => {
    const which = charts > 1 ? ', the largest' : '';
    const sizes = `${counted(charts, 'chart')}${which} of ${counted(largest, 'triangle')}`;
    const cuts = cutEdges > 0 ? `cut along ${counted(cutEdges, 'edge')}` : 'nothing was cut';
    return `${sizes}; ${cuts}; average stretch ratio ${measure(stretchRatio)}`;
  },
  aboutSummary:
    'Stretch ratio: how many times as much a triangle stretches in one direction as across it, mean over the surface; 1 keeps all angles. Stretch, above, also counts changes of size',
};

export const LOCKS = {
  column: 'Locked',
  lock: (chart: number) => `Lock chart ${chart}`,
  about: 'Locked: the chart keeps its shape and position, whatever else changes',
  locked: (chart: number) => `Locked chart ${chart}`,
  unlocked: (chart: number) => `Unlocked chart ${chart}`,
  keptUvs: 'Kept UVs stay in place; switch Keep UVs off to move them',
  summary: (locked: number, keptUvs: number) => {
    const texts = [
      ...(locked > 0 ? [`${counted(locked, 'chart')} locked`] : []),
      ...(keptUvs > 0 ? [`${counted(keptUvs, 'chart keeps its', 'charts keep their')} UVs`] : []),
    ];
    return texts.length > 0 ? texts.join(', ') : 'Locked charts stay in place';
  },
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
    'How far each solver step is from meeting the constraints and from minimal distortion.',
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
  about: 'Angular distortion for different values of t. Circles are layouts that are not valid.',
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
  notCopied: 'Nothing was copied, because the browser blocks the clipboard for this page.',
  allow:
    'Allow it in the site settings, next to the address. If there is no such setting, open the page over https or from localhost.',
};

// Rooms: session, seams, selection, arrange, help, and the top room

/** What laying out a mesh in one piece and in charts is called; `verb` is on a button. */
export const LAYING_OUT = {
  flatten: { doing: 'Flattening', done: 'Flattened', verb: 'Flatten' },
  unwrap: { doing: 'Unwrapping', done: 'Unwrapped', verb: 'Unwrap' },
};

/** The settings of a layout, which are listed in one line. */
export const SETTINGS = {
  seamEdges: (edges: number) => counted(edges, 'seam edge'),
  seams: (sources: string) => `seams ${sources}`,
  stretch: (most: number) => `stretch up to ${most}`,
  size: (pixels: number, padding: number) => `${pixels}\u202fpx, padding ${padding}`,
  balance: (balance: number) => `balance ${balance}`,
  delaunay: 'Delaunay',
  ownBounds: (vertices: number) => `own bounds of ${counted(vertices, 'vertex', 'vertices')}`,
  t: (t: Bound) => `t = ${bound(t)}`,
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
  packedAgain: 'Repacked',
  switched: (label: string, isOn: boolean) => (isOn ? label : `${label} off`),
  set: (label: string, value: unknown) => `${label} ${value}`,
  undone: (step: string) => `Undone: ${step}`,
  redone: (step: string) => `Redone: ${step}`,
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
  unstacked: (charts: number) => `; ${counted(charts, 'chart')} no longer stacked`,
  kept: 'kept',
  locked: 'locked',
  keptAsInFile: 'as in the file',
  keptAndFixed: (kept: number, fixed: number, fixedAs: string) =>
    `; ${count(kept)} kept, ${count(fixed)} ${fixedAs}`,
  someCharts: (some: number, charts: number, what: string) =>
    `; ${count(some)} of ${counted(charts, 'chart')} ${what}`,
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
    const what = isOne ? 'one chart does not fit a tile' : 'the charts do not fit one tile';
    const ways = [
      `Set Texel density, under More, to auto or to at most ${most}`,
      ...(enough ? [`choose a resolution of ${count(enough)}\u202fpx`] : []),
      ...(isOne ? [] : ['switch on UDIM tiles']),
    ];
    const either = [ways.slice(0, -1).join(', '), ways.at(-1)].filter(Boolean).join(', or ');
    return `at ${density} texels per unit, ${what} of ${count(resolution)}\u202fpx. ${either}.`;
  },
};

/** What is on screen. */
export const SHOWN = {
  pageTitle: (title: string) => `${title} \u2013 abflat`,
  triangles: (triangles: number) => counted(triangles, 'triangle'),
  polygons: (faces: number, triangles: number) =>
    `${counted(faces, 'polygon')}, ${counted(triangles, 'triangle')}`,
  charts: (charts: number, tiles: number) =>
    counted(charts, 'chart') + (tiles > 1 ? `, ${counted(tiles, 'tile')}` : ''),
  /** What charts look like. */
  shapes: {
    rectangle: (charts: number) => counted(charts, 'rectangle'),
    strip: (charts: number) => counted(charts, 'strip'),
    disc: (charts: number) => counted(charts, 'disc'),
    ring: (charts: number) => counted(charts, 'ring'),
  },
  symmetric: 'symmetric',
  packingCuts: (cuts: number) => `${count(cuts)} cut to pack tighter`,
  t: (t: Bound) => `t = ${bound(t)}`,
  /** `t` is null where the boundary is free, except at tightened vertices. */
  automaticT: (t: number | null, tightened: number) => {
    const but = tightened > 0 ? ` except at ${counted(tightened, 'vertex', 'vertices')}` : '';
    return `t = auto: ${t === null ? 'free' : bound(t)}${but}`;
  },
  owner: (title: string, settings: string) => `${title}, ${settings}`,
  previous: 'Previous layout',
  noLayout: 'No layout yet',
  stillShown: (what: string) => `Still showing ${what}.`,
  comparison: (method: string) => `Comparison, not exported: ${method}`,
  noMaterials: (name: string) =>
    `The materials of ${name} could not be read. To see them, open it again.`,
  noWebGl:
    'WebGL 2 is off or missing in this browser, so nothing can be drawn. Unwrapping and export still work.',
};

/** Why a mesh cannot be read. */
export const READING = {
  noMesh: 'Open a mesh first.',
  empty: (name: string) => `${name} is empty. Export or download it again.`,
  notSupported: (name: string) => `${name} is not supported. Use ${MESHES}.`,
  /** A file of a 3D program. */
  scene: (name: string) =>
    `${name} is not supported. Export it as glTF from Blender, Maya or the program that made it, then drop that file.`,
  withoutFaces: (name: string, vertices: number) => {
    const content =
      vertices > 0 ? `${counted(vertices, 'vertex', 'vertices')} but no faces` : 'no faces';
    return `${name} has ${content}, so there is nothing to unwrap. Save it with its faces.`;
  },
  /** `reason` is a sentence of the browser. */
  unreadable: (name: string, reason: string) =>
    `${name} cannot be read. ${ended(reason)} Choose the file again.`,
};

/** Why nothing is saved. */
export const SAVING = {
  notDrawn: 'Nothing is drawn, so there is no picture',
  failed: (title: string, message: string) => `${title} was not saved: ${ended(message)}`,
  cameOutDifferently: 'This run gave a different layout. Unwrap again, then export.',
};

/** The mesh and settings that the page starts with. */
export const VISIT = {
  restored: (title: string) => `Restored ${title} from your last visit`,
  stoppedOpening: 'Your last mesh was not reopened, because the page stopped while opening it.',
  tooLarge: 'Your last mesh was too large to keep. Open it again.',
  unreadable: 'Your last visit could not be restored.',
  notRestored: (title: string, message: string) =>
    `${title} could not be restored from your last visit: ${ended(message)}`,
  notOffered: (words: string) => `The link asks for ${words}, which this page does not offer.`,
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

/** Where seams come from. */
export const SEAM_SOURCES = {
  sharpAngle: 'Sharp angle',
  sharpRange: 'above 0 and at most 180 degrees',
  degrees: (degrees: number) => `${degrees}°`,
  edited: (edges: number, isCutFurther: boolean) =>
    `seams edited: ${counted(edges, 'edge')}${isCutFurther ? ', cut further' : ''}`,
  none: 'fewest possible seams',
};

/** A loop that ends at once is an edge. */
const loopOf = (edges: number) => (edges === 1 ? '1 edge' : `a loop of ${counted(edges, 'edge')}`);

/** Seams that are edited. */
export const SEAMS = {
  toCut: 'Click a vertex to start a cut, double-click to cut a loop',
  toJoin: 'Click a seam to join its sides',
  toPaint: 'Drag over the mesh to paint a seam',
  toErase: 'Drag over seams to erase them',
  toSelect: 'Click a chart to select it',
  startHere: (vertex: number) => `Vertex ${vertex}: start a cut`,
  paintHere: (vertex: number) => `Vertex ${vertex}: drag to paint a seam, or click to start a cut`,
  orCutLoop: (start: string, edges: number) => `${start}. Double-click: cut ${loopOf(edges)}`,
  cutTo: (from: number, to: number, edges: number, length: number) =>
    `Vertex ${from} to ${to}: cut ${counted(edges, 'edge')}, ${measure(length)} long`,
  toEndCut: (from: number) => `From vertex ${from}: click the end of the cut, Esc cancels`,
  /** There is a button for it. */
  toEndCutByTouch: (from: number) => `From vertex ${from}: tap the end of the cut, or Cancel cut`,
  joinHere: (edges: number) => `Seam of ${counted(edges, 'edge')}: join`,
  neededHere: (edges: number) =>
    `Seam of ${counted(edges, 'edge')}: needed to keep its chart a disk`,
  started: (vertex: number) => `Cut started at vertex ${vertex}`,
  notConnected: (from: number, to: number) => `No edges connect vertex ${from} to vertex ${to}`,
  cut: (edges: number) => `Cut ${counted(edges, 'edge')}`,
  cutLoop: (edges: number) => `Cut ${loopOf(edges)}`,
  alreadyCut: 'Already cut',
  cancelled: 'Cut cancelled',
  joined: (edges: number) => `Joined ${counted(edges, 'edge')}`,
  needed: 'This seam is needed to keep its chart a disk',
  painting: (edges: number) => `Painting ${counted(edges, 'edge')} as seam, Esc cancels`,
  painted: (edges: number) => `Painted ${counted(edges, 'edge')} as seam`,
  /** Along boundaries and seams only. */
  nothingPainted: 'Nothing to cut along this stroke',
  erasing: (edges: number) => `Erasing ${counted(edges, 'seam edge')}, Esc cancels`,
  erased: (edges: number) => `Erased ${counted(edges, 'seam edge')}`,
  nothingErased: 'No seam under this stroke',
  strokeCancelled: 'Stroke cancelled',
  cutFurther: 'Cut further',
  /** Edges that are not cut yet. */
  sharp: (edges: number, degrees: number) =>
    edges === 0
      ? `No other edge bends by more than ${degrees}°`
      : `${counted(edges, 'edge')} ${edges === 1 ? 'bends' : 'bend'} by more than ${degrees}°`,
  markedSharp: (edges: number) => `Marked ${counted(edges, 'sharp edge')}`,
  notEditable: (reason: string) => `Seams cannot be edited: ${reason}`,
};

/** Files with seams; `where`: their name and a line. */
export const SEAM_FILES = {
  saved: (name: string) => `Saved ${name}`,
  opened: (name: string) => `Seams of ${name}`,
  where: (name: string, line: number) => `${name}:${line}`,
  notTwoNumbers: (where: string) => `${where}: expected two vertex numbers, such as '17 42'.`,
  noVertex: (where: string, vertex: number, last: number) =>
    `${where}: there is no vertex ${vertex}; the last one is ${last}.`,
  noEdge: (where: string, from: number, to: number) =>
    `${where}: ${from}-${to} is not an edge of any face.`,
};

/** Charts that are selected or hidden. */
export const SELECTION = {
  hidden: (charts: number) => `${counted(charts, 'chart')} hidden`,
  one: (chart: number, triangles: number, stretch: number) =>
    `Chart ${count(chart)}: ${counted(triangles, 'triangle')}, stretch ${measure(stretch)}`,
  several: (charts: number, triangles: number, share: number) => {
    const percent = `${(100 * share).toFixed(0)}\u202f%`;
    return `${counted(charts, 'chart')}: ${counted(triangles, 'triangle')}, ${percent} of the surface`;
  },
  none: 'Select a chart first',
  locked: 'Locked charts stay. Unlock them to move them',
  keptUvs: LOCKS.keptUvs,
  density: 'Density',
  mixedDensity: 'mixed',
  densityOfOne: (chart: number, density: number) => `Density of chart ${chart}: ${density}`,
  densityOfSeveral: (charts: number, density: number) =>
    `Density of ${counted(charts, 'chart')}: ${density}`,
};

/** What was done to charts, by the names of the menu's entries. */
export const ARRANGED = {
  move: 'Moved',
  turn: 'Rotated',
  scale: 'Scaled',
  left: 'Rotated',
  right: 'Rotated',
  straightened: 'Aligned',
  stacked: 'Stacked',
  evened: 'Evened out',
};

/** Charts that are put on each other. */
export const STACKING = {
  noneFits: 'Nothing was stacked: no two of these charts have the same shape',
  done: (stacked: number, all: number) => {
    const other = all - stacked;
    const but =
      other > 0 ? `; ${other} ${other === 1 ? 'has another shape' : 'have other shapes'}` : '';
    return `Stacked ${counted(stacked, 'chart')}${but}`;
  },
};

/** Charts that are moved. Numbers come as text. */
export const MOVING = {
  doneToOne: (done: string, chart: number) => `${done} chart ${chart}`,
  doneToSeveral: (done: string, charts: number) => `${done} ${counted(charts, 'chart')}`,
  /** What is typed, as long as it is no number. */
  typed: (typed: string) => ` ${typed}…`,
  turn: (degrees: string) => `Rotate ${degrees}°`,
  scale: (factor: string) => `Scale ×${factor}`,
  along: (axis: string, distance: string) => `${axis} ${distance}`,
  /** `shift` is listed by axis. */
  move: (shift: string, texels: string) => `Move ${shift} (${texels} texels)`,
  failed: (message: string) => `The charts were not moved: ${message}`,
  nothingMoved: 'Nothing was moved',
};

/** What is said of clicks and keys, for fingers: a second one cancels a stroke. */
export const inTouchWords = (text: string): string =>
  text
    .replace(/\bClick\b/g, 'Tap')
    .replace(/\bclick\b/g, 'tap')
    .replace('Esc cancels', 'a second finger cancels');

/** Vertices of the layout that are pinned. */
export const PINS = {
  invitation: 'Click a vertex to pin it',
  some: (pins: number) =>
    pins === 1
      ? '1 pin. Drag it to move its chart, click it to remove it'
      : `${counted(pins, 'pin')}. Drag one to bend its chart, click it to remove it`,
  pinned: (chart: number) => `Pinned a vertex of chart ${chart}`,
  removed: (chart: number) => `Removed a pin of chart ${chart}`,
  removedAll: (pins: number) => `Removed ${counted(pins, 'pin')}`,
  moved: (chart: number) => `Moved a pin of chart ${chart}`,
  notMoved: (message: string) => `The pin was not moved: ${message}`,
  locked: 'This chart is locked. Unlock it to drag its pins',
  keptUvs: LOCKS.keptUvs,
};

/** Keys, where the help does not show them by the names that events give them. */
export const KEY_NAMES: Record<string, string> = {
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
  Escape: 'Esc',
  '-': '−',
};

/** The help's groups, in the order of the page; `where` says what must have the focus. */
export const HELP = {
  mesh: {
    title: 'Mesh view',
    where: 'Click the mesh first. 1, 3, 7, 9 and Home work as in Blender.',
    turn: 'Rotate',
    zoom: 'Zoom',
    move: 'Move',
    lookFrom: 'View from the front, right or top',
    otherSide: 'Flip the view',
    whole: 'Show the whole mesh',
    shading: 'Toggle last shading',
  },
  layout: {
    title: 'Layout view',
    where: 'Click the layout first.',
    move: 'Move',
    zoom: 'Zoom',
    whole: 'Show the whole layout',
    shading: 'Toggle last shading',
  },
  tabs: {
    title: 'Meshes in tabs',
    where: 'Above the mesh, if several are open.',
    next: 'Next tab',
    open: 'Open its mesh',
    close: 'Close it',
  },
  details: {
    title: 'Details and t',
    next: 'Next tab, or next point of a plot',
    use: 'Use the t of that point',
    step: 'Step the number for t',
  },
  seams: {
    title: 'Seams',
    where: 'In the mesh view, with Cut or Join pressed.',
    click: 'Start or end a cut; remove a seam',
    loop: 'Cut the loop of an edge',
    middle: 'Click in the middle of the view',
    goOn: 'Continue a cut; remove a single edge',
    otherTool: 'Join instead of Cut, Cut instead of Join',
    paint: 'Paint a seam; with Join, erase seams',
    togglePaint: 'Turn painting by drag on or off',
    cancel: 'Cancel the cut or the stroke; again: Select',
  },
  bounds: {
    title: 'Bounds',
    where: 'In both views, with Flatten pressed.',
    toggle: 'Turn painting on or off',
    paint: 'Paint the bound set next to the button',
    erase: 'Erase bounds',
    middle: 'Paint in the middle of the view',
  },
  charts: {
    title: 'Charts',
    where: 'In the layout view, or in the mesh view with Select pressed.',
    select: 'Select a chart',
    add: 'Add or remove a chart',
    middle: 'Select the chart in the middle of the view',
    all: 'Select all, or none',
    frame: 'Frame the selected charts',
    isolate: 'Isolate them; press again to show all',
    hide: 'Hide them, or show all',
    move: 'Move, rotate or scale them in the layout',
    none: 'Deselect all',
  },
  pins: {
    title: 'Pins',
    where: 'In the layout view. Press P, or Pin above it, to start and stop.',
    toggle: 'Start or stop pinning',
    pin: 'Pin a vertex, or remove a pin',
    middle: 'Pin in the middle of the view',
    move: 'Move a pin: its chart follows, its other pins stay',
    end: 'Stop pinning',
  },
  moving: {
    title: 'Moving charts',
    where: 'After G, R or S in the layout view, or while a chart or a pin is dragged.',
    axis: 'Move along one axis; press again to free it',
    snap: 'Snap to whole texels, 5°, tenths',
    nudge: 'Step by a texel, 1° or 1 %; by ten with Shift',
    type: 'In UV, degrees or as a factor',
    place: 'Place them',
    putBack: 'Put them back',
  },
  page: {
    title: 'Page',
    open: 'Open a mesh',
    paste: 'Open a copied file, address or text of a mesh',
    export: 'Export',
    exportAs: 'Export in another format',
    undo: 'Undo',
    redo: 'Redo',
    cancel: 'Cancel a run, close what is open',
    help: 'Show this sheet',
  },
};

/** What does in the help the same as keys. */
export const GESTURES = {
  drag: 'drag',
  wheel: 'wheel, pinch',
  moveView: 'Shift-drag, right drag, two fingers',
  doubleClick: 'double-click',
  click: 'click',
  rightClick: 'right click',
  closeButton: '×',
  tap: 'click, tap',
  doubleTap: 'double-click, double-tap',
  shiftClick: 'Shift-click',
  altClick: 'Alt-click',
  dragBoundary: 'drag along the boundary',
  altDrag: 'Alt-drag',
  ctrlDrag: 'Ctrl-drag over the mesh',
  dragMoves: 'drag moves',
  number: 'a number',
  dropFile: 'drop a file',
};
