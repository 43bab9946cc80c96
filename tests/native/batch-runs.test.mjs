// Runs of abflat batch: in parts, with limits, ended midway and resumed.

import assert from 'node:assert/strict';
import { cpSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import {
  filesBelow,
  hasResults,
  inFolder,
  lasted,
  manifestOf,
  namesIn,
  untilLines,
} from '../support/batches.mjs';
import { writeManyMeshes } from '../support/many-meshes.mjs';
import { isInstrumented, startAbflat } from '../support/run-abflat.mjs';
import { CUBE, grid } from '../support/small-meshes.mjs';
import { objText, torus } from '../support/surfaces.mjs';

const PARTED = isInstrumented ? 12 : 24;
/** A mesh that takes seconds. */
const LONG = isInstrumented ? torus(80, 40) : torus(200, 100);
/** In seconds: enough for a cube, not for 300,000 faces. */
const LIMIT = isInstrumented ? 20 : 1.5;

test('parts make the same manifest as the whole', async (t) => {
  const { at, batch } = inFolder(t, {});
  writeManyMeshes(at('in'), { count: PARTED, most: 60, broken: 0.1 });
  await batch('in', '--out', 'whole');
  for (const part of [2, 0]) await batch('in', '--out', 'parts', '--shard', `${part}/3`);
  const early = await batch('--merge', '--out', 'parts');
  assert.equal(early.code, 3);
  assert.match(early.stderr, /manifest-1-of-3\.jsonl is missing\. Run --shard 1\/3 first/);
  await batch('in', '--out', 'parts', '--shard', '1/3');
  const parts = [0, 1, 2].map((part) => manifestOf(at('parts'), `manifest-${part}-of-3.jsonl`));
  assert.ok(parts.every((lines) => lines.length > 0 && lines.length < PARTED));
  const merged = await batch('--merge', '--out', 'parts');
  assert.equal(merged.code, 1, merged.stderr);
  assert.deepEqual(lasted(at('parts')), lasted(at('whole')));
  assert.deepEqual(hasResults(at('parts')), hasResults(at('whole')));
  assert.match(
    (await batch('in', '--out', 'parts', '--resume', '--dry-run')).stdout,
    new RegExp(`^0 to do, ${PARTED}`, 'm'),
  );
});

test('a part keeps its meshes when they are renamed', async (t) => {
  const { at, batch } = inFolder(t, {});
  writeManyMeshes(at('in'), { count: 20, most: 20, broken: 0.01 });
  cpSync(at('in'), at('other/name'), { recursive: true });
  const partOf = async (folder) => {
    const run = await batch(folder, '--out', 'out', '--shard', '0/2', '--dry-run');
    return [...run.stdout.matchAll(/mesh-\d+/g)].map(([name]) => name).sort();
  };
  const part = await partOf('in');
  assert.ok(part.length > 0);
  assert.deepEqual(await partOf('other'), part);
});

for (const signal of ['SIGKILL', 'SIGTERM', 'SIGINT'])
  test(`a run that ends by ${signal} can be resumed`, async (t) => {
    const { at, batch } = inFolder(t, {});
    // Programs with sanitizers take much longer to start.
    const count = isInstrumented ? 16 : 40;
    const made = writeManyMeshes(at('in'), {
      count,
      most: isInstrumented ? 100 : 300,
      broken: 0.1,
    });
    const args = ['batch', 'in', '--out', 'out', '--resume'];
    for (const done of [1 / 8, 3 / 8, 5 / 8]) {
      const { child, finished } = startAbflat(args, { cwd: at() });
      await untilLines(at('out/manifest.jsonl'), done * count);
      child.kill(signal);
      const { signal: ended, stderr } = await finished;
      assert.equal(ended, signal);
      if (signal === 'SIGKILL') continue;
      assert.match(stderr, /interrupted\. The same command with --resume goes on from here/);
      assert.deepEqual(
        filesBelow(at('out')).filter((name) => name.startsWith('.')),
        [],
      );
    }
    assert.equal((await batch(...args.slice(1))).code, 1);
    const lines = manifestOf(at('out'));
    assert.equal(lines.length, made.length);
    const good = made.filter(({ broken }) => !broken).map(({ name }) => name);
    assert.deepEqual(
      lines.filter(({ status }) => status === 'done').map(({ name }) => name),
      good.sort(),
    );
    const expected = lines.flatMap(({ files, layout }) => [
      ...files.map(({ path }) => path),
      layout,
    ]);
    assert.deepEqual(
      filesBelow(at('out')),
      [...expected.filter(Boolean), 'manifest.jsonl', 'report.html'].sort(),
    );
    const verified = await batch('out', '--run', 'verify', '--out', 'verified');
    assert.equal(verified.code, 0, verified.stdout);
  });

test('the end of a manifest that was cut off is written anew', async (t) => {
  const { at, batch } = inFolder(t, { 'in/a.obj': CUBE, 'in/b.obj': grid(2) });
  await batch('in', '--out', 'out');
  const whole = readFileSync(at('out/manifest.jsonl'), 'utf8');
  writeFileSync(at('out/manifest.jsonl'), whole.slice(0, -40));
  assert.equal((await batch('in', '--out', 'out', '--resume')).code, 0);
  assert.deepEqual(namesIn(at('out')), ['a.obj', 'b.obj']);
});

test('only one run at a time works in a folder', async (t) => {
  const { at, batch } = inFolder(t, { 'in/a.obj': objText(LONG) });
  const first = startAbflat(['batch', 'in', '--out', 'out'], { cwd: at() });
  await untilLines(at('out/manifest.jsonl'), 0);
  const second = await batch('in', '--out', 'out', '--resume');
  assert.equal(second.code, 5);
  assert.match(second.stderr, /in use by another run/);
  assert.equal((await first.finished).code, 0);
});

test('a mesh that takes too long ends alone, and is tried again with another limit', async (t) => {
  const { at, batch } = inFolder(t, { 'in/a.obj': CUBE, 'in/b.obj': objText(torus(500, 300)) });
  const limited = (seconds, ...args) =>
    batch('in', '--out', 'out', '--time-limit', String(seconds), '--resume', ...args);
  assert.equal((await limited(LIMIT)).code, 1);
  const [small, large] = manifestOf(at('out'));
  assert.equal(small.status, 'done', small.message);
  assert.equal(large.status, 'timeLimit');
  assert.match(large.message, /^took longer than [\d.]+ s$/);
  assert.match((await limited(LIMIT, '--dry-run')).stdout, /^0 to do, 2 done/m);
  assert.match((await limited(600, '--dry-run')).stdout, /^1 to do, 1 done/m);
  const free = await batch('in', '--out', 'out', '--resume', '--dry-run');
  assert.match(free.stdout, /^1 to do, 1 done/m);
});

test('a mesh that needs too much memory ends alone', {
  skip: isInstrumented && 'sanitizers reserve more memory than any limit',
}, async (t) => {
  const { at, batch } = inFolder(t, { 'in/a.obj': CUBE, 'in/b.obj': objText(torus(500, 300)) });
  const run = await batch('in', '--out', 'out', '--memory-limit', '90');
  assert.equal(run.code, 1);
  const [small, large] = manifestOf(at('out'));
  assert.equal(small.status, 'done', small.message);
  assert.equal(large.status, 'memoryLimit', large.message);
  assert.equal(large.message, 'needs more memory than 90 MB');
  const again = await batch('in', '--out', 'out', '--resume', '--dry-run');
  assert.match(again.stdout, /^1 to do, 1 done/m);
});

test('a mesh that is predicted to need all memory runs alone', async (t) => {
  const { at, batch } = inFolder(t, { 'in/a.obj': CUBE, 'in/b.obj': objText(torus(60, 40)) });
  assert.equal((await batch('in', '--out', 'out', '--total-memory', '1')).code, 0);
  assert.deepEqual(hasResults(at('out')), ['a.obj', 'b.obj']);
});

test('a folder that cannot be made is told before any work', async (t) => {
  const { at, batch } = inFolder(t, { 'a.obj': CUBE });
  const run = await batch('a.obj', '--out', 'a.obj/out');
  assert.equal(run.code, 5);
  assert.match(run.stderr, /cannot create the folder a\.obj\/out: Not a directory/);
  assert.deepEqual(filesBelow(at()), ['a.obj']);
});

test('a process that is killed takes only its mesh, which is tried again', async (t) => {
  if (process.platform !== 'linux') return t.skip('finds processes in /proc');
  const { at, batch } = inFolder(t, { 'in/a.obj': CUBE, 'in/b.obj': objText(torus(500, 300)) });
  const args = ['batch', 'in', '--out', 'out', '--resume'];
  const { child, finished } = startAbflat(args, { cwd: at() });
  await untilLines(at('out/manifest.jsonl'), 1);
  const children = readFileSync(`/proc/${child.pid}/task/${child.pid}/children`, 'utf8');
  process.kill(Number(children), 'SIGKILL');
  assert.equal((await finished).code, 1);
  const [small, large] = manifestOf(at('out'));
  assert.equal(small.status, 'done');
  assert.equal(large.status, 'crashed');
  assert.match(large.message, /^was ended by signal 9/);
  assert.match((await batch(...args.slice(1), '--dry-run')).stdout, /^1 to do, 1 done/m);
});
