// The files that make up a C++ source: itself and this project's headers that it includes, directly
// or indirectly.

import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { ROOT } from './paths.mjs';

const FOLDERS = ['core/src', 'core/formats', 'core/include', 'native/src'].map((folder) =>
  join(ROOT, folder),
);
const INCLUDE = /^[ \t]*#[ \t]*include[ \t]+"([^"]+)"/gm;

/**
 * Returns a function from a file to the sorted list of all files that affect it, without
 * third-party headers.
 */
export function includeScanner(folders = FOLDERS) {
  const direct = new Map();
  const resolve = (name, from) =>
    [dirname(from), ...folders]
      .map((folder) => join(folder, name))
      .find((path) => existsSync(path));
  const includesOf = (file) => {
    if (!direct.has(file)) {
      const names = [...readFileSync(file, 'utf8').matchAll(INCLUDE)].map((match) => match[1]);
      direct.set(file, names.map((name) => resolve(name, file)).filter(Boolean));
    }
    return direct.get(file);
  };
  return (file) => {
    const seen = new Set([file]);
    for (const each of seen) for (const included of includesOf(each)) seen.add(included);
    return [...seen].sort();
  };
}
