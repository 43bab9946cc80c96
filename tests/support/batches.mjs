// What abflat batch leaves in its folder of results.

import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { setTimeout } from 'node:timers/promises';

/** Writes a file, and the folders that it needs. */
export function lasting(path, text) {
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, text);
}

/** The lines of a manifest. */
export const manifestOf = (folder, name = 'manifest.jsonl') =>
  readFileSync(join(folder, name), 'utf8')
    .split('\n')
    .filter(Boolean)
    .map((line) => JSON.parse(line));

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
