// What abflat batch leaves in its folder of results.

import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { setTimeout } from 'node:timers/promises';
import { runAbflat } from './run-abflat.mjs';
import { tempFolder } from './temp-folder.mjs';

/** Writes a file, and the folders that it needs. */
export function lasting(path, text) {
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, text);
}

/** A folder with files, by their names, and `batch` to run it there. */
export function inFolder(t, files) {
  const at = tempFolder(t);
  for (const [name, text] of Object.entries(files)) lasting(at(name), text);
  const batch = (...args) => runAbflat(['batch', ...args], { cwd: at() });
  return { at, batch };
}

/** The lines of a manifest. */
export const manifestOf = (folder, name = 'manifest.jsonl') =>
  readFileSync(join(folder, name), 'utf8')
    .split('\n')
    .filter(Boolean)
    .map((line) => JSON.parse(line));

/** The same without what differs from run to run. */
export const lasted = (folder) =>
  manifestOf(folder).map(({ seconds, peakMemory, ...line }) => line);

/** What the lines of a manifest are about. */
export const namesIn = (folder) => manifestOf(folder).map(({ name }) => name);

/** Paths of all files in a folder and below, sorted. */
export const filesBelow = (folder) =>
  readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath ?? entry.path, entry.name)))
    .sort();

/** Of a folder of results, its meshes. */
export const hasResults = (folder) =>
  filesBelow(folder).filter((name) => !/^(layouts\/|manifest|report\.html)/.test(name));

/** Waits until a file has at least so many lines. */
export async function untilLines(path, count) {
  const lines = () => readFileSync(path, 'utf8').split('\n').length - 1;
  while (!existsSync(path) || lines() < count) await setTimeout(2);
}
