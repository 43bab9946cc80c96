// Projects that use the library, in each way that the documents name. The library is built once, as
// a folder of another project, and installed from there.

import assert from 'node:assert/strict';
import { cpSync, mkdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { which } from '../../scripts/lib/run.mjs';
import { exampleIn } from '../support/documents.mjs';
import { C_EXAMPLE, consumers, EXAMPLE, mustRun } from './support/consumers.mjs';

const compiler = process.env.CXX ?? ['c++', 'g++', 'clang++'].map(which).find(Boolean);

const HEADERS = join(ROOT, 'core/include');
const WARNINGS = '-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Werror'.split(
  ' ',
);

let made;
const at = (...names) => made.at(...names);
const configure = (...args) => made.configure(...args);
const build = (name) => made.build(name);

/** A project around the example's source, with these lines of the documents. */
function project(name, lines) {
  mkdirSync(at(name), { recursive: true });
  cpSync(join(EXAMPLE, 'main.cpp'), at(name, 'my_program.cpp'));
  const text = ['cmake_minimum_required(VERSION 3.20)', `project(${name} LANGUAGES CXX)`]
    .concat('add_executable(my_program my_program.cpp)', lines)
    .join('\n');
  writeFileSync(at(name, 'CMakeLists.txt'), text);
}

/** How a source of a project is compiled. */
function commandFor(name, source) {
  const commands = JSON.parse(readFileSync(at(name, 'build/compile_commands.json'), 'utf8'));
  return commands.find(({ file }) => file.endsWith(source)).command;
}

function unwraps(program) {
  const obj = at('out.obj');
  rmSync(obj, { force: true });
  const stdout = mustRun(program, [obj]);
  assert.match(stdout, /^abflat \d+\.\d+\.\d+: 3 charts, valid\n$/);
  assert.match(readFileSync(obj, 'utf8'), /^vt /m);
}

const CACHE = { CMAKE_CXX_COMPILER: compiler, CMAKE_BUILD_TYPE: 'Release' };
const settings = Object.entries(CACHE).map(([key, value]) => `-D${key}=${value}`);

before(() => {
  made = consumers();
  made.copySources('folder/abflat');
  project('folder', exampleIn('docs/cpp.md', 'add_subdirectory'));
  configure('folder', ...settings, '-DABFLAT_INSTALL=ON', '-DCMAKE_EXPORT_COMPILE_COMMANDS=ON');
  build('folder');
  mustRun('cmake', ['--install', at('folder/build'), '--prefix', at('prefix')]);
});

after(() => made.remove());

test('as a folder of another project, without anything but the library', () => {
  unwraps(at('folder/build/my_program'));
  const cache = readFileSync(at('folder/build/CMakeCache.txt'), 'utf8');
  assert.doesNotMatch(cache, /(Draco|nlohmann|CLI11|Catch2|zlib)_(ROOT|INCLUDE|LIBRARY)/);
  const own = commandFor('folder', 'my_program.cpp');
  assert.doesNotMatch(own, / -W| -f(?!PI)|ABFLAT_|eigen/i, 'none of the flags of the library');
});

test('with FetchContent', () => {
  project('fetched', exampleIn('docs/cpp.md', 'FetchContent'));
  const source = `-DFETCHCONTENT_SOURCE_DIR_ABFLAT=${at('folder/abflat')}`;
  configure('fetched', ...settings, source, '-DCMAKE_EXPORT_COMPILE_COMMANDS=ON');
  const own = commandFor('fetched', 'my_program.cpp');
  assert.match(own, /-I\S*abflat\/core\/include/);
  assert.ok(commandFor('fetched', 'mesh_cxx.cxx'), 'the library is built with it');
});

test('installed, with find_package', () => {
  project('found', exampleIn('docs/cpp.md', 'find_package'));
  configure('found', ...settings, `-DCMAKE_PREFIX_PATH=${at('prefix')}`);
  build('found');
  unwraps(at('found/build/my_program'));
});

test('the example, with every version of the language and all warnings', () => {
  cpSync(EXAMPLE, at('example'), { recursive: true });
  const warnings = '-Wall -Wextra -Wpedantic -Wconversion -Werror';
  for (const standard of [17, 20, 23]) {
    configure(
      'example',
      ...settings,
      `-DCMAKE_PREFIX_PATH=${at('prefix')}`,
      `-DCMAKE_CXX_STANDARD=${standard}`,
      `-DCMAKE_CXX_FLAGS=${warnings}`,
    );
    build('example');
    unwraps(at('example/build/unwrap_example'));
  }
});

test('the example in C, with all warnings', () => {
  cpSync(C_EXAMPLE, at('c'), { recursive: true });
  const flags = '-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror';
  configure('c', ...settings, `-DCMAKE_PREFIX_PATH=${at('prefix')}`, `-DCMAKE_C_FLAGS=${flags}`);
  build('c');
  const stdout = mustRun(at('c/build/unwrap_example'), []);
  assert.match(
    stdout,
    /^abflat \d+\.\d+\.\d+: valid\n(corner [0-7]: 0\.\d+ 0\.\d+\n){10,}packed again: valid\n$/,
  );
});

test('the lines of C in the document', () => {
  const code = `#include <stdio.h>
#include "abflat/abflat.h"
const double* f(const float* positions, size_t vertex_count, const uint32_t* triangles, size_t triangle_count);
const double* f(const float* positions, size_t vertex_count, const uint32_t* triangles, size_t triangle_count) {
${exampleIn('docs/cpp.md', 'c')}
return vertices && corners ? uv : NULL;
}
`;
  const flags = ['-std=c99', '-Wall', '-Wextra', '-Werror', '-fsyntax-only', '-x', 'c', '-'];
  mustRun(compiler, ['-I', at('prefix/include'), ...flags], { input: code });
});

test('the view of arrays in the document', () => {
  const code = `#include <vector>\n#include "abflat/unwrap.h"\nnamespace {\n${exampleIn('docs/cpp.md', 'view')}}
int main() { return unwrapped(std::vector<Vertex>(3), {0, 1, 2}).ok() ? 1 : 0; }
`;
  mkdirSync(at('view'));
  const libraries = ['-I', at('prefix/include'), '-x', 'c++', '-', '-x', 'none'].concat(
    at('prefix/lib/libabflat.a'),
    '-pthread',
  );
  mustRun(compiler, [...WARNINGS, '-std=c++17', ...libraries, '-o', at('view/program')], {
    input: code,
  });
  mustRun(at('view/program'), []);
});

test('another compiler links what one has built', {
  skip: !which('clang++') && 'there is no clang++',
}, () => {
  mkdirSync(at('clang'));
  const libraries = ['-I', at('prefix/include'), at('prefix/lib/libabflat.a'), '-pthread'];
  mustRun('clang++', [
    ...WARNINGS,
    '-std=c++17',
    join(EXAMPLE, 'main.cpp'),
    ...libraries,
    '-o',
    at('clang/program'),
  ]);
  unwraps(at('clang/program'));
});

test('installed, with pkg-config, and in a folder that was moved', {
  skip: !which('pkg-config') && 'there is no pkg-config',
}, () => {
  mkdirSync(at('moved'));
  symlinkSync(at('prefix'), at('moved/prefix'));
  cpSync(join(EXAMPLE, 'main.cpp'), at('moved/my_program.cpp'));
  const [line] = exampleIn('docs/cpp.md', 'pkg-config').split('\n');
  const env = { ...process.env, PKG_CONFIG_PATH: at('moved/prefix/lib/pkgconfig') };
  mustRun('sh', ['-c', line.replace(/^c\+\+/, compiler)], { cwd: at('moved'), env });
  unwraps(at('moved/my_program'));
});

const headersIn = (folder) =>
  mustRun('find', ['abflat', '-name', '*.h'], { cwd: folder }).trim().split('\n');

test('headers of parts that are not built are not installed', () => {
  const installed = headersIn(at('prefix/include'));
  const parts = ['draw.h', 'gltf.h', 'gltf_look.h', 'appearance.h'].map((name) => `abflat/${name}`);
  assert.deepEqual(headersIn(HEADERS).sort(), installed.concat(parts).sort());
});

/** Headers that are included in this order, compiled with all warnings. */
function compileHeaders(names, command, standard) {
  const input = names.map((name) => `#include "${name}"\n`).join('');
  const options = [...WARNINGS, `-std=c++${standard}`, '-fsyntax-only', '-I', HEADERS];
  mustRun(command, [...options, '-x', 'c++', '-'], { input });
}

test('every public header compiles alone', () => {
  for (const name of headersIn(HEADERS)) compileHeaders([name], compiler, 17);
});

test('all public headers compile without warnings, as every version of the language', () => {
  const compilers = ['g++', 'clang++'].filter(which);
  for (const command of compilers)
    for (const standard of [17, 20, '2b']) compileHeaders(headersIn(HEADERS), command, standard);
});

test('the library fits into a shared module, which exports nothing of it', () => {
  mkdirSync(at('module'));
  writeFileSync(
    at('module/module.cpp'),
    `#include "abflat/unwrap.h"
extern "C" bool unwraps() { return abflat::unwrap({}, {}).ok(); }
`,
  );
  mustRun(compiler, [
    '-std=c++17',
    '-shared',
    '-fPIC',
    '-Wl,--no-undefined',
    '-I',
    at('prefix/include'),
    at('module/module.cpp'),
    at('prefix/lib/libabflat.a'),
    '-pthread',
    '-o',
    at('module/module.so'),
  ]);
  assert.doesNotMatch(
    mustRun('nm', ['-D', '--defined-only', '-C', at('module/module.so')]),
    / T abflat/,
  );
});
