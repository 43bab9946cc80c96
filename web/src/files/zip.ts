import { unzipSync } from 'fflate';
import { ZIP } from '../words/opening';

/** Bytes: what is larger would take all memory of the page. */
const MOST_BYTES = 2 ** 30;
/** As in a folder. */
const MOST_FILES = 1000;
/** The first words of an entry of the directory, and of its end. */
const ENTRY = 0x02014b50;
const END = 0x06054b50;
/** Bytes of both. */
const ENTRY_SIZE = 46;
const END_SIZE = 22;

/** The files in an archive; their names have the folders that they are in. */
export async function unzipped(archive: File): Promise<File[]> {
  const { name } = archive;
  const bytes = new Uint8Array(await archive.arrayBuffer());
  if (isEncrypted(bytes)) throw new Error(ZIP.encrypted(name));
  const files = Object.entries(inflated(name, bytes)).map(
    ([path, content]) => new File([content as Uint8Array<ArrayBuffer>], path),
  );
  if (files.length === 0) throw new Error(ZIP.empty(name));
  return files;
}

function inflated(name: string, bytes: Uint8Array): Record<string, Uint8Array> {
  let [left, files] = [MOST_BYTES, 0];
  let refusal = '';
  try {
    return unzipSync(bytes, {
      // Each file gets the room that the directory gives it, and no more.
      filter: ({ name: path, originalSize }) => {
        if (!isWanted(path)) return false;
        left -= originalSize;
        files += 1;
        if (left < 0) refusal = ZIP.tooLarge(name);
        else if (files > MOST_FILES) refusal = ZIP.tooMany(name, MOST_FILES);
        if (refusal) throw new Error(refusal);
        return true;
      },
    });
  } catch {
    throw new Error(refusal || ZIP.unreadable(name));
  }
}

/** Neither folders, nor what systems hide in them, nor further archives. */
const isWanted = (path: string) =>
  !/\/$|\.zip$/i.test(path) && !path.split('/').some((part) => /^(\.|__MACOSX$)/.test(part));

/** Whether a file of the archive needs a password, as its directory says. */
function isEncrypted(bytes: Uint8Array): boolean {
  const view = new DataView(bytes.buffer);
  let end = bytes.length - END_SIZE;
  while (end >= 0 && view.getUint32(end, true) !== END) --end;
  if (end < 0) return false;
  let at = view.getUint32(end + 16, true);
  while (at + ENTRY_SIZE <= bytes.length && view.getUint32(at, true) === ENTRY) {
    if (view.getUint16(at + 8, true) & 1) return true;
    const sizes = [28, 30, 32].map((field) => view.getUint16(at + field, true));
    at += sizes.reduce((sum, size) => sum + size, ENTRY_SIZE);
  }
  return false;
}
