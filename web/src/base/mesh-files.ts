// What the names of mesh files tell.

import {
  EXPORT_FORMATS,
  type ExportFormat,
  MESH_FILES,
  type MeshFile,
} from '../words/generated-formats';

/** All that the page opens: it alone reads FBX, which becomes a glTF. */
export const OPENED_FILES: readonly MeshFile[] = [
  ...MESH_FILES,
  { ending: '.fbx', title: 'FBX', type: '', format: 'gltf', exported: 'glb', pasted: null },
];

/** What kind of file has this name, if it is the name of a mesh. */
export function meshFileOf(name: string): MeshFile | undefined {
  const lower = name.toLowerCase();
  return OPENED_FILES.find(({ ending }) => lower.endsWith(ending));
}

export const isFbx = (name: string): boolean => meshFileOf(name)?.ending === '.fbx';

/** A file is exported in its own format by default, if that can hold texcoords. */
export const exportFormatOf = (name: string): ExportFormat =>
  meshFileOf(name)?.exported ?? EXPORT_FORMATS[0];

/** The kind of file that an export makes. */
export const exportedFile = (format: ExportFormat): MeshFile =>
  meshFileOf(`.${format}`) as MeshFile;

/** Whether these are the first bytes of a GLB, or all of them. */
export const isGlb = (bytes: Uint8Array): boolean =>
  new TextDecoder().decode(bytes.subarray(0, 4)) === 'glTF';
