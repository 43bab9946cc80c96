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
  const url = URL.createObjectURL(
    new Blob([bytes as Uint8Array<ArrayBuffer>], { type: `model/${format}` }),
  );
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  // The browser reads the blob after click() returns.
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
  return { name, size: bytes.length };
}
