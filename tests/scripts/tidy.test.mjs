// clang-tidy reads sources in batches, and finds the same problems as in each source alone.

import assert from 'node:assert/strict';
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { batches, ownNames } from '../../scripts/lib/batches.mjs';
import { includeScanner } from '../../scripts/lib/includes.mjs';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { which } from '../../scripts/lib/run.mjs';
import { checkBatch, sourcesOf } from '../../scripts/lib/tidy.mjs';

const NEEDS_TIDY = { skip: which('clang-tidy') ? false : 'there is no clang-tidy' };

let folder;
before(() => {
  folder = mkdtempSync(join(tmpdir(), 'abflat-tidy-'));
  cpSync(join(ROOT, '.clang-tidy'), join(folder, '.clang-tidy'));
});
after(() => rmSync(folder, { recursive: true }));

function write(path, text) {
  const full = join(folder, path);
  mkdirSync(dirname(full), { recursive: true });
  writeFileSync(full, text);
  return full;
}

const source = (name, text, headers = []) => ({
  file: write(`core/src/${name}`, text),
  text,
  headers,
  flags: `c++ -std=c++17 -I${folder}/core/src`,
  directory: folder,
});

const inUnnamed = (text) => `namespace abflat {\nnamespace {\n${text}\n}  // namespace\n}\n`;

const names = (list) => list.map((batch) => batch.map(({ file }) => file.split('/').at(-1)));

test('names that a source declares for itself', () => {
  const text = inUnnamed(`struct Stage {
  int inner;
};
enum class Side { Left };
using Row = int;
constexpr double kMargin = 1;
int kTable[3] = {1, 2, 3};
template <class T> class Panel {};
std::vector<int> sorted(int a) {
  int local = a;
  return {local};
}`);
  const expected = ['Stage', 'Side', 'Row', 'kMargin', 'kTable', 'Panel', 'sorted'];
  assert.deepEqual([...ownNames(text)], expected);
  assert.deepEqual([...ownNames('namespace abflat {\nint shown() { return 1; }\n}\n')], []);
});

test('a batch has the flags of all its sources, and no name twice', () => {
  const a = source('a.cpp', inUnnamed('int helper() { return 1; }'));
  const b = source('b.cpp', inUnnamed('int helper() { return 2; }'));
  const c = source('c.cpp', 'int c(int x) { return helper(x); }\n');
  const d = source('d.cpp', 'int d() { return 1; }\n', ['int helper(int x);\n']);
  const e = source('e.cpp', 'int e() { return 1; }\n');
  const f = { ...source('f.cpp', 'int f() { return 1; }\n'), flags: 'c++ -O3' };
  assert.deepEqual(names(batches([a, b, c, d, e, f], 9)), [
    ['a.cpp', 'e.cpp'],
    ['b.cpp'],
    ['c.cpp', 'd.cpp'],
    ['f.cpp'],
  ]);
  assert.deepEqual(names(batches([c, d, e], 2)), [['c.cpp', 'd.cpp'], ['e.cpp']]);
  // These are compiled as one.
  const together = [a, c, d].map((each) => ({ ...each, unit: 'unity.cxx' }));
  assert.deepEqual(names(batches([...together, b, e], 4)), [
    ['a.cpp', 'c.cpp', 'd.cpp', 'e.cpp'],
    ['b.cpp'],
  ]);
});

test('a source is made of the headers that it includes, directly or not', () => {
  const root = join(folder, 'core/src');
  const filesOf = includeScanner([root]);
  const deep = write('core/src/deep.h', '');
  const near = write('core/src/part/near.h', '#include "deep.h"\n#include <vector>\n');
  const { file } = source('part/source.cpp', '#include "near.h"\n#  include "deep.h"\n');
  write('core/src/other.h', '');
  assert.deepEqual(filesOf(file), [deep, near, file]);
});

test('faults in any source of a batch and in its headers are found', NEEDS_TIDY, async () => {
  write('core/src/shared.h', '#pragma once\ninline int* nothing() { return 0; }\n');
  const clean = source('clean.cpp', '#include "shared.h"\nint one() { return 1; }\n');
  const named = source('named.cpp', '#include "shared.h"\nint Badly_Named() { return 1; }\n');
  const analysed = source(
    'analysed.cpp',
    'int through(bool is) {\n  int* p = nullptr;\n  if (is) return 1;\n  return *p;\n}\n',
  );
  const { clean: found, output } = await checkBatch([clean, named, analysed], join(folder, 'b'), {
    root: folder,
  });
  assert.deepEqual(found, []);
  assert.match(output, /shared\.h:2.*modernize-use-nullptr/);
  assert.match(output, /named\.cpp:2.*readability-identifier-naming/);
  assert.match(output, /analysed\.cpp:4.*clang-analyzer-core\.NullDereference/);
});

test('sources that cannot be read together are read alone', NEEDS_TIDY, async () => {
  const one = source('one.cpp', 'static int twice() { return 1; }\nint a() { return twice(); }\n');
  const two = source('two.cpp', 'static int twice() { return 2; }\nint b() { return twice(); }\n');
  const bad = source('bad.cpp', 'int* c() { return 0; }\n');
  const owner = source(
    'owner.cpp',
    'static int side() { return 1; }\nint d() { return side(); }\n',
  );
  const shadow = source('shadow.cpp', 'int e() {\n  int side = 1;\n  return side;\n}\n');
  const strict = [owner, shadow].map((each) => ({
    ...each,
    flags: `${each.flags} -Wshadow -Werror`,
  }));
  assert.deepEqual((await checkBatch(strict, join(folder, 'd'), { root: folder })).clean, strict);
  const { clean, output } = await checkBatch([one, two, bad], join(folder, 'c'), { root: folder });
  assert.deepEqual(names([clean]), [['one.cpp', 'two.cpp']]);
  assert.match(output, /bad\.cpp:1.*modernize-use-nullptr/);
  assert.doesNotMatch(output, /redefinition/);
});

test('sources of a folder that are compiled as one are found one by one', () => {
  const one = write('core/src/one.cpp', '');
  const two = write('core/src/two.cpp', '');
  const text = `/* generated by CMake */\n\n#include "${one}"\n\n#include "${two}"\n`;
  const together = write('build/CMakeFiles/abflat.dir/Unity/unity_core_src_cxx.cxx', text);
  assert.deepEqual(sourcesOf(together), [one, two]);
  assert.deepEqual(sourcesOf(one), [one]);
});
