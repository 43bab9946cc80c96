// Everything that the page's scripts say to people, by room and with the numbers and names that go into it. What is always on the page
// is in index.html. Errors that only a developer can meet stay where they are thrown.

import { count, counted, listed, measure } from './format';

// Rooms: base, view, drawing, mesh, files, workshop, opening, export

/** Said where a part of the page or a worker is missing. */
export const LOST = {
  notLoaded: 'a part of this page could not be loaded. Check the connection, then try again.',
  stopped: 'its worker stopped, possibly because memory ran out. Close other tabs, then try again.',
  noWorker: 'A worker could not be loaded.',
};

export const ALERT = { close: 'Close this message' };

export const THEME = { use: (theme: string) => `Use the ${theme} theme` };

export const GRID = { notDrawn: 'This browser cannot draw the numbered grid.' };

export const SHADINGS = { materials: 'Materials' };

/** `title`: what is measured; values and shares come as texts. */
export const HEAT_LEGEND = {
  andLess: (value: string) => `${value} and less`,
  andMore: (value: string) => `${value} and more`,
  fromTo: (title: string, from: string, to: string) => `${title} ${from} to ${to}`,
  percent: (value: string) => `${value}\u202f%`,
  underPercent: (value: string) => `under ${value}\u202f%`,
  ofSurface: (range: string, share: string) => `${range}: ${share} of the surface`,
  selectBar: 'Select a bar to light its triangles',
  worst: 'The worst hundredth of the surface',
};

/** Meanings of marks. */
export const MARKS = {
  invalidCharts: (n: number) => counted(n, 'chart is not valid', 'charts are not valid'),
  tightened: (n: number) => counted(n, 'tightened vertex', 'tightened vertices'),
  crossings: (n: number) => counted(n, 'crossing'),
  resisting: (n: number) => `${counted(n, 'edge')} cannot become Delaunay`,
  delaunay: (before: number, after: number) =>
    `Delaunay: distortion ${measure(before)} \u2192 ${measure(after)}`,
};

/** Why a glTF or GLB cannot be read or written. */
export const GLTF = {
  needs: (name: string, wanted: string | undefined) =>
    `${name} needs ${wanted}: open or drop both files together.`,
  truncated: (name: string, there: number, length: number) =>
    `${name} is truncated: ${count(there)} of ${count(length)} bytes are there. Copy or download it again.`,
  unknownExtension: (name: string, extension: string) =>
    `${name} requires ${extension}, which this page cannot read. Save it without that extension.`,
  otherVersion: (name: string) => `${name} is not glTF 2.0. Save it as glTF 2.0 or GLB.`,
  notJson: (name: string, reason: string) => `${name} is neither binary nor JSON: ${reason}`,
  noTriangles: (name: string) => `${name} has no triangles, so there is nothing to unwrap.`,
  damaged: (name: string, reason: string) =>
    `${name} is damaged or too large to read (${reason}). Export or download it again.`,
  undecodable: (name: string, compressions: string[], reason: string) =>
    `${name} is damaged: its ${compressions.join(' and ')} data cannot be decoded (${reason}). Export or download it again.`,
  attributeMissing: 'an attribute is missing',
  senselessView: (view: number) => `buffer view ${view} makes no sense`,
  tooLarge: 'Its coordinates are too large for GLB. Scale the mesh down, or choose OBJ',
};

/** Files that a mesh names. */
export const LOOK_FILES = {
  missing: (mesh: string, files: string[]) => {
    const [is, them] = files.length > 1 ? ['are', 'them'] : ['is', 'it'];
    return `${mesh} names ${listed(files)}, which ${is} missing: drop ${them} together with the mesh.`;
  },
  undecoded: (files: string[]) =>
    `This browser cannot decode ${listed(files)}: save ${files.length > 1 ? 'them' : 'it'} as PNG or JPEG.`,
  /** One without a name. */
  image: (number: number) => `image ${number}`,
};

/** Pictures of an atlas. */
export const ATLAS_PICTURE = {
  tooLarge: (most: number) =>
    `pictures have at most ${most} pixels along a side. Lower the resolution, or save SVG`,
  noMemory:
    'the browser has not enough memory for a picture of this size. Lower the resolution, or save SVG',
};

/** Choosing or dropping files. */
export const CHOSEN_FILES = {
  noMesh: (names: string[]) => {
    const what =
      names.length === 1
        ? `${names[0]} is not a mesh`
        : `None of these ${names.length} files is a mesh`;
    return `${what}. Open an OBJ, PLY, STL, OFF, glTF or GLB file, along with any files it needs.`;
  },
  emptyFolder: 'The folder is empty. Drop a mesh, or a folder that contains one.',
  tooMany: (most: number) =>
    `The folder holds more than ${most} files. Drop only the mesh and the files it needs.`,
  unreadable: 'The file cannot be read: it was moved or deleted. Open it again.',
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
    `The mesh names ${found} other files, and at most ${most} are fetched. Download all of them, then open the folder.`,
};

