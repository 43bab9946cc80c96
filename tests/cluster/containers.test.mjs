// The recipes for containers: manifests of Kubernetes by its schema, and the commands of all of them
// run here, as far as they need no cluster.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, realpathSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { Job } from 'kubernetes-models/batch/v1/Job';
import { parseAllDocuments } from 'yaml';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { REQUIREMENTS } from '../../scripts/lib/requirements.mjs';
import { PROGRAM } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { filesOf, manifestOf, plainRun, RECIPES, run, writeMeshes } from './support/batches.mjs';

const read = (name) => readFileSync(join(RECIPES, name), 'utf8');
const jobs = () => parseAllDocuments(read('kubernetes.yaml')).map((each) => each.toJSON());

/** What an image has on its path. */
function image(at) {
  mkdirSync(at('bin'));
  symlinkSync(PROGRAM, at('bin/abflat'));
  symlinkSync(join(RECIPES, 'shard.sh'), at('bin/abflat-shard'));
  return { PATH: `${at('bin')}:${process.env.PATH}`, ABFLAT: 'abflat' };
}

/** Runs `start(part)` for all parts and merges them; the result is that of a plain run. */
async function assertWhole(at, parts, start, merge) {
  writeMeshes(at('meshes'), 8);
  const whole = await plainRun(at('meshes'), at('whole'));
  for (let part = 0; part < parts; part++) {
    const { code, stderr } = await start(part);
    assert.equal(code, 0, stderr);
  }
  const { code, stderr } = await merge();
  assert.equal(code, 1, stderr); // a mesh is broken
  assert.deepEqual(manifestOf(at('out')), whole.lines);
  assert.deepEqual(filesOf(at('out')), whole.files);
}

test('Kubernetes accepts the jobs, and would not accept mistakes', () => {
  for (const job of jobs()) {
    new Job(job).validate();
    const wrong = structuredClone(job);
    wrong.spec.template.spec.restartPolicy = 7;
    assert.throws(() => new Job(wrong).validate());
    // No field is misspelled, which the schema leaves to the server.
    const known = ['completionMode', 'completions', 'parallelism', 'template'];
    known.push('backoffLimitPerIndex', 'maxFailedIndexes');
    assert.deepEqual(
      Object.keys(job.spec).filter((key) => !known.includes(key)),
      [],
    );
  }
  const [parts] = jobs();
  const [{ args }] = parts.spec.template.spec.containers;
  assert.equal(args[1], `${parts.spec.completions}`);
});

test('the commands of the Kubernetes jobs make one whole', async (t) => {
  const at = tempFolder(t);
  const env = image(at);
  const [parts, merge] = jobs().map(({ spec }) => spec.template.spec.containers[0]);
  const here = (word) => word.replace('/meshes', at('meshes')).replace('/out', at('out'));
  const start = (part) => {
    const index = { '$(JOB_COMPLETION_INDEX)': `${part}`, 64: '3' };
    const [command, ...args] = [...parts.command, ...parts.args].map(
      (word) => index[word] ?? here(word),
    );
    return run(command, args, { env });
  };
  await assertWhole(at, 3, start, () => run('abflat', merge.args.map(here), { env }));
});

test('the command of the AWS Batch job does its part', async (t) => {
  const at = tempFolder(t);
  const env = image(at);
  const { parameters, containerProperties } = JSON.parse(read('aws-batch.json'));
  assert.ok(Number(parameters.parts) >= 2);
  const values = { parts: '2', meshes: at('meshes'), out: at('out') };
  assert.deepEqual(Object.keys(values), Object.keys(parameters));
  const [command, ...args] = containerProperties.command.map((word) =>
    word.startsWith('Ref::') ? values[word.slice(5)] : word,
  );
  const start = (part) =>
    run(command, args, { env: { ...env, AWS_BATCH_JOB_ARRAY_INDEX: `${part}` } });
  const merge = () => run('abflat', ['batch', '--merge', '--out', at('out'), '-q'], { env });
  await assertWhole(at, 2, start, merge);
});

test('the image has what a build needs, and copies what is there', () => {
  const lines = read('Containerfile').replaceAll('\\\n', ' ').split('\n');
  const steps = lines.filter((line) => line.trim() && !line.startsWith('#'));
  for (const step of steps) assert.match(step, /^(FROM|RUN|COPY|ENTRYPOINT) \S/);
  const installed = steps.find((step) => step.includes('cmake')).split(/\s+/);
  const needed = REQUIREMENTS.filter(({ purpose }) => purpose === 'build').flatMap(
    ({ apt }) => apt ?? [],
  );
  assert.deepEqual(
    needed.filter((name) => !installed.includes(name)),
    [],
  );
  for (const step of steps.filter((line) => /^COPY (?!--from)/.test(line)))
    assert.ok(existsSync(join(ROOT, step.split(' ')[1])), step);
});

const isDebian = spawnSync('dpkg', ['--version']).status === 0;

test('the image has the libraries of the program', { skip: !isDebian && 'not on Debian' }, () => {
  const steps = read('Containerfile').split('FROM')[2].replaceAll('\\\n', ' ').split(/\s+/);
  const { stdout } = spawnSync('ldd', [PROGRAM], { encoding: 'utf8' });
  const libraries = [...stdout.matchAll(/=> (\/\S+)/g)].map(([, path]) => realpathSync(path));
  const packages = libraries.map(
    (path) => spawnSync('dpkg', ['-S', path], { encoding: 'utf8' }).stdout.split(':')[0],
  );
  assert.ok(packages.length > 5, stdout);
  const always = ['libc6', 'libgcc-s1', 'libstdc++6'];
  assert.deepEqual(
    packages.filter((name) => ![...steps, ...always].includes(name)),
    [],
  );
});
