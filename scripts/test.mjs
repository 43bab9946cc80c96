#!/usr/bin/env node
// Builds what the tests need and runs them.
// The last line is the sum: "N passed, N failed, N skipped".
// Usage: test.mjs [core] [node] [browser] [sanitize]   (default: core node browser)

import { join } from 'node:path';
import { buildBench } from '../tests/bench/support/meshes.mjs';
import { buildNative, buildWasm, buildWeb } from './build.mjs';
import { cmakeBuild } from './lib/cmake.mjs';
import { BUILD } from './lib/paths.mjs';
import { findChrome } from './lib/requirements.mjs';
import { Failure, runMain } from './lib/run.mjs';
import { runCatch, runNodeTests, testFiles } from './lib/suites.mjs';
import { setup } from './setup.mjs';

/** A finding ends the program in a way that no documented exit code can be taken for. */
const SANITIZER_ENV = {
  ASAN_OPTIONS: 'abort_on_error=1:detect_leaks=1:strict_string_checks=1',
  UBSAN_OPTIONS: 'abort_on_error=1:print_stacktrace=1',
  ABFLAT_BIN: join(BUILD, 'sanitize/abflat'),
  ABFLAT_DISKS: '48', // an instrumented program is slow
};

/** The node tests of one folder. */
const nodeSuite = (folder, title, env = () => ({})) => ({
  title: `tests/${folder} (${title})`,
  run: () => runNodeTests(folder, testFiles(folder), env()),
});

/** What each name builds first and then runs. */
const SUITES = {
  core: {
    build: [() => buildNative({ tests: true })],
    suites: [
      {
        title: 'tests/core (Catch2)',
        run: () => runCatch(join(BUILD, 'native/tests/abflat_core_tests')),
      },
    ],
  },
  node: {
    build: [() => buildNative({ tests: true }), buildBench, buildWasm],
    suites: ['scripts', 'native', 'bench', 'wasm'].map((folder) => nodeSuite(folder, 'node')),
  },
  browser: {
    build: [() => buildNative({ tests: true }), buildWasm, buildWeb],
    suites: [nodeSuite('web', 'Chromium', () => ({ CHROME_PATH: findChrome() }))],
  },
  sanitize: {
    build: [() => cmakeBuild('sanitize', { settings: { ABFLAT_SANITIZE: 'ON' } })],
    suites: [
      {
        title: 'tests/core (Catch2, sanitizers)',
        run: () => runCatch(join(BUILD, 'sanitize/tests/abflat_core_tests'), SANITIZER_ENV),
      },
      nodeSuite('native', 'sanitizers', () => SANITIZER_ENV),
    ],
  },
};

const describe = ({ passed, failed, skipped }) =>
  `${passed} passed, ${failed} failed, ${skipped} skipped`;

async function runSuites(names) {
  const results = [];
  for (const suite of names.flatMap((name) => SUITES[name].suites)) {
    console.log(`\n== ${suite.title}`);
    const started = performance.now();
    const totals = await suite.run();
    const seconds = (performance.now() - started) / 1000;
    results.push({ title: suite.title, seconds, ...totals });
  }
  return results;
}

function summarize(results) {
  const sum = { passed: 0, failed: 0, skipped: 0 };
  console.log('\n== Summary');
  for (const result of results) {
    for (const key of Object.keys(sum)) sum[key] += result[key];
    const mark = result.failed > 0 ? 'FAILED' : 'ok';
    console.log(
      `${mark.padEnd(7)} ${result.title.padEnd(34)} ${describe(result)}, ${result.seconds.toFixed(1)} s`,
    );
  }
  console.log(`\n${describe(sum)}`);
  return sum.failed === 0 && sum.passed > 0;
}

await runMain(async () => {
  const asked = process.argv.slice(2);
  const unknown = asked.find((name) => !SUITES[name]);
  if (unknown)
    throw new Failure(`Unknown suite "${unknown}"; known are: ${Object.keys(SUITES).join(', ')}.`);
  const names = asked.length > 0 ? asked : ['core', 'node', 'browser'];
  await setup(['build', 'test']);
  for (const name of names) {
    for (const build of SUITES[name].build) await build();
  }
  if (!summarize(await runSuites(names))) process.exitCode = 1;
});
