// Finds the mesh among files that were chosen or dropped together.

import { meshFileOf } from '../base/mesh-files';
import { nameOf } from '../files/missing-files';
import type { FileSource } from '../model/model';
import { CHOSEN_FILES } from '../words/opening';

/** What may come with a mesh. */
const COMPANION = /\.(mtl|bin|png|jpe?g|webp|gif|bmp|tga|tiff?|ktx2?|dds|exr|hdr|txt|seams|json)$/i;

/** Also images that no browser decodes: it is said what to do with them. */
const IMAGE = /\.(png|jpe?g|webp|gif|bmp|avif|svg|heic|tga|tiff?|ktx2?|dds|exr|hdr|psd|xcf|kra)$/i;

/**
 * The meshes among files, in the order in which they are offered, each with all files that are not
 * meshes. A glTF comes first, as the other files most likely belong to it. A file of unknown type
 * may be a mesh if there is no other: its content decides.
 */
export function sourcesOf(files: File[]): FileSource[] {
  const meshes = files.filter(({ name }) => meshFileOf(name));
  const chosen = meshes.length > 0 ? meshes : files.filter(({ name }) => !COMPANION.test(name));
  const others = files.filter((file) => !chosen.includes(file));
  const isGltf = ({ name }: File) => meshFileOf(name)?.ending === '.gltf';
  const ordered = [...chosen.filter(isGltf), ...chosen.filter((file) => !isGltf(file))];
  const together: FileSource[] = [];
  for (const file of ordered) {
    const name = nameOf(file.name);
    together.push({ kind: 'file', name, file, others: nearestFirst(file, others), together });
  }
  return together;
}

/** Those of an archive are in folders: of files with one name, the nearest to the mesh is meant. */
function nearestFirst(mesh: File, others: File[]): File[] {
  const shared = new Map(others.map((file) => [file, sharedFolders(mesh.name, file.name)]));
  return [...others].sort((a, b) => (shared.get(b) ?? 0) - (shared.get(a) ?? 0));
}

function sharedFolders(a: string, b: string): number {
  const [x, y] = [a, b].map((path) => path.split('/').slice(0, -1));
  const apart = x.findIndex((folder, i) => folder !== y[i]);
  return apart < 0 ? x.length : apart;
}

export const isZip = ({ name }: File): boolean => /\.zip$/i.test(name);

/** Whether all of the files are images, which are shown on the mesh that is open. */
export const areImages = (files: File[]): boolean =>
  files.every(({ name, type }) => IMAGE.test(name) || type.startsWith('image/'));

/** Why none of the files can be opened. */
export const noMesh = (files: File[]): string => CHOSEN_FILES.noMesh(files.map(({ name }) => name));
