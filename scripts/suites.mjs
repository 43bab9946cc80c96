// All test suites, one per line. A suite's name is its folder below tests/.

import { join } from 'node:path';
import { buildBench } from '../tests/bench/support/program.mjs';
import { buildNative, buildPython, buildSanitized, buildWasm, buildWeb, TESTED } from './build.mjs';
import { withBrowsers } from './lib/browsers.mjs';
import { CHECKED_BUILDS, checkJobs } from './lib/checks.mjs';
import { cmakeBuild } from './lib/cmake.mjs';
import { profileIn } from './lib/coverage.mjs';
import { BUILD } from './lib/paths.mjs';
import { missingTools, PLATFORMS } from './lib/platforms.mjs';
import { findChrome, findClang, findPython } from './lib/requirements.mjs';
import { catchJobs, fuzzJobs, NOT_QUALITY, nodeJobs } from './lib/suites.mjs';

/**
 * A finding ends the program in a way that cannot be mistaken for a documented exit code. The defaults
 * of the last two, 256 MB of freed memory and 30 callers of each allocation, would cost a third more.
 */
const SANITIZER_ENV = {
  ASAN_OPTIONS: [
    ...['abort_on_error=1', 'detect_leaks=1', 'strict_string_checks=1'],
    ...['quarantine_size_mb=64', 'malloc_context_size=10'],
  ].join(':'),
  UBSAN_OPTIONS: 'abort_on_error=1:print_stacktrace=1',
  ABFLAT_BIN: join(BUILD, 'sanitize/abflat'),
  ABFLAT_INSTRUMENTED: '1',
};
const WITHOUT = {
  title: (what) => what,
  purposes: ['build', 'test'],
  folder: 'native',
  env: {},
};
const EMULATED = { ...WITHOUT, purposes: [...WITHOUT.purposes, 'platforms'] };
const PYTHON = { ...WITHOUT, purposes: [...WITHOUT.purposes, 'python'] };
const CLUSTER = { ...PYTHON, purposes: [...PYTHON.purposes, 'cluster'] };
const SANITIZED = {
  title: (what) => `${what}, sanitizers`,
  purposes: ['build', 'test', 'fuzz'],
  folder: 'sanitize',
  env: SANITIZER_ENV,
  filter: NOT_QUALITY,
};

/** For all fuzzers together. */
const FUZZED_SECONDS = 40;

/** Where instrumented programs write their execution counts. */
export const PROFILES = join(BUILD, 'coverage/profiles');
const COVERED = {
  title: (what) => `${what}, coverage`,
  purposes: ['build', 'test', 'coverage'],
  folder: 'coverage',
  env: {
    ABFLAT_BIN: join(BUILD, 'coverage/abflat'),
    ABFLAT_INSTRUMENTED: '1',
    LLVM_PROFILE_FILE: profileIn(PROFILES),
  },
};

const program = () => buildNative({ tests: true });

const coveredProgram = () =>
  cmakeBuild('coverage', {
    settings: { ABFLAT_COVERAGE: 'ON' },
    first: { CMAKE_CXX_COMPILER: findClang() },
    targets: TESTED,
  });

/** Here each source is compiled alone, so that each has to include what it needs. */
const countingProgram = () =>
  cmakeBuild('steps', {
    settings: { ABFLAT_STEPS: 'ON', ABFLAT_FOLDER_BY_FOLDER: 'OFF' },
    targets: ['abflat_scaling'],
  });

/** The library for other platforms, as far as there is a compiler and something to run it. */
const otherPlatforms = async () => {
  for (const name of PLATFORMS.filter((platform) => missingTools(platform).length === 0))
    await cmakeBuild(name, { isPreset: true, targets: ['abflat_core_tests', 'abflat_layouts'] });
};

/**
 * Test files of tests/FOLDER for node, several at a time; `waits`, `repeats`: see runPool. `env` is
 * called once everything is built.
 */
function node(
  folder,
  needs,
  { kind = WITHOUT, what = 'node', waits = false, repeats = false, env = () => ({}) } = {},
) {
  return {
    name: folder,
    waits,
    repeats,
    title: `tests/${folder} (${kind.title(what)})`,
    purposes: kind.purposes,
    needs,
    jobs: (options) =>
      nodeJobs(folder, { ...kind.env, ...env() }, { ...options, kind: kind.folder }),
  };
}

