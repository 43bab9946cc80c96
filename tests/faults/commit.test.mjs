// Outputs appear together or not at all, whichever system call fails and wherever the program is
// interrupted.

import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { fan } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { callsOf, contentsOf, eachOf, runWithFault, withoutFaults } from './support.mjs';

const INPUT = fan(6);
/** Two of the outputs replace an existing file, one does not. */
const OLD = { 'in.obj': INPUT, 'out.obj': 'an old mesh', 'report.json': 'an old report' };
const OUTPUTS = ['-o', 'out.obj', '--report', 'report.json', '--write-seams', 'seams.txt'];
const ARGS = ['unwrap', 'in.obj', ...OUTPUTS, '-q'];
const NAMES = ['in.obj', 'out.obj', 'report.json', 'seams.txt'];
const COMMITTING = ['link', 'rename', 'unlink'];

/** A folder in a new folder, with the old files. */
function prepared(at, name) {
  mkdirSync(at(name));
  for (const [file, text] of Object.entries(OLD)) writeFileSync(at(`${name}/${file}`), text);
  return (path = '') => at(`${name}/${path}`);
}

const isOld = (files) => JSON.stringify(files) === JSON.stringify(OLD);

/** Asserts that all outputs are new and complete. */
function assertNew(files, context) {
  assert.deepEqual(Object.keys(files).sort(), NAMES, context);
  assert.equal(files['in.obj'], INPUT, context);
  assert.match(files['out.obj'], /^vt [\s\S]*^f [\s\S]*\n$/m, context);
  assert.equal(JSON.parse(files['report.json']).valid, true, context);
  assert.notEqual(files['report.json'], OLD['report.json'], context);
}

/** Injects every fault at every call that it applies to; `check(run, files, context)`. */
async function atEveryCall(t, faultsOf, check) {
  const at = tempFolder(t);
  mkdirSync(at('runs'));
  const calls = await callsOf(
    prepared((name) => at(`runs/${name}`), 'plain'),
    ARGS,
  );
  for (const kind of ['open', 'read', 'write', 'fsync', 'close', ...COMMITTING])
    assert.ok(calls.includes(kind), `${kind} is watched`);
  const cases = calls.flatMap((kind, call) =>
    faultsOf(kind).map((fault) => ({ kind, call, fault })),
  );
  await eachOf(cases, async ({ kind, call, fault }, i) => {
    const folder = prepared((name) => at(`runs/${name}`), `run${i}`);
    const run = await runWithFault(folder, ARGS, call, fault);
    const context = `${fault} at call ${call}, ${kind}: ${run.code ?? run.signal} ${run.stderr}`;
    check(run, contentsOf(folder()), context, { kind, fault });
  });
  t.diagnostic(`${cases.length} runs, ${calls.length} calls each`);
}

test(
  'an error of any system call leaves all as it was, or all is done',
  { skip: withoutFaults },
  (t) =>
    atEveryCall(
      t,
      (kind) => (['write', 'fsync'].includes(kind) ? ['EIO', 'ENOSPC', 'always ENOSPC'] : ['EIO']),
      (run, files, context) => {
        assert.ok([0, 3, 5].includes(run.code), context);
        if (run.code === 0) return assertNew(files, context);
        // A failure to read the input is reported in the requested report.
        const report = run.code === 3 ? JSON.parse(files['report.json']).error : null;
        assert.equal(report?.code, run.code === 3 ? 'UnreadableFile' : undefined, context);
        assert.deepEqual({ ...files, 'report.json': OLD['report.json'] }, OLD, context);
        if (run.code === 5) assert.deepEqual(files, OLD, context);
        const sentence =
          run.code === 3 ? /^abflat: cannot read [^\n]+\n$/ : /^abflat: cannot write [^\n]+\n$/;
        assert.match(run.stderr, sentence, context);
      },
    ),
);

test('an interrupted call is repeated, and a short one goes on', { skip: withoutFaults }, (t) =>
  atEveryCall(
    t,
    (kind) => (['read', 'write'].includes(kind) ? ['EINTR', 'short'] : ['EINTR']),
    (run, files, context) => {
      assert.equal(run.code, 0, context);
      assertNew(files, context);
    },
  ),
);

test('a file system that only interrupts is given up', { skip: withoutFaults }, (t) =>
  atEveryCall(
    t,
    (kind) => (['write', 'fsync', 'open'].includes(kind) ? ['always EINTR'] : []),
    (run, files, context) => {
      assert.ok([0, 3, 5].includes(run.code), context);
      if (run.code === 0) assertNew(files, context);
      else assert.equal(Object.keys(files).length, Object.keys(OLD).length, context);
    },
  ),
);

test('a file that cannot get its old name back is named', { skip: withoutFaults }, (t) =>
  atEveryCall(
    t,
    (kind) => (kind === 'rename' ? ['always EIO'] : []),
    (run, files, context) => {
      assert.equal(run.code, 5, context);
      for (const [name, text] of Object.entries(OLD)) {
        const [, kept] =
          run.stderr.match(
            new RegExp(`cannot write ${name}: [^;]*; its previous content is in '([^']+)'`),
          ) ?? [];
        assert.equal(files[kept ? kept.replace('./', '') : name], text, context);
      }
    },
  ),
);

test('without second names for files all is the same', { skip: withoutFaults }, (t) =>
  atEveryCall(
    t,
    (kind) => (kind === 'link' ? ['always EPERM'] : []),
    (run, files, context) => {
      assert.equal(run.code, 0, context);
      assertNew(files, context);
    },
  ),
);

for (const signal of ['SIGTERM', 'SIGINT', 'SIGHUP'])
  test(`${signal} at any system call leaves no temporary file`, { skip: withoutFaults }, (t) =>
    atEveryCall(
      t,
      (kind) => (signal === 'SIGTERM' || COMMITTING.includes(kind) ? [signal] : []),
      (run, files, context) => {
        assert.equal(run.signal, signal, context);
        if (!isOld(files)) assertNew(files, context);
      },
    ),
  );

test('a program that is killed leaves each file whole, old or new', { skip: withoutFaults }, (t) =>
  atEveryCall(
    t,
    (kind) => (COMMITTING.includes(kind) ? ['SIGKILL'] : []),
    (run, files, context) => {
      assert.equal(run.signal, 'SIGKILL', context);
      assert.equal(files['in.obj'], INPUT, context);
      assert.ok(/^f /m.test(files['out.obj']) || files['out.obj'] === OLD['out.obj'], context);
      const report = files['report.json'];
      assert.ok(report === OLD['report.json'] || JSON.parse(report).valid, context);
    },
  ),
);
