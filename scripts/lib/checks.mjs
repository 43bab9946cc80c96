// The checks of `npm run lint`, as jobs: `{ name, run }`, where `run` resolves to
// `{ passed, failed, skipped, output }`.

import { join } from 'node:path';
import { buildNative, buildPython, buildWasm, buildWeb } from '../build.mjs';
import { JOBS } from './cmake.mjs';
import { layerFaults } from './layers.mjs';
import { BUILD, ROOT } from './paths.mjs';
import { Failure, run } from './run.mjs';
import { filesBelow } from './stamp.mjs';
import { tidyWorker } from './tidy.mjs';

const CPP_FOLDERS = [
  'core/include',
  'core/src',
  'core/formats',
  'native',
  'wasm/bindings',
  'examples',
  'tests',
];
const BIOME = join(ROOT, 'node_modules/.bin/biome');

/**
 * Builds that the checks need: for the compile commands, and for the types, which both builds
 * check.
 */
export const CHECKED_BUILDS = [buildNative, buildPython, buildWasm, buildWeb];

const cppFiles = () => filesBelow(CPP_FOLDERS).filter((path) => /\.(h|cpp)$/.test(path));

/** `fix` formats instead of complaining. */
const COMMANDS = {
  generated: (fix) => ['node', 'scripts/generate.mjs', ...(fix ? [] : ['--check'])],
  biome: (fix) => {
    const colors = process.stdout.isTTY ? [] : ['--colors=off'];
    return [BIOME, ...(fix ? ['check', '--write'] : ['ci']), ...colors, '.'];
  },
  clangFormat: (fix) => {
    const mode = fix ? ['-i'] : ['--dry-run', '-Werror'];
    return ['clang-format', ...mode, '--style=file', ...cppFiles()];
  },
};

function job(name, check) {
  const runCheck = async () => {
    const { isClean, output } = await check();
    return { passed: isClean ? 1 : 0, failed: isClean ? 0 : 1, skipped: 0, output };
  };
  return { name, run: () => runCheck().catch(asFailed) };
}

/** A check that could not run counts as failed; the others still run. */
function asFailed(error) {
  if (!(error instanceof Failure)) throw error;
  return { passed: 0, failed: 1, skipped: 0, output: `${error.message}\n` };
}

/** The checks that format, or report what is not formatted. */
export const formatJobs = ({ fix = false } = {}) =>
  Object.entries(COMMANDS).map(([name, commandOf]) =>
    job(name, async () => {
      const [program, ...args] = commandOf(fix);
      const { code, output } = await run(program, args, { capture: true });
      return { isClean: code === 0, output };
    }),
  );

async function checkLayers() {
  const faults = layerFaults(ROOT);
  return { isClean: faults.length === 0, output: faults.map((fault) => `${fault}\n`).join('') };
}

/**
 * All checks, deeper ones with `long`. clang-tidy is split into as many jobs as there are cores,
 * which share its work.
 */
export function checkJobs({ long = false } = {}) {
  let worker;
  const tidy = () => {
    worker ??= tidyWorker(join(BUILD, 'native'), { long });
    return worker();
  };
  const tidyJobs = Array.from({ length: Number(JOBS) }, (_, i) => job(`clangTidy ${i + 1}`, tidy));
  return [...tidyJobs, ...formatJobs(), job('layers', checkLayers)];
}
