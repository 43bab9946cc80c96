// Disks that are full or read-only, user limits, and interruption while running.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { chmodSync, linkSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { PROGRAM, runAbflat, startAbflat } from '../support/run-abflat.mjs';
import { grid } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { contentsOf } from './support.mjs';

const OLD = 'what was there before';
const isRoot = process.getuid?.() === 0;

/** A folder with a mesh of the given size and an older result. */
function prepared(at, size = 40) {
  writeFileSync(at('in.obj'), grid(size));
  writeFileSync(at('out.obj'), OLD);
  return contentsOf(at());
}

/** Calls `work` with a small file system mounted in a folder; skips if mounting is not allowed. */
async function onDisk(t, options, work) {
  const at = tempFolder(t);
  const disk = (name = '') => at(`disk/${name}`);
  mkdirSync(disk());
  const mount = ['-t', 'tmpfs', '-o', options, 'tmpfs', disk()];
  if (!isRoot || spawnSync('mount', mount).status !== 0)
    return t.skip('file systems cannot be mounted here');
  try {
    await work(disk);
  } finally {
    spawnSync('umount', [disk()]);
  }
}

test('a full disk leaves what is on it', (t) =>
  onDisk(t, 'size=256k', async (disk) => {
    const before = prepared(disk);
    const args = ['flatten', 'in.obj', '-o', 'out.obj', '--report', 'r.json'];
    const run = await runAbflat(args, { cwd: disk() });
    assert.equal(run.code, 5, run.stderr);
    assert.match(run.stderr, /^abflat: cannot write out\.obj: No space left on device\.\n$/);
    assert.deepEqual(contentsOf(disk()), before);
  }));

test('a disk that is read-only leaves what is on it', (t) =>
  onDisk(t, 'size=1m', async (disk) => {
    const before = prepared(disk);
    assert.equal(spawnSync('mount', ['-o', 'remount,ro', disk()]).status, 0);
    const run = await runAbflat(['flatten', 'in.obj', '-o', 'out.obj'], { cwd: disk() });
    assert.equal(run.code, 5, run.stderr);
    assert.match(run.stderr, /^abflat: cannot write out\.obj: Read-only file system[^\n]*\n$/);
    assert.deepEqual(contentsOf(disk()), before);
  }));

test('a folder that is read-only, or a file of others, is named', async (t) => {
  const at = tempFolder(t);
  const wrapper = isRoot ? ['setpriv', '--reuid=65534', '--regid=65534', '--clear-groups'] : [];
  chmodSync(at(), 0o755);
  if (spawnSync(wrapper[0] ?? 'true', [...wrapper.slice(1), PROGRAM, '--version']).status !== 0)
    return t.skip('another user cannot run the program');
  const before = prepared(at);
  const cases = [
    [
      () => chmodSync(at(), 0o555),
      /cannot write new\.obj: Permission denied in folder \./,
      'new.obj',
    ],
    [() => chmodSync(at('out.obj'), 0o444), /cannot write out\.obj: Permission denied/, 'out.obj'],
  ];
  for (const [prepare, sentence, output] of cases) {
    prepare();
    const run = await runAbflat(['flatten', 'in.obj', '-o', output], { cwd: at(), wrapper });
    assert.equal(run.code, 5, run.stderr);
    assert.match(run.stderr, sentence);
    assert.deepEqual(contentsOf(at()), before);
  }
  chmodSync(at(), 0o755);
});

test("a limit of the user's on the size of files is an error as any other", async (t) => {
  const at = tempFolder(t);
  const before = prepared(at);
  const wrapper = ['sh', '-c', 'ulimit -f 8; exec "$@"', 'sh'];
  const run = await runAbflat(['flatten', 'in.obj', '-o', 'out.obj'], { cwd: at(), wrapper });
  assert.equal(run.code, 5, run.signal ?? run.stderr);
  assert.match(run.stderr, /cannot write out\.obj: File too large/);
  assert.deepEqual(contentsOf(at()), before);
});

test('another name of a file that is replaced keeps the old content', async (t) => {
  const at = tempFolder(t);
  prepared(at, 3);
  linkSync(at('out.obj'), at('second.obj'));
  const run = await runAbflat(['flatten', 'in.obj', '-o', 'out.obj'], { cwd: at() });
  assert.equal(run.code, 0, run.stderr);
  assert.match(readFileSync(at('out.obj'), 'utf8'), /^vt /m);
  assert.equal(readFileSync(at('second.obj'), 'utf8'), OLD);
  const both = ['flatten', 'in.obj', '-o', 'out.obj', '--report', 'third.obj'];
  linkSync(at('out.obj'), at('third.obj'));
  assert.equal((await runAbflat(both, { cwd: at() })).code, 2);
});

test('links that lead nowhere or round in circles are named', async (t) => {
  const at = tempFolder(t);
  const before = Object.keys(prepared(at, 3));
  symlinkSync('b.obj', at('a.obj'));
  symlinkSync('a.obj', at('b.obj'));
  symlinkSync('none/x.obj', at('lost.obj'));
  for (const [output, sentence] of [
    ['a.obj', /cannot write a\.obj: Too many levels of symbolic links/],
    ['lost.obj', /cannot write lost\.obj: there is no folder none/],
  ]) {
    const run = await runAbflat(['flatten', 'in.obj', '-o', output], { cwd: at() });
    assert.equal(run.code, 5, run.stderr);
    assert.match(run.stderr, sentence);
  }
  assert.deepEqual(Object.keys(contentsOfFiles(at)).sort(), before);
});

const contentsOfFiles = (at) => ({
  'in.obj': readFileSync(at('in.obj')),
  'out.obj': readFileSync(at('out.obj')),
});

for (const signal of ['SIGINT', 'SIGTERM'])
  test(`${signal} while it solves ends it, and leaves nothing`, async (t) => {
    const at = tempFolder(t);
    const before = prepared(at, 300);
    const { child, finished } = startAbflat(['unwrap', 'in.obj', '-o', 'out.obj'], { cwd: at() });
    await sleep(300);
    child.kill(signal);
    const run = await finished;
    assert.equal(run.signal, signal);
    assert.deepEqual(contentsOf(at()), before);
  });
