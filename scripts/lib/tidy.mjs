// Runs clang-tidy on the sources of core and native. Sources are read in batches; clean ones are
// skipped until they, or a header that they include, change.

import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { batches } from './batches.mjs';
import { includeScanner } from './includes.mjs';
import { BUILD, ROOT } from './paths.mjs';
import { run } from './run.mjs';
import { fingerprint, stamp } from './stamp.mjs';

const FOLDER = join(BUILD, 'tidy');
const MOST = 48;
/** The analyzer recognizes this name and checks included files like the file itself. */
const BATCH = 'UnifiedSource.cpp';
/** A batch includes sources, which this check would warn about. */
const BATCH_CHECKS = '--checks=-bugprone-suspicious-include';

/**
 * How far the analyzer explores each function: half of its own limit for a quick analysis, and its
 * limit for a deep one, which takes three times as long.
 */
const QUICK_NODES = 40000;
const DEEP_NODES = 225000;
const analyzerArgs = (nodes) =>
  ['-Xclang', '-analyzer-config', '-Xclang', `max-nodes=${nodes}`].map(
    (arg) => `--extra-arg=${arg}`,
  );

/** Nothing is compiled: sources that differ in this alone are read together. */
const OPTIMIZING = / -O\w+/g;

/** In large pages of memory it takes a seventh less time; libraries that know none ignore this. */
const HUGE_PAGES = { GLIBC_TUNABLES: 'glibc.malloc.hugetlb=1' };

const escaped = (path) => path.replaceAll(/[.+*?^$()[\]{}|\\]/g, '\\$&');

/** What is compiled for each source: itself, or a file of CMake's that includes those of a folder. */
export function sourcesOf(file) {
  if (!/\/Unity\/unity_\w+\.cxx$/.test(file)) return [file];
  return [...readFileSync(file, 'utf8').matchAll(/^#include "(.+)"$/gm)].map(([, path]) => path);
}

/** The compiled sources, each once, in the form that batches() expects and with their stamps. */
function sources(database, nodes) {
  const filesOf = includeScanner();
  const common = `${nodes} ${fingerprint([join(ROOT, '.clang-tidy')])}`;
  const compiled = JSON.parse(readFileSync(join(database, 'compile_commands.json'), 'utf8'));
  const entries = new Map(
    compiled.flatMap((entry) =>
      sourcesOf(entry.file).map((file) => [file, { ...entry, file, unit: entry.file }]),
    ),
  );
  return [...entries.values()]
    .filter(({ file }) => /^(core|native)\//.test(relative(ROOT, file)) && existsSync(file))
    .map(({ file, unit, command, directory }) => {
      const flags = command.slice(0, command.lastIndexOf(' -o ')).replaceAll(OPTIMIZING, '');
      const files = filesOf(file);
      return {
        file,
        unit,
        text: readFileSync(file, 'utf8'),
        headers: files.filter((each) => each !== file).map((each) => readFileSync(each, 'utf8')),
        flags,
        directory,
        mark: stamp(`tidy-${relative(ROOT, file).replaceAll('/', '-')}`),
        hash: `${common} ${fingerprint(files)} ${flags}`,
      };
    });
}

/** Runs clang-tidy on a file that is compiled like `source`. */
async function clangTidy(file, { flags, directory }, folder, args) {
  const command = `${flags} -o checked.o -c ${file}`;
  const database = JSON.stringify([{ directory, command, file }]);
  writeFileSync(join(folder, 'compile_commands.json'), database);
  const others = '--extra-arg=-Wno-unknown-warning-option'; // those of g++
  return run('clang-tidy', ['-p', folder, '--quiet', others, ...args, file], {
    capture: true,
    env: HUGE_PAGES,
  });
}

/**
 * Checks the sources of a batch as one, or each alone if that does not work. Resolves to the clean
 * sources and to the output about the others. `folder` is for its own files.
 */
export async function checkBatch(list, folder, { root = ROOT, nodes = DEEP_NODES } = {}) {
  mkdirSync(folder, { recursive: true });
  const file = join(folder, BATCH);
  writeFileSync(file, list.map((source) => `#include "${source.file}"\n`).join(''));
  const filter = `--header-filter=^${escaped(root)}/(core/include|core/src|core/formats|native/src|native/python/src)/.*\\.(h|cpp)$`;
  const args = analyzerArgs(nodes);
  const together = await clangTidy(file, list[0], folder, [BATCH_CHECKS, filter, ...args]);
  if (together.code === 0) return { clean: list, output: '' };
  // Compiler errors and warnings may come from names that only meet here.
  if (!together.output.includes('[clang-diagnostic-'))
    return { clean: [], output: together.output };
  const clean = [];
  let output = '';
  for (const source of list) {
    const alone = await clangTidy(source.file, source, folder, args);
    if (alone.code === 0) clean.push(source);
    else output += alone.output;
  }
  return { clean, output };
}

/**
 * A function that checks batches until none is left and resolves to `{ isClean, output }`; several calls share them.
 * `database` is a build folder with compile_commands.json. With `long` the analyzer looks deeper.
 */
export function tidyWorker(database, { long = false } = {}) {
  rmSync(FOLDER, { recursive: true, force: true });
  const nodes = long ? DEEP_NODES : QUICK_NODES;
  const stale = sources(database, nodes).filter(({ mark, hash }) => !mark.isFresh(hash));
  const waiting = [...batches(stale, MOST).entries()].sort(([, a], [, b]) => b.length - a.length);
  return async () => {
    const result = { isClean: true, output: '' };
    for (let next = waiting.shift(); next !== undefined; next = waiting.shift()) {
      const [index, list] = next;
      const { clean, output } = await checkBatch(list, join(FOLDER, String(index)), { nodes });
      for (const { mark, hash } of clean) mark.set(hash);
      result.isClean &&= clean.length === list.length;
      result.output += output;
    }
    return result;
  };
}
