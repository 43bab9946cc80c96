// What the command line accepts and rejects, and what it says about itself.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { kebabCase } from '../../scripts/lib/schema.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { SCHEMA } from '../support/schema.mjs';
import { TRIANGLE } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const FLATTEN = ['flatten', 'in.obj', '-o', 'out.obj'];

/** Arguments, and what the message must say. */
const WRONG = [
  [[], /flatten, pack, bake, verify, batch, inspect, sample, sweep, compare or reproduce/],
  [['unfold'], /no command 'unfold'\. Use unwrap, flatten/],
  [['unwrap'], /IN/],
  [['flatten'], /IN/],
  [['flatten', 'in.obj'], /--output/],
  [['flatten', 'in.obj', '-o'], /--output takes exactly one value/],
  [['flatten', 'in.obj', '-o', ''], /--output: the name is empty/],
  [[...FLATTEN, '-o', 'other.obj'], /--output takes exactly one value/],
  [[...FLATTEN, 'in2.obj'], /in2\.obj/],
  [[...FLATTEN, '--what'], /--what/],
  [[...FLATTEN, '--t', 'one'], /--t: 'one' is not a number/],
  [[...FLATTEN, '--t', '1,5'], /--t: '1,5' is not a number/],
  [[...FLATTEN, '--t', ''], /--t/],
  [[...FLATTEN, '--t', '0'], /--t: must be a number above 0/],
  [[...FLATTEN, '--t', '-1'], /--t: must be a number above 0/],
  [[...FLATTEN, '--t', 'nan'], /--t: must be a number above 0/],
  [[...FLATTEN, '--t', 'inf'], /--t: must be a number above 0/],
  [[...FLATTEN, '--t', '1e999'], /--t: must be a number above 0/],
  [[...FLATTEN, '--memory', '3X'], /--memory: '3X' is not a number above 0, or auto/],
  [[...FLATTEN, '--memory', 'G'], /--memory: 'G' is not a number/],
  [[...FLATTEN, '--memory', '-1G'], /--memory: must be a number above 0, or auto, not -1G/],
  [[...FLATTEN, '--memory', '0'], /--memory: must be a number above 0/],
  [[...FLATTEN, '--t', '3G'], /--t: '3G' is not a number/],
  [[...FLATTEN, '--report', 'out.obj'], /--report: is the same file as --output/],
  [[...FLATTEN, '--report', './sub/../out.obj'], /--report: is the same file as --output/],
  [[...FLATTEN, '--report', './in.obj'], /--report: would replace the input/],
  [['flatten', 'in.obj', '-o', '-', '--report', '-'], /--report: is the same file as --output/],
  [
    [...FLATTEN, '--bounds', 'b', '--report', './b'],
    /--report: would replace the file of --bounds/,
  ],
  [
    ['flatten', 'in.obj', '-o', 'b', '--bounds', 'b'],
    /--output: would replace the file of --bounds/,
  ],
  [
    ['flatten', '-', '-o', 'o.obj', '--bounds', '-'],
    /--bounds: standard input is the mesh already/,
  ],
  [[...FLATTEN, '--pins', 'p', '--report', './p'], /--report: would replace the file of --pins/],
  [['flatten', '-', '-o', 'o.obj', '--pins', '-'], /--pins: standard input is the mesh already/],
  [
    [...FLATTEN, '--bounds', '-', '--pins', '-'],
    /--pins: standard input is the file of --bounds already/,
  ],
  [['unwrap', 'in.obj', '-o', 'p.obj', '--pins', 'p.obj'], /would replace the file of --pins/],
  [['unwrap', '-', '-o', 'o.obj', '--pins', '-'], /--pins: standard input is the mesh already/],
  [
    ['unwrap', 'in.obj', '-o', 'o.obj', '--keep', 'file=-', '--pins', '-'],
    /--pins: standard input is the file of --keep already/,
  ],
  [
    ['flatten', 'in.obj', '-o', 'out.off'],
    /cannot write \.off files\. Use \.obj, \.ply, \.glb or \.gltf/,
  ],
  [['unwrap', 'in.obj', '-o', 'o.obj', '--udim'], /--udim: needs a numeric --texel-density/],
  [['pack', 'in.obj', '-o', 'o.obj', '--udim'], /--udim: needs a numeric --texel-density/],
  [
    ['pack', 'in.obj', '-o', 'o.obj', '--layout', 'in.obj.gif'],
    /--layout: use a name that ends in/,
  ],
  [['pack', 'in.obj', '-o', 'o.obj', '--report', './in.obj'], /--report: would replace the input/],
  [
    ['pack', 'in.obj', '-o', 'o.obj', '--report', 'r.svg', '--layout', './r.svg'],
    /--layout: is the same file as --report/,
  ],
  [['sweep', 'in.obj', '--csv', './in.obj'], /--csv: would replace the input/],
  [['inspect'], /IN/],
  [['sample'], /NAME/],
  [['sample', 'teapot', '-o', 'out.obj'], /no sample 'teapot'\. Use hemisphere/],
  [['sample', 'head'], /--output/],
  [['sample', 'head', '-o', 'out.obj', '--detail', '0.5'], /--detail: must be a number from 1/],
  [['sample', 'head', '-o', 'out.obj', '--detail', '1e9'], /--detail: must be a number from 1/],
];

