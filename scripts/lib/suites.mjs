// The parts of a test suite that can run in parallel, as jobs: `{ name, run }`, where `run`
// resolves to `{ passed, failed, skipped, output }`.

import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fuzz } from '../../tests/fuzz/fuzzers.mjs';
import { TARGET_NAMES } from '../../tests/fuzz/seeds.mjs';
import { BUILD, ROOT } from './paths.mjs';
import { run } from './run.mjs';

const SECONDS = 40 * 60;
/** All tests of Catch2, which by default leaves out those tagged [.long]. */
const EVERYTHING = '*';
/**
 * Tests that measure quality on many meshes take minutes with sanitizers or an emulator, and run
 * nothing that others do not. What is to be left out has to include what Catch2 leaves out by
 * itself.
 */
export const NOT_QUALITY = '~[quality]~[.]';

/**
 * A Catch2 program; its totals count test cases. `filter` selects tests by their tags; `long`
 * includes those tagged [.long].
 */
export function catchJobs(program, env = {}, { long = false, filter } = {}) {
  const runAll = async () => {
    const args = [filter ?? (long ? EVERYTHING : [])].flat();
    const { code, output } = await run(program, args, { capture: true, env, seconds: SECONDS });
    return { ...settle(catchTotals(output), code), output };
  };
  return [{ name: basename(program), run: runAll }];
}

/** Reads the closing lines of Catch2's console reporter, v2 or v3. */
export function catchTotals(output) {
  const allPassed = output.match(/^All tests passed \(.* in (\d+) test cases?\)/m);
  if (allPassed) return { passed: Number(allPassed[1]), failed: 0, skipped: 0 };
  const line = output.match(/^test cases?:.*$/gm)?.at(-1) ?? '';
  const count = (word) => Number(line.match(new RegExp(`(\\d+) ${word}`))?.[1] ?? 0);
  return { passed: count('passed'), failed: count('failed(?! as)'), skipped: count('skipped') };
}

/** Files directly in tests/FOLDER: NAME.test.mjs, and with `long` NAME.long.mjs too. */
export function testFiles(folder, { long = false } = {}) {
  const full = join(ROOT, 'tests', folder);
  if (!existsSync(full)) return [];
  const names = readdirSync(full).filter(
    (name) => name.endsWith('.test.mjs') || (long && name.endsWith('.long.mjs')),
  );
  return names.sort().map((name) => join('tests', folder, name));
}

/**
 * A job for each file of a folder. `kind` distinguishes several runs of one folder. `run` of a job
 * takes what its environment has in addition.
 */
export function nodeJobs(folder, env = {}, { long = false, kind = '' } = {}) {
  const files = testFiles(folder, { long });
  if (files.length === 0) return [noTests(folder)];
  return files.map((file) => ({
    name: file,
    run: (more = {}) => runNodeTests(file, { ...env, ...more }, kind),
  }));
}

function noTests(folder) {
  const output = `There are no tests in tests/${folder}.\n`;
  return { name: folder, run: async () => ({ ...settle(tapTotals(''), 1), output }) };
}

/** Runs a file with node's test runner: readable output, totals from a TAP file. */
async function runNodeTests(file, env, kind) {
  const tap = join(BUILD, 'tests', kind, `${file.replaceAll('/', '-')}.tap`);
  mkdirSync(join(BUILD, 'tests', kind), { recursive: true });
  rmSync(tap, { force: true });
  const reporters = [
    '--test-reporter=spec',
    '--test-reporter-destination=stdout',
    '--test-reporter=tap',
    `--test-reporter-destination=${tap}`,
  ];
  const { code, output } = await run('node', ['--test', ...reporters, file], {
    capture: true,
    env: { ...(process.stdout.isTTY ? { FORCE_COLOR: '1' } : {}), ...env },
    seconds: SECONDS,
  });
  return { ...settle(tapTotals(existsSync(tap) ? readFileSync(tap, 'utf8') : ''), code), output };
}

/** A job for each fuzzer; they share the time. */
export function fuzzJobs(seconds) {
  const share = Math.ceil(seconds / TARGET_NAMES.length);
  return TARGET_NAMES.map((target) => ({
    name: `fuzz_${target}`,
    run: async () => {
      const { executions, found, output } = await fuzz(target, share);
      const isFine = executions > 0 && found.length === 0;
      const said = `${target}: ${executions} executions, ${found.length} findings\n`;
      return { ...settle(oneOf(isFine), 0), output: isFine ? said : said + output };
    },
  }));
}

const oneOf = (isFine) => ({ passed: isFine ? 1 : 0, failed: isFine ? 0 : 1, skipped: 0 });

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
