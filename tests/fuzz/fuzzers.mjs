// Runs the fuzzers for a while.
// Inputs worth keeping stay in build/fuzz/corpus, so that the next run continues from there. Inputs
// that end a target are in build/fuzz/found; run such a file again with
// build/sanitize/fuzzers/fuzz_TARGET FILE (for the package, tests/fuzz/javascript/replay.mjs FILE)
// and, once it is fixed, keep it in tests/fuzz/findings/TARGET.

import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { BUILD, ROOT } from '../../scripts/lib/paths.mjs';
import { run } from '../../scripts/lib/run.mjs';
import { writeSeeds } from './seeds.mjs';

const HOME = join(BUILD, 'fuzz');
export const FOUND = join(HOME, 'found');
/** Calls of the npm package, which libFuzzer does not see. */
export const PACKAGE_TARGET = 'javascript';

/**
 * Seconds that one input may take; more counts as a finding as well. With sanitizers some take 15
 * on a machine that does nothing else.
 */
const SECONDS = 180;
const LIMITS = [
  `-timeout=${SECONDS}`,
  `-report_slow_units=${SECONDS}`,
  '-rss_limit_mb=2048',
  '-malloc_limit_mb=1024',
];
/** Most bytes of an input. */
const LENGTHS = { unwrap: 1200, flatten: 1200, pack: 1200, verify: 1200 };
const USUAL_LENGTH = 8192;
/** Seeds below this run with every `npm test`. */
const FIRST_SEED = 1000;

const filesIn = (folder) => (existsSync(folder) ? readdirSync(folder) : []);
const fuzzerOf = (target) => join(BUILD, 'sanitize/fuzzers', `fuzz_${target}`);
const findingsOf = (target) => filesIn(FOUND).filter((name) => name.startsWith(`${target}-`));

/** Reads the lines that libFuzzer prints in fork mode: "#123: cov: 45 ft: 67 corp: 8 ...". */
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

/** Resolves to what was run and the file names of findings. */
export async function fuzz(target, seconds) {
  const corpus = join(HOME, 'corpus', target);
  mkdirSync(FOUND, { recursive: true });
  await writeSeeds(target, corpus);
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
      seconds: seconds + 2 * SECONDS,
    },
  );
  const found = findingsOf(target).filter((name) => !before.has(name));
  return { target, seconds, ...progressOf(output), found, output };
}

/**
 * The same for the npm package. A seed is a call, so there is no corpus: each run continues where
 * the last one ended.
 */
export async function fuzzPackage(seconds) {
  // The package may not be built until this is called.
  const { fuzzCalls } = await import('./javascript/fuzz-calls.mjs');
  const place = join(HOME, 'next-seed');
  const first = existsSync(place) ? Number(readFileSync(place, 'utf8')) : FIRST_SEED;
  const { next, ...rest } = await fuzzCalls({ seconds, first, folder: FOUND });
  writeFileSync(place, `${next}\n`);
  return { target: PACKAGE_TARGET, seconds, ...rest };
}