for (const [args, sentence] of WRONG)
  test(`"abflat ${args.join(' ')}" is refused with exit code 2`, async (t) => {
    const at = tempFolder(t);
    writeFileSync(at('in.obj'), TRIANGLE);
    const run = await runAbflat(args, { cwd: at() });
    assert.equal(run.code, 2, run.stderr);
    assert.match(run.stderr, sentence);
    assert.match(run.stderr, /^abflat: [^\n]+\nRun 'abflat.* --help' for usage\.\n/);
    assert.equal(run.stdout, '');
    assert.equal(existsSync(at('out.obj')), false);
    assert.equal(readFileSync(at('in.obj'), 'utf8'), TRIANGLE);
  });

test('help goes to standard output and tells every exit code', async () => {
  for (const args of [['--help'], ['-h'], ['flatten', '--help']]) {
    const run = await runAbflat(args);
    assert.equal(run.code, 0);
    assert.equal(run.stderr, '');
    for (const { code, text } of SCHEMA.exitCodes)
      assert.ok(run.stdout.includes(`${code}  ${text}`));
  }
});

for (const command of ['flatten', 'unwrap', 'pack'])
  test(`help of ${command} tells its options, their meaning and defaults`, async () => {
    const { stdout } = await runAbflat([command, '--help']);
    const words = stdout.replaceAll(/\s+/g, ' ');
    for (const { name, type, text, default: value } of SCHEMA[`${command}Options`]) {
      assert.ok(words.includes(text));
      const shown = { choice: ` WORD=${value}`, boolean: '' }[type] ?? ` NUMBER=${value}`;
      assert.match(
        words,
        new RegExp(`--${value === true ? 'no-' : ''}${kebabCase(name)}${shown}\\b`),
      );
    }
  });

test('help of sample lists the samples', async () => {
  const { stdout } = await runAbflat(['sample', '--help']);
  for (const name of ['hemisphere', 'wavy-strip', 'head', 'alpha-band', 'three-balls'])
    assert.match(stdout, new RegExp(`^  ${name} `, 'm'));
});

test('the version is that of the build', async () => {
  const header = readFileSync(join(ROOT, 'core/include/abflat/version.h'), 'utf8');
  const version = header.match(/ABFLAT_VERSION "(\S+)"/)[1];
  assert.equal((await runAbflat(['--version'])).stdout, `abflat ${version}\n`);
});

test('names that begin with a dash can be given after --', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('-in.obj'), TRIANGLE);
  const run = await runAbflat(['flatten', '-o', 'out.obj', '--', '-in.obj'], { cwd: at() });
  assert.equal(run.code, 0, run.stderr);
});
