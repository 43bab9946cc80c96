// Runs one test suite and returns its totals: `{ passed, failed, skipped }`.

import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { BUILD, ROOT } from './paths.mjs';
import { run } from './run.mjs';

const SECONDS = 20 * 60;

/** Runs a Catch2 program and counts its test cases. */
export async function runCatch(program, env = {}) {
  const { code, output } = await run(program, [], { echo: true, env, seconds: SECONDS });
  return settle(catchTotals(output), code);
}

/** Reads the closing lines of Catch2's console reporter, v2 or v3. */
export function catchTotals(output) {
  const allPassed = output.match(/^All tests passed \(.* in (\d+) test cases?\)/m);
  if (allPassed) return { passed: Number(allPassed[1]), failed: 0, skipped: 0 };
  const line = output.match(/^test cases?:.*$/gm)?.at(-1) ?? '';
  const count = (word) => Number(line.match(new RegExp(`(\\d+) ${word}`))?.[1] ?? 0);
  return { passed: count('passed'), failed: count('failed(?! as)'), skipped: count('skipped') };
}

/** Test files directly in tests/FOLDER. */
export function testFiles(folder) {
  const full = join(ROOT, 'tests', folder);
  if (!existsSync(full)) return [];
  const names = readdirSync(full).filter((name) => name.endsWith('.test.mjs'));
  return names.sort().map((name) => join('tests', folder, name));
}

/** Runs files with node's test runner: readable output on the terminal, totals from a TAP file. */
export async function runNodeTests(name, files, env = {}) {
  if (files.length === 0) {
    console.error(`There are no tests in tests/${name}.`);
    return settle(tapTotals(''), 1);
  }
  const tap = join(BUILD, 'tests', `${name}.tap`);
  mkdirSync(join(BUILD, 'tests'), { recursive: true });
  rmSync(tap, { force: true });
  const reporters = [
    '--test-reporter=spec',
    '--test-reporter-destination=stdout',
    '--test-reporter=tap',
    `--test-reporter-destination=${tap}`,
  ];
  const { code } = await run('node', ['--test', ...reporters, ...files], {
    env,
    seconds: SECONDS,
  });
  return settle(tapTotals(existsSync(tap) ? readFileSync(tap, 'utf8') : ''), code);
}

/** Reads the closing comments of node's TAP reporter. */
export function tapTotals(text) {
  const count = (word) => Number(text.match(new RegExp(`^# ${word} (\\d+)$`, 'm'))?.[1] ?? 0);
  return {
    passed: count('pass'),
    failed: count('fail') + count('cancelled'),
    skipped: count('skipped') + count('todo'),
  };
}

/** A runner that failed or ran nothing counts as at least one failure, whatever it printed. */
function settle(totals, code) {
  const { passed, failed, skipped } = totals;
  const isBroken = (code !== 0 && failed === 0) || passed + failed + skipped === 0;
  return isBroken ? { ...totals, failed: 1 } : totals;
}
