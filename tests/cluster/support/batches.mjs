// Meshes for recipes of clusters, and what became of them.

import { spawn } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { ROOT } from '../../../scripts/lib/paths.mjs';
import { ordinaryShapes } from '../../support/ordinary-shapes.mjs';
import { PROGRAM } from '../../support/run-abflat.mjs';

export const RECIPES = join(ROOT, 'native/cluster');

/** Runs a program; resolves to { code, stdout, stderr }. */
export function run(command, args, { env = {}, cwd, input } = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, {
      cwd,
      env: { ...process.env, ABFLAT: PROGRAM, ...env },
      stdio: [input === undefined ? 'ignore' : 'pipe', 'pipe', 'pipe'],
    });
    const said = { stdout: '', stderr: '' };
    for (const stream of Object.keys(said))
      child[stream].on('data', (data) => (said[stream] += data));
    child.on('error', reject);
    child.on('close', (code) => resolve({ code, ...said }));
    child.stdin?.end(input);
  });
}

const objOf = ({ points, faces }) =>
  [
    ...points.map((p) => `v ${p.join(' ')}`),
    ...faces.map((face) => `f ${face.map((v) => v + 1).join(' ')}`),
    '',
  ].join('\n');

/** Writes ordinary shapes, one of them broken, into a folder; returns their names. */
export function writeMeshes(folder, count) {
  mkdirSync(folder, { recursive: true });
  for (const shape of ordinaryShapes().slice(0, count - 1))
    writeFileSync(join(folder, `${shape.name.replaceAll(/\W+/g, '-')}.obj`), objOf(shape));
  writeFileSync(join(folder, 'broken.obj'), 'v 0 0\nf 1 2 3\n');
  return readdirSync(folder);
}

/** Lines of a manifest without what differs from run to run. */
export const manifestOf = (out) =>
  readFileSync(join(out, 'manifest.jsonl'), 'utf8')
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line))
    .map(({ seconds: _, peakMemory: __, ...line }) => line)
    .sort((a, b) => (a.name < b.name ? -1 : 1));

/** All files below a folder, but those that belong to a recipe. */
export const filesOf = (folder) =>
  readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name).slice(folder.length + 1))
    .filter((name) => !/^(logs\/|joblog$|manifest-)/.test(name))
    .sort();

/** The same meshes without a recipe. */
export async function plainRun(meshes, out) {
  const { code, stderr } = await run(PROGRAM, ['batch', meshes, '--out', out, '-q']);
  if (code !== 1) throw new Error(`a broken mesh should give exit code 1: ${code} ${stderr}`);
  return { lines: manifestOf(out), files: filesOf(out) };
}

/** A port on loopback that nothing uses. */
export const freePort = () =>
  new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });

export async function until(isTrue, what, seconds = 240) {
  const end = Date.now() + 1000 * seconds;
  for (;;) {
    const value = await isTrue();
    if (value) return value;
    if (Date.now() > end) throw new Error(`waited ${seconds} s for ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 200));
  }
}
