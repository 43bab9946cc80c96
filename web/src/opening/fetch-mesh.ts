import { isGlb, meshFileOf } from '../base/mesh-files';
import type { Address } from './address';
import { companionsOf, namedByGltf, namedByMtl, namedByObj } from './companions';
import { fetchFile, type Watch } from './fetch-file';

/** Bytes of an OBJ that are searched for its libraries, which come before its faces. */
const HEAD = 1 << 20;

/** Fetches a mesh and the files that it names in its own folder. The mesh comes first. */
export async function fetchMesh({ url }: Address, watch: Watch): Promise<File[]> {
  const mesh = await named(await fetchFile(url, watch));
  const others = await othersOf(mesh.name)?.(mesh, url, watch);
  return [mesh, ...(others ?? [])];
}

/** Whether a mesh of this name may name other files. */
export const namesFiles = (name: string): boolean => othersOf(name) !== undefined;

/** What fetches the files that a mesh names. */
function othersOf(name: string) {
  const ending = meshFileOf(name)?.ending;
  return { '.gltf': partsOfGltf, '.obj': materialsOf }[ending ?? ''];
}

/** Addresses need not end like files. Other formats are recognised by their content when they are read. */
async function named(file: File): Promise<File> {
  const start = new Uint8Array(await file.slice(0, 4).arrayBuffer());
  if (!isGlb(start) || meshFileOf(file.name)?.ending === '.glb') return file;
  return new File([file], `${file.name}.glb`, { type: file.type });
}

async function partsOfGltf(mesh: File, url: URL, watch: Watch): Promise<File[]> {
  const files: File[] = [];
  for (const each of companionsOf(url, namedByGltf(await mesh.text())))
    files.push(await fetchFile(each, watch));
  return files;
}

async function materialsOf(mesh: File, url: URL, watch: Watch): Promise<File[]> {
  const libraries = companionsOf(url, namedByObj(await mesh.slice(0, HEAD).text()));
  const files: File[] = [];
  for (const library of libraries) {
    const file = await fetchIfThere(library, watch);
    if (!file) continue;
    files.push(file);
    const textures = companionsOf(library, namedByMtl(await file.text()));
    for (const texture of textures) {
      const picture = await fetchIfThere(texture, watch);
      if (picture) files.push(picture);
    }
  }
  return files;
}

/** A mesh can do without its materials. */
async function fetchIfThere(url: URL, watch: Watch): Promise<File | null> {
  try {
    return await fetchFile(url, watch);
  } catch (error) {
    watch.signal.throwIfAborted();
    console.info(String(error));
    return null;
  }
}
