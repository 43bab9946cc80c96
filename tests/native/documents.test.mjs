// What the documents show of the program and the library works as shown.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { which } from '../../scripts/lib/run.mjs';
import { codeBlocks, DOCUMENTS, exampleIn, textOf } from '../support/documents.mjs';
import { isInstrumented, PROGRAM, runAbflat } from '../support/run-abflat.mjs';
import { CUBE_OF_PARTS } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

/** tests/docs runs those of docs/. */
const SHOWN_IN = ['README.md'];

/** CONTRIBUTING.md names options of other programs, too. */
const OF_THE_PROGRAM = DOCUMENTS.filter((file) => file !== 'CONTRIBUTING.md');

/** Calls of these programs have options of their own. */
const OF_OTHERS = /\b(cmake|pip|pkg-config|vcpkg|bff-command-line|kubectl|podman) [^`\n]*/g;

/** A table of docs/migrating.md has options of another program in its first column. */
const FIRST_COLUMN = /^\| [^|]*\|/gm;

/** Names of commands, as the help lists them. */
async function commandNames() {
  const { stdout } = await runAbflat(['--help']);
  const [, list] = stdout.match(/^Commands:\n(.*?)\n\n/ms);
  return [...list.matchAll(/^ {2}([a-z]+) /gm)].map(([, name]) => name);
}

const optionsIn = (text) => text.match(/(?<![\w-])--[a-z][\w-]*/g) ?? [];

/** The table without its headings and without seconds, which differ. */
const rowsOf = (text) =>
  text
    .split('\n')
    .filter((line) => /^ +(auto|[\d.]+) /.test(line))
    .map((line) => line.trim().split(/ +/).toSpliced(-2, 1).join(' '));

test('every option that a document names is in the help of a command', async () => {
  const helps = await Promise.all(
    [[], ...(await commandNames())].map((each) => runAbflat([each, '--help'].flat())),
  );
  const known = new Set(helps.flatMap(({ stdout }) => optionsIn(stdout)));
  for (const document of OF_THE_PROGRAM) {
    const others = document === 'docs/migrating.md' ? FIRST_COLUMN : '';
    const text = textOf(document).replace(OF_OTHERS, '').replace(others, '');
    for (const option of optionsIn(text)) assert.ok(known.has(option), `${document}: ${option}`);
  }
});

test('every command of the program is described', async () => {
  const text = textOf('docs/command-line.md');
  const names = await commandNames();
  assert.ok(names.length > 5);
  for (const name of names) assert.match(text, new RegExp(`abflat ${name} `));
});

/** Runs a line of a document in a folder, in a shell. */
const typed = (line, cwd) =>
  spawnSync('sh', ['-c', line.replaceAll('build/native/abflat', `'${PROGRAM}'`)], {
    cwd,
    encoding: 'utf8',
  });

test('the commands that the documents show run as typed', (t) => {
  const at = tempFolder(t);
  writeFileSync(at('robot.obj'), CUBE_OF_PARTS);
  const made = ['sample head -o head.obj', 'unwrap robot.obj -o robot.glb'];
  for (const line of made) assert.equal(typed(`build/native/abflat ${line}`, at()).status, 0);

  const blocks = SHOWN_IN.flatMap((document) => codeBlocks(textOf(document)));
  const lines = blocks
    .flatMap(({ code }) => code.split('\n'))
    .filter((line) => line.includes('native/abflat '));
  assert.ok(lines.length > 5);
  for (const line of lines) {
    const { status, stderr } = typed(line, at());
    assert.equal(status, 0, `${line}\n${stderr}`);
  }
});

test('the table of balances is what the program prints', async (t) => {
  const at = tempFolder(t);
  const { code } = codeBlocks(textOf('docs/unwrapping.md')).find((block) =>
    block.code.startsWith('$ abflat'),
  );
  const [line, ...table] = code.split('\n');
  const { status, stdout, stderr } = typed(
    line.replace('$ ', '').replaceAll('abflat ', 'build/native/abflat '),
    at(),
  );
  assert.equal(status, 0, stderr);
  assert.equal(rowsOf(stdout).length, 5);
  assert.deepEqual(rowsOf(stdout), rowsOf(table.join('\n')));
});

const compiler = process.env.CXX ?? ['c++', 'g++', 'clang++'].map(which).find(Boolean);

/** Compiles a program against the public headers. */
function compiled(at, code, ...more) {
  writeFileSync(at('main.cpp'), code);
  const args = ['-std=c++17', '-I', join(ROOT, 'core/include'), at('main.cpp'), ...more];
  const { status, stderr } = spawnSync(compiler, args, { encoding: 'utf8' });
  assert.equal(status, 0, stderr);
}

test('the example of the library in the README compiles', (t) => {
  const [includes, body] = exampleIn('README.md', 'cpp').split('\n\n');
  const code = `${includes}\n#include <string>\nvoid f(const std::string& bytes) {\n${body}\n(void)flat;\n}\n`;
  compiled(tempFolder(t), code, '-fsyntax-only');
});

test('the program in the document of the library flattens a mesh', {
  skip: isInstrumented && 'the library needs the flags of its sanitizers',
}, (t) => {
  const at = tempFolder(t);
  const library = join(dirname(PROGRAM), 'core/libabflat.a');
  compiled(at, exampleIn('docs/cpp.md', 'flatten'), library, '-pthread', '-o', at('flatten'));
  const run = () => spawnSync(at('flatten'), { cwd: at(), encoding: 'utf8' });
  assert.match(run().stderr, /\w/, 'no file to read');
  assert.equal(typed('build/native/abflat sample hemisphere -o head.obj', at()).status, 0);
  const { status, stderr } = run();
  assert.equal(status, 0, stderr);
  assert.match(readFileSync(at('head-uv.obj'), 'utf8'), /^vt /m);
});
