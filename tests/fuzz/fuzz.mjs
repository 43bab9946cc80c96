#!/usr/bin/env node
// Runs the fuzzers for a while and prints what they did.
// Usage: npm run fuzz -- --minutes N [--targets obj,unwrap]
// Inputs that are worth keeping stay in build/fuzz/corpus, so that the next run goes on from there.
// What ends a target is in build/fuzz/found; a file is run again by build/fuzz/fuzzers/fuzz_TARGET FILE
// and, once mended, kept in tests/fuzz/findings/TARGET.

import { cpSync, existsSync, mkdirSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { cmakeBuild, JOBS } from '../../scripts/lib/cmake.mjs';
import { BUILD, ROOT } from '../../scripts/lib/paths.mjs';
import { Failure, run, runMain } from '../../scripts/lib/run.mjs';
import { setup } from '../../scripts/setup.mjs';
import { TARGET_NAMES, writeSeeds } from './seeds.mjs';

const HOME = join(BUILD, 'fuzz');
const FOUND = join(HOME, 'found');

/** Of one input: what a target may take before that is a finding as well. */
const LIMITS = ['-timeout=25', '-rss_limit_mb=2048', '-malloc_limit_mb=1024'];
/** Bytes of an input at most. */
const LENGTHS = { unwrap: 1200, flatten: 1200 };
const USUAL_LENGTH = 8192;

const filesIn = (folder) => (existsSync(folder) ? readdirSync(folder) : []);
const fuzzerOf = (target) => join(HOME, 'fuzzers', `fuzz_${target}`);
const findingsOf = (target) => filesIn(FOUND).filter((name) => name.startsWith(`${target}-`));

export async function buildFuzzers() {
  await cmakeBuild('fuzz', {
    settings: { ABFLAT_FUZZ: 'ON', ABFLAT_SANITIZE: 'ON' },
    env: { CC: 'clang', CXX: 'clang++' },
    targets: ['abflat_fuzzers'],
  });
}

/** Reads the lines that libFuzzer prints while it forks: "#123: cov: 45 ft: 67 corp: 8 ...". */
export function progressOf(output) {
  const lines = [...output.matchAll(/^#(\d+):? .*?cov: (\d+) .*?corp: (\d+)/gm)];
  if (lines.length === 0) return { executions: 0, before: 0, after: 0, corpus: 0 };
  const [first, last] = [lines[0], lines.at(-1)];
  return {
    executions: Number(last[1]),
    before: Number(first[2]),
    after: Number(last[2]),
    corpus: Number(last[3]),
  };
}

async function fuzz(target, seconds) {
  const corpus = join(HOME, 'corpus', target);
  writeSeeds(target, corpus);
  const kept = join(ROOT, 'tests/fuzz/findings', target);
  if (existsSync(kept)) cpSync(kept, corpus, { recursive: true });
  const before = new Set(findingsOf(target));
  const { output } = await run(
    fuzzerOf(target),
    [
      ...LIMITS,
      '-fork=1',
      '-ignore_crashes=1',
      '-ignore_timeouts=1',
      '-ignore_ooms=1',
      `-max_total_time=${seconds}`,
      `-max_len=${LENGTHS[target] ?? USUAL_LENGTH}`,
      `-artifact_prefix=${join(FOUND, `${target}-`)}`,
      corpus,
    ],
    {
      capture: true,
      env: { ASAN_OPTIONS: 'allocator_may_return_null=0:detect_leaks=1' },
      seconds: seconds + 120,
    },
  );
  const found = findingsOf(target).filter((name) => !before.has(name));
  return { target, seconds, ...progressOf(output), found, output };
}

async function fuzzAll(targets, minutes) {
  const share = Math.max(1, Math.round((60 * minutes * Number(JOBS)) / targets.length));
  const waiting = [...targets];
  const results = [];
  const work = async () => {
    for (let target = waiting.shift(); target; target = waiting.shift())
      results.push(await fuzz(target, share));
  };
  await Promise.all(Array.from({ length: Number(JOBS) }, work));
  return results.sort((a, b) => targets.indexOf(a.target) - targets.indexOf(b.target));
}

function print(results) {
  const rows = [
    ['target', 'seconds', 'executions', 'coverage', 'new coverage', 'corpus', 'findings'],
    ...results.map((r) =>
      [
        r.target,
        r.seconds,
        r.executions,
        r.after,
        r.after - r.before,
        r.corpus,
        r.found.length,
      ].map(String),
    ),
  ];
  const widths = rows[0].map((_, i) => Math.max(...rows.map((row) => row[i].length)));
  for (const row of rows)
    console.log(
      row.map((cell, i) => (i ? cell.padStart(widths[i]) : cell.padEnd(widths[i]))).join('  '),
    );
  for (const { found } of results)
    for (const name of found) console.log(`found ${join(FOUND, name)}`);
}

await runMain(async () => {
  const { values } = parseArgs({
    options: { minutes: { type: 'string', default: '10' }, targets: { type: 'string' } },
  });
  const minutes = Number(values.minutes);
  if (!(minutes > 0))
    throw new Failure(`--minutes takes a number above 0, not "${values.minutes}".`);
  const targets = values.targets?.split(',') ?? TARGET_NAMES;
  const unknown = targets.find((target) => !TARGET_NAMES.includes(target));
  if (unknown !== undefined)
    throw new Failure(`Unknown target "${unknown}"; known are: ${TARGET_NAMES.join(', ')}.`);
  await setup(['build', 'fuzz']);
  await buildFuzzers();
  mkdirSync(FOUND, { recursive: true });
  const results = await fuzzAll(targets, minutes);
  print(results);
  const idle = results.filter(({ executions }) => executions === 0);
  for (const { target, output } of idle) console.log(`\n${target} ran nothing:\n${output}`);
  const findings = results.reduce((sum, { found }) => sum + found.length, 0);
  console.log(
    `\n${results.length - idle.length} passed, ${findings + idle.length} failed, 0 skipped`,
  );
  if (findings + idle.length > 0) process.exitCode = 1;
});
