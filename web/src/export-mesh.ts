import { download } from './download';
import type { Outcome } from './lay-out';
import type { Source } from './session';

/** A file goes back in the format it came in where that holds texcoords. */
export const exportFormat = (source: Source) => (/\.ply$/i.test(source.name) ? 'ply' : 'obj');

/** Offers the result as NAME-uv.obj or NAME-uv.ply. */
export function exportMesh({ source, result }: Outcome): { name: string; size: number } {
  const format = exportFormat(source);
  const bytes = result[format];
  if (!bytes) throw new Error(`The result came without ${format.toUpperCase()}.`);
  const name = `${source.name.replace(/\.[^.]*$/, '')}-uv.${format}`;
  download(name, `model/${format}`, bytes);
  return { name, size: bytes.length };
}
