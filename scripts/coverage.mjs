#!/usr/bin/env node
// Measures which lines and branches of the core the core and command line tests reach. Fails if
// coverage is below the required level.

import { mkdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { JOBS } from './lib/cmake.mjs';
import { missed, percent, readCoverage, sum } from './lib/coverage.mjs';
import { BUILD } from './lib/paths.mjs';
import { runPool } from './lib/pool.mjs';
import { runMain } from './lib/run.mjs';
import { setup } from './setup.mjs';
import { COVERED_SUITES, PROFILES } from './suites.mjs';

const DEMANDED = { lines: 90, branches: 80 };
const WORST = 20;

const shown = (part) => `${percent(part).toFixed(1).padStart(5)} %`;

await runMain(async () => {
  await setup(['build', 'test', 'coverage']);
  for (const build of new Set(COVERED_SUITES.flatMap(({ needs }) => needs))) await build();
  rmSync(PROFILES, { recursive: true, force: true });
  mkdirSync(PROFILES, { recursive: true });
  const runs = COVERED_SUITES.map(({ title, jobs }) => ({ title, jobs: jobs({}) }));
  await runPool(runs, Number(JOBS), ({ title, parts }) => {
    const failed = parts.filter((part) => part.failed > 0);
    console.log(`== ${title}${failed.length > 0 ? ', with failures:' : ''}`);
    for (const { output } of failed) process.stdout.write(output);
    if (failed.length > 0) process.exitCode = 1;
  });
  const programs = ['abflat', 'tests/abflat_core_tests'].map((name) =>
    join(BUILD, 'coverage', name),
  );
  const files = await readCoverage(PROFILES, programs);
  console.log('\n  lines  branches  missed lines');
  for (const { file, lines, branches } of files.slice(0, WORST))
    console.log(
      `${shown(lines)}  ${shown(branches)}  ${String(missed(lines)).padStart(5)}  ${file}`,
    );
  for (const [key, least] of Object.entries(DEMANDED)) {
    const total = sum(files, key);
    console.log(`${key}: ${shown(total)} of ${total.count}, at least ${least} % demanded`);
    if (percent(total) < least) process.exitCode = 1;
  }
});
