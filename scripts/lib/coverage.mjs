// What clang counts of an instrumented program: https://clang.llvm.org/docs/SourceBasedCodeCoverage.html

import { existsSync, readdirSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { ROOT } from './paths.mjs';
import { Failure, mustRun, run, which } from './run.mjs';

/** What programs write their counts to: few files, which processes that run at once share. */
export const profileIn = (folder) => join(folder, '%4m.profraw');

/** A program of LLVM, which Debian may have with its version only. */
function tool(name) {
  const clang = which('clang++');
  const inBin = clang && readdirSync(dirname(clang)).find((each) => each.startsWith(`${name}-`));
  const found = which(name) ?? (inBin && which(inBin));
  if (!found) throw new Failure(`There is no ${name}; install LLVM.`);
  return found;
}

/**
 * Totals of lines and branches, as `{ covered, count }`, for each source below `root`/core/src, worst first. Names that are not absolute, as compiler caches
 * may leave them, begin where the first program is.
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
  // Differing versions of a header's function are said on standard error, which is no part of the text.
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

/** Of all files together. */
export function sum(files, key) {
  const total = { covered: 0, count: 0 };
  for (const file of files) {
    total.covered += file[key].covered;
    total.count += file[key].count;
  }
  return total;
}

export const percent = ({ covered, count }) => (count === 0 ? 100 : (100 * covered) / count);
