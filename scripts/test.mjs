#!/usr/bin/env node
// Builds what the tests need and runs them, as many in parallel as there are cores. Each suite is
// shown once it is complete. The last line is the total: "N passed, N failed, N skipped".
// Usage: test.mjs [SUITE or GROUP ...] [--long] [--minutes N]
// Suites and groups are those of suites.mjs (default: the group "default"). After --minutes no test
// is begun that only repeats what another runs; those left out are skipped and named.

import { parseArgs } from 'node:util';
import { JOBS } from './lib/cmake.mjs';
import { runPool } from './lib/pool.mjs';
import { Failure, runMain } from './lib/run.mjs';
import { setup } from './setup.mjs';
import { GROUPS, LONG_SUITES, SUITES } from './suites.mjs';

/** The closing lines of node's reporter, removed since they are printed once per suite here. */
const COUNTS = /^ℹ (tests|suites|pass|fail|cancelled|skipped|todo|duration_ms) [\d.]+\n/gm;

const describe = ({ passed, failed, skipped }) =>
  `${passed} passed, ${failed} failed, ${skipped} skipped`;

const markOf = ({ failed }) => (failed > 0 ? 'FAILED' : 'ok');

function add(results) {
  const sum = { passed: 0, failed: 0, skipped: 0 };
  for (const result of results) for (const key of Object.keys(sum)) sum[key] += result[key];
  return sum;
}

/** The named suites, each once. */
function choose(names) {
  const named = new Map([...SUITES, ...LONG_SUITES].map((suite) => [suite.name, [suite]]));
  const known = new Map([...named, ...Object.entries(GROUPS)]);
  const unknown = names.find((name) => !known.has(name));
  if (unknown !== undefined) {
    const list = [...known.keys()].join(', ');
    throw new Failure(`Unknown suite "${unknown}"; known are: ${list}.`);
  }
  return [...new Set(names.flatMap((name) => known.get(name)))];
}

const secondsSince = (start) => (performance.now() - start) / 1000;

/**
 * Builds what the suites need and notes how long each build took. Resolves to the builds that
 * failed, and why.
 */
async function buildFor(suites, times) {
  const broken = new Map();
  for (const build of new Set(suites.flatMap(({ needs }) => needs))) {
    const start = performance.now();
    try {
      await build();
    } catch (error) {
      if (!(error instanceof Failure)) throw error;
      console.error(error.message);
      broken.set(build, error.message);
    }
    times.push([build.name, secondsSince(start)]);
  }
  return broken;
}

/** The jobs of a suite, or one failed job if something could not be built. */
function jobsOf({ needs, jobs }, broken, options) {
  const reason = needs.map((build) => broken.get(build)).find(Boolean);
  if (reason === undefined) return jobs(options);
  const result = { passed: 0, failed: 1, skipped: 0, output: `Not run. ${reason}\n` };
  return [{ name: 'build', run: async () => result }];
}

function show({ title, parts }) {
  console.log(`\n== ${title}`);
  for (const part of parts) {
    if (parts.length > 1) console.log(`-- ${part.name} (${part.seconds.toFixed(1)} s)`);
    process.stdout.write(part.output.replaceAll(COUNTS, ''));
  }
}

/** Prints the summary; returns whether everything passed. */
function summarize(records, times) {
  console.log('\n== Summary');
  for (const [step, seconds] of times)
    console.log(`        ${step.padEnd(34)} ${seconds.toFixed(1)} s`);
  for (const { title, parts } of records) {
    const total = add(parts);
    const seconds = parts.reduce((sum, part) => sum + part.seconds, 0);
    console.log(
      `${markOf(total).padEnd(7)} ${title.padEnd(34)} ${describe(total)}, ${seconds.toFixed(1)} s`,
    );
  }
  const out = records.flatMap(({ parts }) => parts).filter(({ isLeftOut }) => isLeftOut);
  if (out.length > 0)
    console.log(`Left out for lack of time: ${out.map(({ name }) => name).join(', ')}`);
  for (const { name, failed } of records.flatMap(({ parts }) => parts).filter((p) => p.failed > 0))
    console.log(`FAILED  ${name}: ${failed} failed`);
  const sum = add(records.flatMap(({ parts }) => parts));
  console.log(`\n${describe(sum)}`);
  return sum.failed === 0 && sum.passed > 0;
}

await runMain(async () => {
  const { values, positionals } = parseArgs({
    options: { long: { type: 'boolean', default: false }, minutes: { type: 'string' } },
    allowPositionals: true,
  });
  const minutes = Number(values.minutes ?? Number.POSITIVE_INFINITY);
  if (!(minutes >= 0)) throw new Failure(`--minutes takes a number, not "${values.minutes}".`);
  const suites = choose(positionals.length > 0 ? positionals : ['default']);
  const start = performance.now();
  await setup([...new Set(suites.flatMap(({ purposes }) => purposes))]);
  const times = [['setup', secondsSince(start)]];
  const broken = await buildFor(suites, times);
  const runs = suites.map((suite) => ({
    title: suite.title,
    waits: suite.waits,
    repeats: suite.repeats,
    jobs: jobsOf(suite, broken, values),
  }));
  const testing = performance.now();
  const isLate = () => secondsSince(start) > minutes * 60;
  const records = await runPool(runs, Number(JOBS), show, isLate);
  times.push(['all tests', secondsSince(testing)]);
  if (!summarize(records, times)) process.exitCode = 1;
});
