// The list of files that the service worker stores, in front of its source.

import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join, sep } from 'node:path';

const WORKER = 'sw.js';
/** Copies, and what is there for people to read. */
const NOT_OF_PAGE = /\.(br|gz|map|txt)$/;
/** Each browser runs one of these; what bakes is the same for all. */
const MODULE = /^assets\/abflat-(simd|threads)-[\w-]{8}\.wasm$/;

const sha256 = (content) => createHash('sha256').update(content).digest('base64');

/** As pages ask for it: servers may send those who ask for index.html elsewhere. */
const pathOf = (name) => (name === 'index.html' ? './' : name.replaceAll(sep, '/'));

function filesOf(folder) {
  const names = readdirSync(folder, { recursive: true })
    .filter((name) => name !== WORKER && !NOT_OF_PAGE.test(name))
    .filter((name) => statSync(join(folder, name)).isFile())
    .sort();
  return names.map((name) => [pathOf(name), `sha256-${sha256(readFileSync(join(folder, name)))}`]);
}

/** All files of a built page with their hashes: `modules` by the build of the package, and the rest. With other `headers` it is another version. */
export function listBuild(folder, headers) {
  const all = filesOf(folder);
  const files = all.filter(([path]) => !MODULE.test(path));
  const modules = Object.fromEntries(
    all.flatMap((file) => {
      const match = MODULE.exec(file[0]);
      return match ? [[match[1], file]] : [];
    }),
  );
  const version = sha256(JSON.stringify([files, modules, headers]));
  return { version, files, modules };
}

/** Writes the worker of the page in `folder`. */
export function writeWorker(folder, source, headers) {
  const list = `const BUILD = ${JSON.stringify(listBuild(folder, headers))};\n`;
  writeFileSync(join(folder, WORKER), list + source);
}
