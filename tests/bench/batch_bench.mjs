// How many meshes and faces a batch does in a second: equal meshes, by one process at a time, by one
// for each processor, and by as many loops that only start the program. One after the other in turn.
// Prints how near the second is to ideal, which processors that share memory are not themselves, and
// to the third; and whether all layouts were valid.
// Usage: npm run bench:batch [-- COUNT [DETAIL]]

import { execFileSync, spawn } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { join } from 'node:path';
import { NATIVE_PROGRAM } from '../../scripts/lib/paths.mjs';

const ROUNDS = 3;
const [count = 24, detail = 2] = process.argv.slice(2).map(Number);
const processors = availableParallelism();
const folder = mkdtempSync(join(tmpdir(), 'abflat-bench-'));
const at = (name) => join(folder, name);
const abflat = (...args) => execFileSync(NATIVE_PROGRAM, args, { cwd: folder, stdio: 'ignore' });

function timed(jobs) {
  rmSync(at('out'), { recursive: true, force: true });
  const start = performance.now();
  abflat('batch', 'meshes', '--out', 'out', '-q', '--jobs', `${jobs}`);
  const seconds = (performance.now() - start) / 1000;
  const lines = readFileSync(at('out/manifest.jsonl'), 'utf8').trim().split('\n').map(JSON.parse);
  const valid = lines.filter(({ status }) => status === 'done').length;
  const faces = lines.reduce((sum, { summary }) => sum + (summary?.faces ?? 0), 0);
  return { seconds, valid, faces };
}

const finished = (args) =>
  new Promise((resolve, reject) => {
    const child = spawn(NATIVE_PROGRAM, args, { cwd: folder, stdio: 'ignore' });
    child.on('error', reject);
    child.on('close', (code) => (code === 0 ? resolve() : reject(new Error(args.join(' ')))));
  });

/** The same work without a batch. */
async function timedLoops() {
  const start = performance.now();
  let next = 0;
  const loop = async (lane) => {
    for (let i = next++; i < count; i = next++) {
      const [mesh, report, picture] = ['obj', 'json', 'svg'].map((end) => `${lane}.${end}`);
      const written = ['-o', mesh, '--report', report, '--layout', picture];
      await finished(['unwrap', `meshes/${i}.obj`, ...written, '-q', '--threads', '1']);
    }
  };
  await Promise.all(Array.from({ length: processors }, (_, lane) => loop(lane)));
  return (performance.now() - start) / 1000;
}

const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];
const show = (name, { seconds, valid, faces }) =>
  console.log(
    `${name.padEnd(14)} ${(valid / seconds).toFixed(2)} meshes/s, ${Math.round(faces / seconds)} faces/s, ` +
      `${valid} of ${count} valid`,
  );

try {
  mkdirSync(at('meshes'));
  abflat('sample', 'head', '-o', 'meshes/0.obj', '--detail', `${detail}`);
  // Copies would be one mesh in a shard, but a batch does each.
  for (let i = 1; i < count; i++) copyFileSync(at('meshes/0.obj'), at(`meshes/${i}.obj`));
  const [shares, ofLoops] = [[], []];
  for (let round = 0; round < ROUNDS; round++) {
    const alone = timed(1);
    const all = timed(processors);
    show('one process', alone);
    show(`${processors} processes`, all);
    shares.push(alone.seconds / all.seconds / processors);
    ofLoops.push((await timedLoops()) / all.seconds);
  }
  const percent = (values) => (100 * median(values)).toFixed(0);
  console.log(
    `${percent(shares)} % of ideal, ${percent(ofLoops)} % of what loops do (medians of ${ROUNDS} rounds)`,
  );
} finally {
  rmSync(folder, { recursive: true });
}
