// The library as a shared one, with its parts: what it exports, and projects that link it.

import assert from 'node:assert/strict';
import { cpSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { missingTools } from '../../scripts/lib/platforms.mjs';
import { which } from '../../scripts/lib/run.mjs';
import { WINE } from '../platforms/support/platform.mjs';
import { consumers, EXAMPLE, mustRun } from './support/consumers.mjs';

const HEADERS = join(ROOT, 'core/include/abflat');
/** Headers of parts that have libraries of their own for every platform but this one. */
const OF_PARTS = ['draw.h', 'gltf.h', 'gltf_look.h', 'appearance.h'];
const SHARED = ['-DBUILD_SHARED_LIBS=ON', '-DABFLAT_PROGRAM=OFF', '-DCMAKE_BUILD_TYPE=Release'];
const PARTS = ['-DABFLAT_DRAWING=ON', '-DABFLAT_GLTF=ON'];

let made;
before(() => {
  made = consumers();
});
after(() => made.remove());

/** Functions that headers declare but do not define; a name as often as it is overloaded. */
function declaredIn(headers) {
  const declaration =
    /^(ABFLAT_API )?(?!inline|template|typedef|using|constexpr|struct|enum)[A-Za-z][\w:<>*&, ]*?[ *&](\w+)\([^{};]*(?:\{\}[^{};]*)*\);/gm;
  const names = [];
  for (const header of headers)
    for (const [all, mark, name] of readFileSync(join(HEADERS, header), 'utf8').matchAll(
      declaration,
    )) {
      assert.ok(mark, `${header}: ABFLAT_API is missing in front of ${all}`);
      names.push(name);
    }
  assert.ok(names.length > 30);
  return names.sort();
}

const headers = readdirSync(HEADERS).filter((name) => name.endsWith('.h'));

function buildLibrary(name, ...more) {
  made.copySources(name);
  made.configure(name, ...SHARED, ...more);
  made.build(name);
  mustRun('cmake', ['--install', made.at(name, 'build'), '--prefix', made.at(`${name}-prefix`)]);
  return made.at(`${name}-prefix`);
}

test('exports the functions of the headers and nothing else, and can be linked', {
  skip: process.platform !== 'linux' && 'symbols are read as on Linux',
}, () => {
  const prefix = buildLibrary('library', ...PARTS);
  const library = join(prefix, 'lib/libabflat.so');
  const symbols = mustRun('nm', ['-D', '--defined-only', '-C', library]).trim().split('\n');
  const exported = symbols.map((line) => line.match(/^\w+ T (?:abflat::)?(\w+)/)?.[1] ?? line);
  assert.deepEqual(exported.sort(), declaredIn(headers));

  mkdirSync(made.at('parts'));
  cpSync(join(EXAMPLE, 'main.cpp'), made.at('parts/main.cpp'));
  writeFileSync(
    made.at('parts/parts.cpp'),
    `#include "abflat/draw.h"
#include "abflat/gltf.h"
int main() { return abflat::looksLikeGltf("{") && !abflat::svgFile("", {}, 1).empty() ? 0 : 1; }
`,
  );
  writeFileSync(
    made.at('parts/CMakeLists.txt'),
    `cmake_minimum_required(VERSION 3.20)
project(parts LANGUAGES CXX)
find_package(abflat 0.1 CONFIG REQUIRED COMPONENTS drawing gltf)
add_executable(example main.cpp)
target_link_libraries(example PRIVATE abflat::abflat)
add_executable(parts parts.cpp)
target_link_libraries(parts PRIVATE abflat::drawing abflat::gltf)
`,
  );
  made.configure('parts', `-DCMAKE_PREFIX_PATH=${prefix}`);
  made.build('parts');
  assert.match(mustRun(made.at('parts/build/example'), []), /valid\n$/);
  mustRun(made.at('parts/build/parts'), []);
});

const missing = [
  ...missingTools('windows'),
  ...['x86_64-w64-mingw32-objdump', 'c++filt'].filter((tool) => !which(tool)),
];

test('the same on Windows', {
  skip: missing.length > 0 && `there is no ${missing.join(' and no ')}`,
}, () => {
  const toolchain = `-DCMAKE_TOOLCHAIN_FILE=${join(ROOT, 'scripts/cmake/windows.cmake')}`;
  const prefix = buildLibrary('windows', toolchain);
  const library = join(prefix, 'bin/libabflat.dll');
  const [, table] = mustRun('x86_64-w64-mingw32-objdump', ['-p', library]).split(
    '[Ordinal/Name Pointer] Table',
  );
  const mangled = [...table.split('\n\n')[0].matchAll(/\] (\S+)$/gm)].map(([, name]) => name);
  const exported = mustRun('c++filt', [], { input: mangled.join('\n') })
    .trim()
    .split('\n');
  const names = exported.map((line) => line.match(/^(?:abflat::)?(\w+)/)[1]);
  assert.deepEqual(names.sort(), declaredIn(headers.filter((name) => !OF_PARTS.includes(name))));

  cpSync(EXAMPLE, made.at('windows-example'), { recursive: true });
  made.configure('windows-example', toolchain, `-Dabflat_DIR=${join(prefix, 'lib/cmake/abflat')}`);
  made.build('windows-example');
  cpSync(library, made.at('windows-example/build/libabflat.dll'));
  const program = made.at('windows-example/build/unwrap_example.exe');
  assert.match(mustRun('wine', [program], { env: { ...process.env, ...WINE } }), /valid\r?\n$/);
});
