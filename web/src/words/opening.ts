// Opening meshes.

import { counted, ended } from './format';
import { MESH_NAMES } from './generated-formats';

const MESHES = `${MESH_NAMES.join(', ')} or FBX`;

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

/** Why an archive cannot be opened. */
export const ZIP = {
  encrypted: (name: string) => `${name} has a password. Unpack it and open the files in it.`,
  empty: (name: string) => `${name} contains no files. Zip a mesh with the files it needs.`,
  tooLarge: (name: string) =>
    `${name} unpacks to more than 1 GB. Unpack it and open the mesh and the files it needs.`,
  tooMany: (name: string, most: number) =>
    `${name} contains more than ${most} files. Unpack it and open the mesh and the files it needs.`,
  unreadable: (name: string) =>
    `${name} cannot be read as a ZIP file. Unpack it with another program and open the files in it.`,
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

/** Files that take time to get. */
export const GATHERING = {
  got: (name: string) => `Got ${name}`,
  notOpened: (name: string) => `${name} was not opened`,
  cancelled: 'Cancelled',
};

export const UNPACKING = (name: string) => `Unpacking ${name}`;

export const JOINING = {
  meshes: (n: number) => counted(n, 'mesh', 'meshes'),
  joining: (n: number) => `Joining ${counted(n, 'mesh', 'meshes')}`,
};

/** What the user should know about the opened file. */
export const OPENED_NOTICE = {
  close: 'Close this notice',
  tabs: 'Open as tabs',
  aboutTabs: 'Each with a layout of its own',
  oneAtlas: 'One atlas',
  aboutOneGlb: 'All as one GLB, in one layout',
  shapesOnly: ([name, ...others]: string[]) =>
    others.length === 0
      ? `In one atlas, ${name} keeps its shape only.`
      : `In one atlas, ${counted(others.length + 1, 'file')} that are no glTF keep their shapes only.`,
  aboutOneObj: 'All as one OBJ of shapes, in one layout',
  oneOfMany: (name: string, meshes: number) => `You chose ${meshes} meshes. ${name} is open.`,
};

/** The choices of a glTF's texcoord sets. */
export const UV_SETS = {
  read: (set: number) => `UV ${set}`,
  title: (name: string, set: number) => `${name}, UV ${set}`,
  added: (set: number) => `UV ${set}, new`,
  replaced: (set: number) => `UV ${set}, replaced`,
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
