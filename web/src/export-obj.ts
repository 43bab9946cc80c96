import type { Outcome } from './session';

/** Offers the result as NAME-uv.obj. */
export function exportObj({ source, result }: Outcome): string {
  const name = `${source.name.replace(/\.[^.]*$/, '')}-uv.obj`;
  if (!result.obj) throw new Error('The result came without OBJ text.');
  const url = URL.createObjectURL(
    new Blob([result.obj as Uint8Array<ArrayBuffer>], { type: 'model/obj' }),
  );
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  // The browser reads the blob after click() returns.
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
  return name;
}
