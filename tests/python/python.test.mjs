// Runs each file of tests/python/cases with unittest, on the package as it is built.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { contentsOf } from '../../scripts/lib/licenses.mjs';
import { BUILD, PYTHON_DIST, ROOT } from '../../scripts/lib/paths.mjs';
import { findPython } from '../../scripts/lib/requirements.mjs';
import { PROGRAM } from '../support/run-abflat.mjs';

const CASES = join(ROOT, 'tests/python/cases');
const EXAMPLE = join(ROOT, 'examples/python/unwrap.py');
const python = process.env.PYTHON ?? findPython();

function run(args, { cwd = CASES, env = {} } = {}) {
  const { status, stdout, stderr } = spawnSync(python, args, {
    cwd,
    encoding: 'utf8',
    env: {
      ...process.env,
      PYTHONPATH: PYTHON_DIST,
      PYTHONDONTWRITEBYTECODE: '1',
      ABFLAT_BIN: PROGRAM,
      ...env,
    },
  });
  assert.equal(status, 0, `${stdout}\n${stderr}`);
  return `${stdout}${stderr}`;
}

function inFolder(work) {
  const folder = mkdtempSync(join(tmpdir(), 'abflat-python-'));
  try {
    return work(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

for (const file of readdirSync(CASES).filter((name) => /^test_.*\.py$/.test(name)))
  test(file, () => {
    const output = run(['-W', 'error', '-m', 'unittest', file.replace('.py', '')]);
    assert.match(output, /^Ran [1-9]\d* tests? in /m, 'it has tests');
  });

test('the example', () =>
  inFolder((folder) => {
    const obj = join(folder, 'out.obj');
    assert.match(run([EXAMPLE, obj]), /^\d+ charts, valid\n$/);
    assert.match(readFileSync(obj, 'utf8'), /^vt .*\n[\s\S]*^f \d+\/\d+ /m);
  }));

test('what is installed can be imported, and comes with the licences of all that is in it', () =>
  inFolder((folder) => {
    const { status, stderr } = spawnSync(
      'cmake',
      ['--install', join(BUILD, 'native'), '--prefix', folder, '--component', 'python'],
      { encoding: 'utf8' },
    );
    assert.equal(status, 0, stderr);
    assert.deepEqual(readdirSync(folder), ['abflat'], 'nothing but the package');
    const code = 'import abflat.xatlas; print(abflat.__file__, abflat.__version__)';
    const printed = run(['-c', code], { cwd: folder, env: { PYTHONPATH: folder } });
    assert.ok(printed.startsWith(folder), printed);
    const licenses = readdirSync(join(folder, 'abflat/licenses'));
    const parts = contentsOf('python').map((name) => `${name}.txt`);
    assert.deepEqual(licenses.sort(), ['LICENSE', ...parts].sort());
  }));
