// Remembers what a step was made from, so that it can be skipped if nothing changed.

import { createHash } from 'node:crypto';
import {
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { BUILD, ROOT } from './paths.mjs';

const NOT_SOURCES = new Set(['node_modules', 'dist', 'build', '.git', '.cache']);

/**
 * All files below the given files and folders (relative to the root), sorted; missing ones are
 * skipped.
 */
export function filesBelow(paths, root = ROOT) {
  const found = [];
  const visit = (path) => {
    if (!existsSync(path)) return;
    if (!statSync(path).isDirectory()) {
      found.push(path);
      return;
    }
    for (const name of readdirSync(path)) {
      if (!NOT_SOURCES.has(name)) visit(join(path, name));
    }
  };
  for (const path of paths) visit(join(root, path));
  return found.sort();
}

/** Hash of names and contents. */
export function fingerprint(files) {
  const hash = createHash('sha256');
  for (const file of files) {
    hash.update(`${relative(ROOT, file)}\0`);
    hash.update(readFileSync(file));
    hash.update('\0');
  }
  return hash.digest('hex');
}

/** A named stamp in the build folder: `isFresh` tells whether the last `set` was the same. */
export function stamp(name) {
  const path = join(BUILD, 'stamps', name);
  return {
    isFresh: (hash) => existsSync(path) && readFileSync(path, 'utf8') === hash,
    set: (hash) => {
      mkdirSync(dirname(path), { recursive: true });
      writeFileSync(path, hash);
    },
    clear: () => rmSync(path, { force: true }),
  };
}

/**
 * Runs `make` unless `inputs` are unchanged since its last success and every output exists. Returns
 * whether it ran.
 */
export async function unlessFresh(name, inputs, outputs, make) {
  const mark = stamp(name);
  const before = fingerprint(filesBelow(inputs));
  if (mark.isFresh(before) && outputs.every((path) => existsSync(path))) return false;
  await make();
  mark.set(before);
  return true;
}