/** Test files that use browsers one after the other. */
function browser(suite) {
  const serve = async () => {
    // Not before the packages are installed.
    const { serveBrowser } = await import('../web/scripts/browser.mjs');
    return serveBrowser({ antialias: false });
  };
  return { ...suite, jobs: (options) => withBrowsers(suite.jobs(options), serve) };
}

/** The test program of tests/core. */
function catch2(folder, needs, { kind = WITHOUT } = {}) {
  return {
    name: folder,
    title: `tests/${folder} (${kind.title('Catch2')})`,
    purposes: kind.purposes,
    needs,
    jobs: (options) =>
      catchJobs(join(BUILD, kind.folder, 'tests/abflat_core_tests'), kind.env, {
        ...options,
        filter: kind.filter,
      }),
  };
}

/** What `npm test` runs. */
export const SUITES = [
  catch2('core', [program]),
  node('native', [program]),
  node('faults', [program]),
  node('fuzz', [program], { what: 'random meshes' }),
  node('consumers', [], { what: 'projects that use the library', kind: WITHOUT }),
  node('python', [program, buildPython], {
    what: 'unittest',
    kind: PYTHON,
    env: () => ({ PYTHON: findPython() }),
  }),
  node('docs', [program, buildWasm, buildPython], {
    what: 'site and samples',
    kind: PYTHON,
    env: () => ({ PYTHON: findPython() }),
  }),
  node('bench', [program, buildBench]),
  node('wasm', [program, buildWasm]),
  browser(
    node('web', [program, buildWasm, buildWeb], {
      what: 'Chromium',
      waits: true,
      env: () => ({ CHROME_PATH: findChrome() }),
    }),
  ),
  // The bill of materials also names what the Python package contains.
  node('scripts', [], { kind: PYTHON }),
];

/** Starts schedulers, for which it installs packages. */
const CLUSTERS = node('cluster', [program, buildWasm, buildPython], {
  what: 'recipes for schedulers',
  kind: CLUSTER,
});

/** What only `npm run test:long` runs in addition, with the long tests of both. */
export const LONG_SUITES = [
  CLUSTERS,
  node('bundlers', [buildWasm]),
  node('scaling', [countingProgram], { what: 'steps' }),
  node('platforms', [program, otherPlatforms], { what: 'ARM, Windows', kind: EMULATED }),
];

/** What is run again with an instrumented program. */
export const SANITIZED_SUITES = [
  catch2('core', [buildSanitized], { kind: SANITIZED }),
  // The native build runs the same files.
  node('native', [buildSanitized], { kind: SANITIZED, repeats: true }),
  node('fuzz', [buildSanitized], { kind: SANITIZED, what: 'random meshes' }),
  {
    name: 'fuzzers',
    title: 'tests/fuzz (libFuzzer)',
    purposes: ['build', 'fuzz'],
    needs: [buildSanitized],
    jobs: () => fuzzJobs(FUZZED_SECONDS),
  },
];

/** What `npm run coverage` measures. */
export const COVERED_SUITES = [
  catch2('core', [coveredProgram], { kind: COVERED }),
  node('native', [coveredProgram], { kind: COVERED }),
  node('fuzz', [coveredProgram], { kind: COVERED, what: 'random meshes' }),
];

/** What `npm run lint` checks. */
const LINT = {
  name: 'lint',
  title: 'lint',
  purposes: ['build', 'lint', 'python'],
  needs: CHECKED_BUILDS,
  jobs: checkJobs,
};

const without = (...names) => SUITES.filter(({ name }) => !names.includes(name));

/** Names for groups of suites. */
export const GROUPS = {
  default: SUITES,
  node: without('core', 'web'),
  browser: SUITES.filter(({ name }) => name === 'web'),
  sanitize: SANITIZED_SUITES,
  long: [...SUITES, ...LONG_SUITES, LINT],
  lint: [LINT],
  ci: [...SANITIZED_SUITES, ...SUITES, CLUSTERS, LINT],
};
