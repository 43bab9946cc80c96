// Files are written completely or not at all, whatever happens.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  chmodSync,
  lstatSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { PROGRAM, runAbflat, startAbflat } from '../support/run-abflat.mjs';
import { fan, grid, TETRAHEDRON } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const OLD = 'what was there before';
const isTemporary = (name) => name.startsWith('.abflat-');

/** A folder with a mesh and an older result. */
function prepared(t) {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(6));
  writeFileSync(at('out.obj'), OLD);
  return at;
}

const flatten = (at, args) => runAbflat(['flatten', ...args], { cwd: at() });

test('a target that cannot be written ends with exit code 5 and leaves everything as it was', async (t) => {
  const at = prepared(t);
  mkdirSync(at('folder'));
  for (const [target, sentence] of [
    ['missing/out.obj', /cannot write missing\/out\.obj: there is no folder missing/],
    ['out.obj/result.obj', /cannot write out\.obj\/result\.obj: out\.obj is not a folder/],
    ['folder', /cannot write folder: it is a folder/],
    ['/proc/abflat.obj', /cannot write \/proc\/abflat\.obj: /],
    [`${'x'.repeat(300)}.obj`, /cannot write x+\.obj: /],
  ]) {
    const run = await flatten(at, ['in.obj', '-o', target]);
    assert.equal(run.code, 5, `${target}: ${run.stderr}`);
    assert.match(run.stderr, sentence);
    assert.match(run.stderr, /^abflat: [^\n]+\n$/);
  }
  assert.equal(readFileSync(at('out.obj'), 'utf8'), OLD);
  assert.deepEqual(readdirSync(at()).sort(), ['folder', 'in.obj', 'out.obj']);
});

test('a report that cannot be written keeps the layout from being replaced', async (t) => {
  const at = prepared(t);
  for (const report of ['missing/r.json', '/dev/full']) {
    const run = await flatten(at, ['in.obj', '-o', 'out.obj', '--report', report]);
    assert.equal(run.code, 5, run.stderr);
    assert.match(run.stderr, /cannot write .*(missing|full)/);
    assert.equal(readFileSync(at('out.obj'), 'utf8'), OLD);
  }
  assert.deepEqual(readdirSync(at()).sort(), ['in.obj', 'out.obj']);
});

test('a full device ends with exit code 5', async (t) => {
  const at = prepared(t);
  const run = await flatten(at, ['in.obj', '-o', '/dev/full']);
  assert.equal(run.code, 5);
  assert.match(run.stderr, /cannot write \/dev\/full: No space left/);
});

test('devices are written to and not replaced', async (t) => {
  const at = prepared(t);
  const run = await flatten(at, ['in.obj', '-o', '/dev/null', '--report', '/dev/null']);
  assert.equal(run.code, 0, run.stderr);
  assert.ok(statSync('/dev/null').isCharacterDevice());
});

test('standard output that is closed by its reader ends with exit code 5', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(100));
  const { child, finished } = startAbflat(['flatten', 'in.obj', '-o', '-'], { cwd: at() });
  child.stdout.destroy();
  const run = await finished;
  assert.equal(run.code, 5);
  assert.match(run.stderr, /cannot write standard output/);
});

test('the result of an earlier run stays when the next one fails', async (t) => {
  const at = prepared(t);
  writeFileSync(at('closed.off'), TETRAHEDRON);
  writeFileSync(at('broken.obj'), 'v 1 2\n');
  for (const [input, code] of [
    ['closed.off', 4],
    ['broken.obj', 3],
    ['none.obj', 3],
  ]) {
    const run = await flatten(at, [input, '-o', 'out.obj']);
    assert.equal(run.code, code);
    assert.equal(readFileSync(at('out.obj'), 'utf8'), OLD);
  }
});

test('a file can be replaced by its own result, again and again', async (t) => {
  const at = prepared(t);
  const first = await flatten(at, ['in.obj', '-o', 'in.obj']);
  assert.equal(first.code, 0, first.stderr);
  const once = readFileSync(at('in.obj'), 'utf8');
  assert.match(once, /^vt /m);
  await flatten(at, ['in.obj', '-o', 'in.obj']);
  assert.equal(readFileSync(at('in.obj'), 'utf8'), once);
  assert.deepEqual(readdirSync(at()).sort(), ['in.obj', 'out.obj']);
});

test('an OFF file is not replaced by OBJ text, whatever it is called', async (t) => {
  const at = prepared(t);
  const off = 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n';
  writeFileSync(at('mesh'), off);
  symlinkSync('mesh', at('link.obj'));
  for (const [input, output] of [
    ['mesh', 'mesh'],
    ['./mesh', 'mesh'],
    ['mesh', 'link.obj'],
  ]) {
    const run = await flatten(at, [input, '-o', output, '--report', 'r.json']);
    assert.equal(run.code, 2, run.stderr);
    assert.match(run.stderr, /mesh: the result is OBJ and would replace this OFF file/);
    assert.equal(readFileSync(at('mesh'), 'utf8'), off);
    const { error, input: counts } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    assert.deepEqual([error.code, counts.faces], ['InvalidOption', 1]);
  }
  assert.ok(lstatSync(at('link.obj')).isSymbolicLink());
});