/** Why nothing is fetched from an address. */
export const ADDRESSES = {
  password: (host: string) =>
    `The address of a mesh on ${host} holds a password, so it is not opened. Download the file, then open it.`,
  notHttps: (address: string) =>
    `${address} is not opened, because only https addresses are. Use one that begins with https://, or download the file.`,
  invalid: (text: string) => `"${text}" is not an address. Check the link.`,
};

/** Why fetching failed. */
export const FETCH_FAILED = {
  empty: (name: string, host: string) =>
    `${name} at ${host} is empty. Check the address, or ask who published it.`,
  webPage: (name: string, host: string) =>
    `${host} answered with a web page in place of ${name}. Use the address of the file itself.`,
  offline: (name: string, host: string) =>
    `${name} was not fetched from ${host}, because there is no network connection. Connect, then open it again.`,
  unreachable: (name: string, host: string) =>
    `${name} was not fetched from ${host}: the server cannot be reached, or does not let other pages read it (CORS). Download the file, then open it.`,
  notThere: (name: string, host: string, status: number) =>
    `There is no ${name} at ${host} (${status}). Check the address.`,
  notAllowed: (name: string, host: string, status: number) =>
    `${host} does not give ${name} to everybody (${status}). Download it where you are signed in, then open it.`,
  refused: (name: string, host: string, status: number) =>
    `${host} did not send ${name} (${status}). Try again later, or download the file and open it.`,
  interrupted: (name: string) =>
    `The connection was lost while ${name} was fetched. Open it again.`,
};

/** Asked before anything is fetched. Sizes come as texts. */
export const WEB_SHEET = {
  cancel: 'Cancel',
  openFrom: (name: string, host: string) => `Open ${name} from ${host}?`,
  /** `size`: '' if it is not known. */
  whatHappens: (host: string, size: string, namesFiles: boolean) =>
    `Your browser fetches this mesh${size && ` (${size})`}${namesFiles ? ' and the files it names' : ''} from ${host}, which sees your network address. Meshes of your own stay on your machine.`,
  open: 'Open',
  fetchLarge: (size: string) => `Fetch ${size}?`,
  large: (name: string, size: string) =>
    `${name} is larger than most meshes: ${size} or more. Fetching and unwrapping it may take long.`,
  fetch: 'Fetch',
  megabytes: (size: string) => `${size}\u202fMB`,
};

export const MESH_TABS = { tab: (title: string) => `${title} (Delete closes it)` };

export const SAMPLES = {
  samples: 'Samples',
  sample: (title: string) => `Sample: ${title}`,
};

/** What there is to see in each sample. */
export const ABOUT_SAMPLES: Record<string, string> = {
  hemisphere: 'half a ball',
  'wavy-strip': 'long and bent',
  head: 'cut at the neck',
  'alpha-band': 'overlaps when flat',
  'three-balls': 'tight necks',
  pumpkin: 'closed, textured',
};

/** `format` in capitals. */
export const EXPORT = {
  export: (format: string) => `Export ${format}`,
  exportEarlier: (format: string) => `Export earlier ${format}`,
  stillShown: (earlier: string) => `Exports the layout still shown: ${earlier}`,
  writing: (format: string) => `Writing ${format}`,
  exported: (name: string, size: string) => `Exported ${name}, ${size}`,
  shapeOnly: ', shape and UVs only',
  uncompressed: ', uncompressed',
  notExported: 'Not exported',
  cancelled: 'Export cancelled',
  rounded:
    'GLB holds single precision: rounded to it, some triangles flip or overlap. OBJ keeps all digits.',
  replaced: 'New UVs replaced TEXCOORD_0: textures painted for the old ones no longer fit.',
  added: (texcoord: number) => `New UVs are in TEXCOORD_${texcoord}; textures keep theirs.`,
};

/** Files that were saved. */
export const SAVED = {
  saved: (name: string, size: string) => `Saved ${name}, ${size}`,
  kilobytes: (bytes: number) => `${count(Math.ceil(bytes / 1024))}\u202fKB`,
  pixels: (width: number, height: number) => `${count(width)}\u202f×\u202f${count(height)}\u202fpx`,
};

export const VIEWS_PICTURE = {
  notMade: 'The browser made no picture of it. Make the window smaller.',
  noMemory: 'The browser has no memory left for a picture. Close other tabs.',
};

// Rooms: model, controls, plot, details

// Rooms: session, seams, selection, help, and the top room
