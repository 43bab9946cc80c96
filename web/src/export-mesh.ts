import { download } from './download';
import type { Outcome } from './lay-out';
import { isGltf, type Source } from './session';

/** A file goes back in the format it came in where that holds texcoords. */
export function exportFormat(source: Source): 'glb' | 'ply' | 'obj' {
  if (isGltf(source)) return 'glb';
  return /\.ply$/i.test(source.name) ? 'ply' : 'obj';
}

/** Offers the result as NAME-uv with the ending of its format. */
export async function exportMesh(outcome: Outcome): Promise<{ name: string; size: number }> {
  const { source } = outcome;
  const format = exportFormat(source);
  const bytes = await bytesOf(outcome, format);
  if (!bytes) throw new Error(`The result came without ${format.toUpperCase()}.`);
  const name = `${source.name.replace(/\.[^.]*$/, '')}-uv.${format}`;
  download(name, TYPES[format], bytes);
  return { name, size: bytes.length };
}

const TYPES = { obj: 'model/obj', ply: 'model/ply', glb: 'model/gltf-binary' };

async function bytesOf(
  { mode, gltf, result }: Outcome,
  format: keyof typeof TYPES,
): Promise<Uint8Array | undefined> {
  // A layout in the unit of the mesh would repeat a texture as often as the mesh is large.
  return format === 'glb' ? gltf?.write(result, { normalize: mode === 'flatten' }) : result[format];
}