test('permissions are those of the file that is replaced, or what umask asks for', async (t) => {
  const at = prepared(t);
  chmodSync(at('out.obj'), 0o604);
  const wrapper = ['sh', '-c', 'umask 027; exec "$@"', 'sh'];
  const args = ['flatten', 'in.obj', '-o'];
  for (const [target, mode] of [
    ['out.obj', 0o604],
    ['new.obj', 0o640],
  ]) {
    const run = await runAbflat([...args, target], { cwd: at(), wrapper });
    assert.equal(run.code, 0, run.stderr);
    assert.equal(statSync(at(target)).mode & 0o777, mode);
  }
});

test('a symbolic link stays one, its target is replaced', async (t) => {
  const at = prepared(t);
  mkdirSync(at('real'));
  writeFileSync(at('real/out.obj'), OLD);
  symlinkSync('real/out.obj', at('link.obj'));
  symlinkSync('real/new.obj', at('dangling.obj'));
  for (const [link, file] of [
    ['link.obj', 'real/out.obj'],
    ['dangling.obj', 'real/new.obj'],
  ]) {
    const run = await flatten(at, ['in.obj', '-o', link]);
    assert.equal(run.code, 0, run.stderr);
    assert.ok(lstatSync(at(link)).isSymbolicLink());
    assert.match(readFileSync(at(file), 'utf8'), /^vt /m);
  }
});

for (const [signal, action] of [
  ['SIGINT', 'Ctrl-C'],
  ['SIGTERM', 'kill'],
  ['SIGHUP', 'a closed terminal'],
])
  test(`${action} while writing leaves the old file and nothing else`, async (t) => {
    const at = prepared(t);
    // Nobody reads the pipe, so the program waits in the middle of writing.
    assert.equal(spawnSync('mkfifo', [at('report')]).status, 0);
    const args = ['flatten', 'in.obj', '-o', 'out.obj', '--report', 'report'];
    const { child, finished } = startAbflat(args, { cwd: at() });
    while (!readdirSync(at()).some(isTemporary) && child.exitCode === null) await sleep(5);
    assert.ok(readdirSync(at()).some(isTemporary), 'the layout is complete, but has no name yet');
    child.kill(signal);
    const run = await finished;
    assert.equal(run.signal, signal);
    assert.equal(readFileSync(at('out.obj'), 'utf8'), OLD);
    assert.deepEqual(readdirSync(at()).sort(), ['in.obj', 'out.obj', 'report']);
  });

test('a shell sees 143 for a run that was ended', (t) => {
  const at = prepared(t);
  assert.equal(spawnSync('mkfifo', [at('report')]).status, 0);
  const script = `
    "$0" flatten in.obj -o out.obj --report report & pid=$!
    until ls -A | grep -q '^\\.abflat-'; do sleep 0.01; done
    kill -TERM $pid; wait $pid; exit $?`;
  const ended = spawnSync('sh', ['-c', script, PROGRAM], { cwd: at(), timeout: 60_000 });
  assert.equal(ended.status, 143);
  assert.equal(readFileSync(at('out.obj'), 'utf8'), OLD);
});

test('lack of memory ends with exit code 4 and a sentence', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(300));
  const wrapper = ['sh', '-c', 'ulimit -v 60000; exec "$@"', 'sh'];
  const probe = await runAbflat(['--version'], { wrapper });
  if (probe.code !== 0) return t.skip('the program cannot start with little memory (sanitizers?)');
  const commands = [
    ['flatten', 'in.obj', '-o', 'out.obj'],
    ['sample', 'head', '--detail', '1000', '-o', 'out.obj'],
    ['compare', 'in.obj', '--json', 'out.json'],
  ];
  for (const args of commands) {
    const run = await runAbflat(args, { cwd: at(), wrapper });
    assert.equal(run.code, 4, `${run.signal} ${run.stderr}`);
    assert.match(run.stderr, /^abflat: .*not enough memory.*\n$/);
  }
  assert.deepEqual(readdirSync(at()), ['in.obj']);
});

test('two runs at once into the same folder do not disturb each other', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), fan(40));
  const names = Array.from({ length: 8 }, (_, i) => `out${i}.obj`);
  const runs = await Promise.all(names.map((name) => flatten(at, ['in.obj', '-o', name])));
  assert.ok(runs.every((run) => run.code === 0));
  const texts = new Set(names.map((name) => readFileSync(at(name), 'utf8')));
  assert.equal(texts.size, 1);
});
