// Compressed copies of the page's files, which servers that know them send in their place. The best that Brotli can do takes seconds, so the
// copies of contents that have not changed since the last build are kept.

import { createHash } from 'node:crypto';
import {
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { brotliCompress, constants, gzip } from 'node:zlib';

const COMPRESSIBLE = /\.(js|css|html|svg|json|wasm|webmanifest)$/;
const ENCODERS = {
  '.br': (bytes) =>
    promisify(brotliCompress)(bytes, {
      params: {
        [constants.BROTLI_PARAM_QUALITY]: constants.BROTLI_MAX_QUALITY,
        [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length,
      },
    }),
  '.gz': (bytes) => promisify(gzip)(bytes, { level: constants.Z_BEST_COMPRESSION }),
};

async function compress(bytes, ending, kept) {
  const known = join(kept, createHash('sha256').update(bytes).digest('hex') + ending);
  if (!existsSync(known)) {
    // Whole, or not at all: another build may read it.
    writeFileSync(`${known}.tmp`, await ENCODERS[ending](bytes));
    renameSync(`${known}.tmp`, known);
  }
  return { known, copy: readFileSync(known) };
}

/** Writes NAME.br and NAME.gz beside the files below `folder` that they are smaller than. `kept`: a folder for the copies of this build. */
export async function compressFolder(folder, kept) {
  mkdirSync(kept, { recursive: true });
  const names = readdirSync(folder, { recursive: true }).filter((name) => COMPRESSIBLE.test(name));
  const used = await Promise.all(
    names.flatMap((name) => {
      const bytes = readFileSync(join(folder, name));
      return Object.keys(ENCODERS).map(async (ending) => {
        const { known, copy } = await compress(bytes, ending, kept);
        if (copy.length < bytes.length) writeFileSync(join(folder, name + ending), copy);
        return known;
      });
    }),
  );
  for (const name of readdirSync(kept))
    if (!used.includes(join(kept, name))) rmSync(join(kept, name));
}
