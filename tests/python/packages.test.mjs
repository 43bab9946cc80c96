// The package as pip builds and installs it, from the checkout and from a source distribution.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { contentsOf } from '../../scripts/lib/licenses.mjs';
import { BUILD, ROOT } from '../../scripts/lib/paths.mjs';
import { findPython } from '../../scripts/lib/requirements.mjs';

const PACKAGE = join(ROOT, 'native/python');
const EXAMPLE = join(ROOT, 'examples/python/unwrap.py');
const python = process.env.PYTHON ?? findPython();
const folder = mkdtempSync(join(tmpdir(), 'abflat-packages-'));
after(() => rmSync(folder, { recursive: true }));

function run(program, args, { cwd = folder, env = {} } = {}) {
  const { status, stdout, stderr, error } = spawnSync(program, args, {
    cwd,
    encoding: 'utf8',
    env: { ...process.env, PYTHONPATH: '', PIP_NO_INDEX: '1', ...env },
  });
  assert.equal(status, 0, `${program} ${args.join(' ')}\n${error ?? ''}${stdout}\n${stderr}`);
  return stdout;
}

/** A fresh environment with the system's NumPy, and its Python. */
function environment(name) {
  const path = join(folder, name);
  run(python, ['-m', 'venv', '--system-site-packages', path]);
  return join(path, 'bin/python');
}

/** What pip needs to build with what is installed, without a network. */
const OFFLINE = ['--no-build-isolation', '--no-deps'];
/** The program's folder of CMake has the library already. */
const SHARED = { env: { ABFLAT_BUILD: join(BUILD, 'native') } };

function checkInstalled(interpreter) {
  const told = run(interpreter, ['-c', 'import abflat, abflat.xatlas; print(abflat.__file__)']);
  assert.ok(told.startsWith(folder), told);
  const obj = join(folder, 'out.obj');
  assert.match(run(interpreter, [EXAMPLE, obj]), /^\d+ charts, valid\n$/);
}

test('a wheel: what is in it, and that it works where it is installed', () => {
  run(python, ['-m', 'pip', 'wheel', ...OFFLINE, '-w', 'wheels', PACKAGE], SHARED);
  const [wheel, ...others] = readdirSync(join(folder, 'wheels'));
  assert.match(wheel, /^abflat-\d+\.\d+\.\d+-cp3\d+-cp3\d+-.*\.whl$/);
  assert.deepEqual(others, []);
  const listed = run(python, ['-m', 'zipfile', '-l', join('wheels', wheel)]);
  const files = listed.split('\n').flatMap((line) => /^(abflat\S*)/.exec(line)?.[1] ?? []);
  const parts = contentsOf('python').map((name) => `abflat/licenses/${name}.txt`);
  for (const name of ['abflat/__init__.py', 'abflat/py.typed', 'abflat/_abflat.pyi', ...parts])
    assert.ok(files.includes(name), name);
  assert.equal(files.filter((name) => name.endsWith('.so')).length, 1);
  const interpreter = environment('from-wheel');
  run(interpreter, ['-m', 'pip', 'install', '--no-deps', join('wheels', wheel)]);
  checkInstalled(interpreter);
});

test('pip installs the checkout', () => {
  const interpreter = environment('from-checkout');
  run(interpreter, ['-m', 'pip', 'install', ...OFFLINE, PACKAGE], SHARED);
  checkInstalled(interpreter);
});

test('a source distribution has all that CMake reads', () => {
  const code = `import setuptools.build_meta as b; print(b.build_sdist(${JSON.stringify(folder)}))`;
  const name = run(python, ['-c', code], { cwd: PACKAGE }).trim().split('\n').at(-1);
  run('tar', ['-xzf', name]);
  const source = join(folder, name.replace('.tar.gz', ''), 'source');
  const settings = ['-DABFLAT_PYTHON=ON', '-DABFLAT_PROGRAM=OFF', '-DABFLAT_TESTS=OFF'];
  const configured = ['-G', 'Ninja', '-S', source, '-B', 'configured', ...settings];
  run('cmake', [...configured, `-DPython_EXECUTABLE=${python}`]);
  // What would be built has its sources.
  run('cmake', ['--build', 'configured', '--target', 'abflat_python', '--', '-n']);
});
