// How many meshes and faces a batch does in a second: equal meshes, by one process at a time and by
// one for each processor, one run after the other in turn. Prints how near to ideal the second is,
// and whether all layouts were valid.
// Usage: npm run bench:batch [-- COUNT [DETAIL]]

import { execFileSync } from 'node:child_process';
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
  const shares = [];
  for (let round = 0; round < ROUNDS; round++) {
    const alone = timed(1);
    const all = timed(processors);
    show('one process', alone);
    show(`${processors} processes`, all);
    shares.push(alone.seconds / all.seconds / processors);
  }
  console.log(`${(100 * median(shares)).toFixed(0)} % of ideal (median of ${ROUNDS} rounds)`);
} finally {
  rmSync(folder, { recursive: true });
}
