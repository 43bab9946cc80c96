// Files with any name, and how text from files appears on a terminal.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { runAbflat } from '../support/run-abflat.mjs';
import { grid } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

/** Asserts that no character is a terminal command, except for line ends. */
const assertPlain = (text) => {
  const commands = [...text].filter((c) => (c < ' ' && c !== '\n') || (c >= '\x7f' && c < '\xa0'));
  assert.deepEqual(commands, [], JSON.stringify(text));
};

const NAMES = [
  'a b  c.obj',
  'é 日本 🙂.obj',
  'it\'s "q".obj',
  '#100%.obj',
  `${'x'.repeat(251)}.obj`,
];
NAMES.push('a\nb\x1b[31m.obj', '$(touch pwned).obj', '*.obj', 'no-ending', '.obj', '...obj');

test('any name can be read and written', async (t) => {
  const at = tempFolder(t);
  for (const name of NAMES) {
    writeFileSync(at(name), grid(3));
    const run = await runAbflat(['flatten', name, '-o', name, '--report', 'r.json'], { cwd: at() });
    assert.equal(run.code, 0, run.stderr);
    assert.match(readFileSync(at(name), 'utf8'), /^vt /m);
    assert.equal(JSON.parse(readFileSync(at('r.json'))).input.path, name);
  }
  assert.deepEqual(readdirSync(at()).sort(), [...NAMES, 'r.json'].sort());
});

test('a name that begins with a dash is told apart from an option', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('-x.obj'), grid(3));
  const bare = await runAbflat(['inspect', '-x.obj'], { cwd: at() });
  assert.equal(bare.code, 2);
  assert.match(bare.stderr, /there is no option '-x\.obj'\. If that is a file, write \.\/-x\.obj/);
  for (const args of [['./-x.obj'], ['--', '-x.obj']])
    assert.equal((await runAbflat(['inspect', ...args], { cwd: at() })).code, 0);
});

test('messages hold no commands for the terminal', async (t) => {
  const at = tempFolder(t);
  const evil = '\x1b]0;title\x07\x9b31m\x7f';
  writeFileSync(at('words.obj'), `v ${evil} 0 0\n`);
  writeFileSync(at('words.ply'), `ply\n${evil}\n`);
  const gltf = { asset: { version: evil }, meshes: [] };
  writeFileSync(at('words.gltf'), JSON.stringify(gltf));
  writeFileSync(at(`${evil}.obj`), 'v 1\n');
  for (const name of ['words.obj', 'words.ply', 'words.gltf', `${evil}.obj`, `${evil}.none`]) {
    const run = await runAbflat(['inspect', name], { cwd: at() });
    assert.equal(run.code, 3, run.stderr);
    assertPlain(run.stderr);
    assert.match(run.stderr, /^abflat: [^\n]+\n$/);
  }
  writeFileSync(at(`${evil}.obj`), grid(2));
  const seen = await runAbflat(['inspect', `${evil}.obj`], { cwd: at() });
  assert.equal(seen.code, 0);
  assertPlain(seen.stdout);
});

test('standard output has other names too', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(3));
  const plain = await runAbflat(['flatten', 'in.obj', '-o', '-'], { cwd: at() });
  for (const name of ['/dev/stdout', '/dev/fd/1'])
    for (const pipe of ['| cat', '> out; cat out']) {
      const wrapper = ['sh', '-c', `"$@" ${pipe}`, 'sh'];
      const run = await runAbflat(['flatten', 'in.obj', '-o', name], { cwd: at(), wrapper });
      assert.deepEqual([run.stdout, run.stderr], [plain.stdout, ''], `${name} ${pipe}`);
    }
  const both = ['flatten', 'in.obj', '-o', '-', '--report', '/dev/stdout'];
  assert.equal((await runAbflat(both, { cwd: at() })).code, 2);
});

test('help that cannot be written is no success', async () => {
  const wrapper = ['sh', '-c', '"$@" > /dev/full', 'sh'];
  for (const args of [['--help'], ['--version'], ['unwrap', '--help']])
    assert.equal((await runAbflat(args, { wrapper })).code, 5, args.join(' '));
});

test('an empty file is called so, whatever its format', async (t) => {
  const at = tempFolder(t);
  for (const ending of ['obj', 'ply', 'stl', 'off', 'glb', 'gltf', 'txt']) {
    writeFileSync(at(`in.${ending}`), '');
    const run = await runAbflat(['inspect', `in.${ending}`], { cwd: at() });
    assert.equal(run.code, 3);
    assert.match(run.stderr, /the file is empty/);
  }
});
