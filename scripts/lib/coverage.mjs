// Reads what clang counts in an instrumented program:
// https://clang.llvm.org/docs/SourceBasedCodeCoverage.html

import { existsSync, readdirSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { ROOT } from './paths.mjs';
import { Failure, mustRun, run, which } from './run.mjs';

/**
 * Where programs write their counts: a few files, shared by processes that run at the same time.
 */
export const profileIn = (folder) => join(folder, '%4m.profraw');

/** An LLVM tool, which Debian may only have with a version in its name. */
function tool(name) {
  const clang = which('clang++');
  const inBin = clang && readdirSync(dirname(clang)).find((each) => each.startsWith(`${name}-`));
  const found = which(name) ?? (inBin && which(inBin));
  if (!found) throw new Failure(`There is no ${name}; install LLVM.`);
  return found;
}

/**
 * Totals of lines and branches, as `{ covered, count }`, for each source below `root`/core/src,
 * worst first. Relative names, which compiler caches may leave, are resolved against the folder of
 * the first program.
 */
export async function readCoverage(folder, programs, root = ROOT) {
  const names = existsSync(folder) ? readdirSync(folder) : [];
  const raw = names.filter((name) => name.endsWith('.profraw')).map((name) => join(folder, name));
  if (raw.length === 0) throw new Failure(`No program has written counts to ${folder}.`);
  const merged = join(folder, 'all.profdata');
  await mustRun(tool('llvm-profdata'), ['merge', '-sparse', ...raw, '-o', merged]);
  const [first, ...others] = programs;
  const objects = [first, ...others.flatMap((program) => ['-object', program])];
  const args = ['export', '-summary-only', `-instr-profile=${merged}`, ...objects];
  // Differing versions of a header's function are reported on standard error, which is not part of
  // the text.
  const { code, output } = await run(tool('llvm-cov'), args, { capture: 'stdout' });
  if (code !== 0) throw new Failure(`llvm-cov failed:\n${output}`);
  const sources = join(root, 'core/src/');
  const files = JSON.parse(output)
    .data[0].files.map(({ filename, summary }) => ({
      filename: resolve(dirname(first), filename),
      summary,
    }))
    .filter(({ filename }) => filename.startsWith(sources));
  if (files.length === 0) throw new Failure(`No counts are of sources in ${sources}.`);
  return files
    .map(({ filename, summary }) => ({
      file: relative(root, filename),
      lines: summary.lines,
      branches: summary.branches,
    }))
    .sort((a, b) => missed(b.lines) - missed(a.lines));
}

export const missed = ({ covered, count }) => count - covered;

/** Total over all files. */
export function sum(files, key) {
  const total = { covered: 0, count: 0 };
  for (const file of files) {
    total.covered += file[key].covered;
    total.count += file[key].count;
  }
  return total;
}

export const percent = ({ covered, count }) => (count === 0 ? 100 : (100 * covered) / count);
