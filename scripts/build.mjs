#!/usr/bin/env node
// Builds the command line program, the WebAssembly package, the page and the Python package, each
// only if something changed.
// Usage: build.mjs [native] [wasm] [web] [python]   (default: the first three; web includes wasm)

import { cpSync, existsSync, rmSync } from 'node:fs';
import { join, relative } from 'node:path';
import { pathToFileURL } from 'node:url';
import { cmakeBuild, emscriptenEnv } from './lib/cmake.mjs';
import { writeLicenses } from './lib/licenses.mjs';
import { BUILD, NATIVE_PROGRAM, PYTHON_DIST, ROOT, WASM_DIST, WEB_DIST } from './lib/paths.mjs';
import { findClang, findPython } from './lib/requirements.mjs';
import { Failure, mustRun, runMain } from './lib/run.mjs';
import { stamp, unlessFresh } from './lib/stamp.mjs';
import { setup } from './setup.mjs';

const COMMON_INPUTS = [
  'package-lock.json',
  'tsconfig.base.json',
  'scripts/licenses',
  'scripts/lib/licenses.mjs',
];
/** Folders below build/ and the settings in which they differ. */
const WASM_BUILDS = { wasm: { ABFLAT_THREADS: 'OFF' }, 'wasm-threads': { ABFLAT_THREADS: 'ON' } };
/** Runs with and without isolation: good enough to start with. */
const FIRST_BUILD = { folder: 'wasm', name: 'simd' };
const WASM_MODULES = Object.keys(WASM_BUILDS).flatMap((folder) => {
  const names =
    folder === 'wasm-threads' ? ['abflat-threads'] : ['abflat', 'abflat-pack', 'abflat-bake'];
  return names.flatMap((name) => ['mjs', 'wasm'].map((type) => `build/${folder}/${name}.${type}`));
});

const FIRST_PAGE = join(BUILD, 'first-page');

/** The targets that the core and command line tests run. */
export const TESTED = ['abflat', 'abflat_core_tests', 'abflat_replay'];

/** Without `tests`, Catch2 is not required, which only the tests need. */
export async function buildNative({ tests = false } = {}) {
  await cmakeBuild('native', {
    settings: tests ? { ABFLAT_TESTS: 'ON' } : {},
    first: { ABFLAT_TESTS: 'OFF' },
    targets: tests ? TESTED : ['abflat'],
  });
  writeLicenses(join(BUILD, 'native'), 'native');
  return NATIVE_PROGRAM;
}

/** The Python package beside the program, with the same library. */
export async function buildPython() {
  await cmakeBuild('native', {
    settings: { ABFLAT_PYTHON: 'ON', Python_EXECUTABLE: findPython() },
    first: { ABFLAT_TESTS: 'OFF' },
    targets: ['abflat_python'],
  });
  writeLicenses(join(PYTHON_DIST, 'abflat'), 'python');
  return PYTHON_DIST;
}

/**
 * The same plus the fuzzers, built by clang with sanitizers and the counters that libFuzzer reads.
 */
export async function buildSanitized() {
  await cmakeBuild('sanitize', {
    settings: { ABFLAT_SANITIZE: 'ON', ABFLAT_FUZZ: 'ON', CMAKE_CXX_COMPILER: findClang() },
    targets: [...TESTED, 'abflat_fuzzers'],
  });
}

function compileWasm(folder) {
  const settings = WASM_BUILDS[folder];
  return cmakeBuild(folder, { wrapper: ['emcmake'], settings, env: emscriptenEnv() });
}

/** Whether every module has been built once, now or earlier. */
export const hasAllWasm = () => WASM_MODULES.every((path) => existsSync(join(ROOT, path)));

/**
 * Builds the page with one module standing in for all, in a folder of its own that later builds
 * leave alone.
 */
export async function buildFirstPage() {
  await compileWasm(FIRST_BUILD.folder);
  // These stamps are for a complete build, which this is not.
  for (const step of ['wasm-package', 'web']) stamp(step).clear();
  await npmBuild('wasm', ['--only', FIRST_BUILD.name]);
  writeLicenses(WASM_DIST, 'wasm');
  await npmBuild('web', ['--mode', 'first']);
  writeLicenses(WEB_DIST, 'web');
  rmSync(FIRST_PAGE, { recursive: true, force: true });
  cpSync(WEB_DIST, FIRST_PAGE, { recursive: true });
  return FIRST_PAGE;
}

export async function buildWasm() {
  // All at once: the linker of each uses one core.
  const builds = await Promise.allSettled(Object.keys(WASM_BUILDS).map(compileWasm));
  const failed = builds.find(({ status }) => status === 'rejected');
  if (failed) throw failed.reason;
  await unlessFresh(
    'wasm-package',
    [...COMMON_INPUTS, 'wasm', ...WASM_MODULES],
    [WASM_DIST],
    async () => {
      await npmBuild('wasm');
      writeLicenses(WASM_DIST, 'wasm');
    },
  );
  return WASM_DIST;
}

/** Requires buildWasm to have run before. */
export async function buildWeb() {
  const inputs = [
    ...COMMON_INPUTS,
    'web',
    'wasm/package.json',
    'wasm/build.mjs',
    'wasm/modules.mjs',
    'wasm/function-order.mjs',
    'wasm/module-code.mjs',
    'wasm/src',
    ...WASM_MODULES,
  ];
  await unlessFresh('web', inputs, [join(WEB_DIST, 'index.html')], async () => {
    await npmBuild('web');
    writeLicenses(WEB_DIST, 'web');
  });
  return WEB_DIST;
}

async function npmBuild(workspace, args = []) {
  await mustRun('npm', ['run', '--silent', 'build', '--workspace', workspace, '--', ...args]);
}

const STEPS = {
  native: [buildNative],
  wasm: [buildWasm],
  web: [buildWasm, buildWeb],
  python: [buildPython],
};
/** What is built if nothing is named. */
const USUAL = ['native', 'wasm', 'web'];

async function main() {
  const asked = process.argv.slice(2);
  const unknown = asked.find((name) => !STEPS[name]);
  if (unknown)
    throw new Failure(`Unknown target "${unknown}"; known are: ${Object.keys(STEPS).join(', ')}.`);
  await setup(asked.includes('python') ? ['build', 'python'] : ['build']);
  const steps = new Set((asked.length > 0 ? asked : USUAL).flatMap((name) => STEPS[name]));
  for (const step of steps) console.log(`built ${relative(ROOT, await step())}`);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) await runMain(main);
