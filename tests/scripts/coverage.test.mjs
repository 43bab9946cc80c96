// Lines and branches that programs execute are counted, over several programs.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { percent, profileIn, readCoverage, sum } from '../../scripts/lib/coverage.mjs';
import { findClang } from '../../scripts/lib/requirements.mjs';
import { which } from '../../scripts/lib/run.mjs';

const clang = findClang();
const NEEDS_CLANG = {
  skip: clang && which('llvm-cov') ? false : 'there is no clang with llvm-cov',
};

let folder;
before(() => {
  folder = mkdtempSync(join(tmpdir(), 'abflat-coverage-'));
  mkdirSync(join(folder, 'core/src'), { recursive: true });
});
after(() => rmSync(folder, { recursive: true }));

function run(program, args, env = {}) {
  const { status, stderr } = spawnSync(program, args, {
    cwd: folder,
    encoding: 'utf8',
    env: { ...process.env, ...env },
  });
  assert.equal(status, 0, stderr);
}

test('two programs reach what neither reaches alone', NEEDS_CLANG, async () => {
  const sides = 'int side(int x) {\n  if (x > 0)\n    return 1;\n  return 2;\n}\n';
  writeFileSync(join(folder, 'core/src/side.cpp'), sides);
  writeFileSync(join(folder, 'core/src/never.cpp'), 'int never() {\n  return 1;\n}\n');
  writeFileSync(
    join(folder, 'main.cpp'),
    'int side(int);\nint main() { return side(SIDE) > 2; }\n',
  );
  const sources = ['core/src/side.cpp', 'core/src/never.cpp', 'main.cpp'];
  const flags = ['-fprofile-instr-generate', '-fcoverage-mapping'];
  for (const [name, x] of Object.entries({ up: 1, down: -1 }))
    run(clang, [...flags, `-DSIDE=${x}`, ...sources.map((file) => join(folder, file)), '-o', name]);
  const profiles = join(folder, 'profiles');
  const programs = ['up', 'down'].map((name) => join(folder, name));
  const env = { LLVM_PROFILE_FILE: profileIn(profiles) };

  await assert.rejects(readCoverage(profiles, programs, folder), /No program has written counts/);
  run(programs[0], [], env);
  const [never, side] = await readCoverage(profiles, programs, folder);
  assert.equal(never.file, 'core/src/never.cpp');
  assert.deepEqual([never.lines.covered, side.branches.covered, side.branches.count], [0, 1, 2]);
  run(programs[1], [], env);
  const both = await readCoverage(profiles, programs, folder);
  assert.equal(percent(both[1].lines), 100);
  assert.equal(percent(both[1].branches), 100);
  assert.equal(sum(both, 'lines').count, never.lines.count + side.lines.count);
  await assert.rejects(readCoverage(profiles, programs, tmpdir()), /No counts are of sources in/);
});

test('names of sources may be relative', NEEDS_CLANG, async () => {
  mkdirSync(join(folder, 'core/src/part'), { recursive: true });
  writeFileSync(join(folder, 'core/src/part/one.cpp'), 'int main() {\n  return 0;\n}\n');
  const flags = ['-fprofile-instr-generate', '-fcoverage-mapping', '-fcoverage-compilation-dir=.'];
  run(clang, [...flags, 'core/src/part/one.cpp', '-o', 'one']);
  const profiles = join(folder, 'relative');
  run(join(folder, 'one'), [], { LLVM_PROFILE_FILE: profileIn(profiles) });
  const files = await readCoverage(profiles, [join(folder, 'one')], folder);
  assert.deepEqual(
    files.map(({ file }) => file),
    ['core/src/part/one.cpp'],
  );
});
