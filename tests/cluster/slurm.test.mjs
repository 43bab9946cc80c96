// The recipe for Slurm, run by a real one of a single node: an array of parts, its node drained
// midway and the parts requeued, and the job that merges them.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { tempFolder } from '../support/temp-folder.mjs';
import { filesOf, manifestOf, plainRun, RECIPES, until, writeMeshes } from './support/batches.mjs';
import { startSlurm, withoutSlurm } from './support/slurm.mjs';

const PARTS = 4;

test('parts, requeued from a drained node, make the same manifest', {
  skip: withoutSlurm,
}, async (t) => {
  const at = tempFolder(t);
  const names = writeMeshes(at('meshes'), 60);
  const whole = await plainRun(at('meshes'), at('whole'));
  const slurm = await startSlurm();
  t.after(slurm.end);
  const args = [`${PARTS}`, at('meshes'), at('out')];
  const { code, stdout, stderr } = await slurm.run(join(RECIPES, 'slurm.sh'), ...args);
  assert.equal(code, 0, stderr);
  const [, array, merge] = stdout.match(/^parts: job (\d+), merge: job (\d+)/);
  const linesSoFar = () =>
    readdirSync(at('out'))
      .filter((name) => name.startsWith('manifest-'))
      .flatMap((name) =>
        readFileSync(at(`out/${name}`), 'utf8')
          .trim()
          .split('\n'),
      )
      .filter(Boolean).length;
  await until(
    () => linesSoFar() >= 3,
    () => slurm.logs(),
  );
  await slurm.run('scontrol', 'update', `nodename=${slurm.node}`, 'state=drain', 'reason=test');
  const running = async () =>
    (await slurm.run('squeue', '-h', '-t', 'R,CG', '-o', '%i %T')).stdout.trim().split('\n');
  const drained = (await running()).map((line) => line.split(' ')[0]).filter(Boolean);
  assert.ok(drained.length > 0, 'nothing ran any more when the node was drained');
  for (const task of drained) await slurm.run('scontrol', 'requeue', task);
  await until(async () => (await running()).join('') === '', 'parts to end');
  const before = linesSoFar();
  assert.ok(before < names.length, 'all was done before the node was drained');
  await slurm.run('scontrol', 'update', `nodename=${slurm.node}`, 'state=resume');
  // A part that was requeued waits for two minutes otherwise.
  for (const task of drained)
    await slurm.run('scontrol', 'update', `jobid=${task}`, 'starttime=now');
  const stateOf = async (job) => {
    const { stdout: text } = await slurm.run('scontrol', 'show', 'job', job);
    return [...text.matchAll(/JobState=(\w+)/g)].map(([, state]) => state);
  };
  const isEnded = (state) => !['PENDING', 'RUNNING', 'COMPLETING', 'REQUEUED'].includes(state);
  await until(async () => (await stateOf(merge)).every(isEnded), 'the merge');
  assert.deepEqual(await stateOf(array), Array(PARTS).fill('COMPLETED'), slurm.logs());
  // A mesh is broken, which the last job says by its exit code.
  assert.deepEqual(await stateOf(merge), ['FAILED']);
  assert.deepEqual(manifestOf(at('out')), whole.lines);
  assert.deepEqual(filesOf(at('out')), whole.files);
  t.diagnostic(`${before} of ${names.length} meshes were done when the node was drained`);
});
