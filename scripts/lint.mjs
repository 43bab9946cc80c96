#!/usr/bin/env node
// Checks formatting, likely mistakes, types and generated files. With --fix formats instead of
// complaining.

import { existsSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { buildNative, buildWasm } from './build.mjs';
import { JOBS } from './lib/cmake.mjs';
import { BUILD, ROOT } from './lib/paths.mjs';
import { Failure, run, runMain } from './lib/run.mjs';
import { filesBelow, fingerprint, stamp } from './lib/stamp.mjs';
import { setup } from './setup.mjs';

const CPP_FOLDERS = ['core/include', 'core/src', 'native', 'wasm/bindings', 'tests/core'];
const BIOME = join(ROOT, 'node_modules/.bin/biome');
const TSC = join(ROOT, 'node_modules/.bin/tsc');

const cppFiles = () => filesBelow(CPP_FOLDERS).filter((path) => /\.(h|cpp)$/.test(path));

async function clangFormat(fix) {
  const mode = fix ? ['-i'] : ['--dry-run', '-Werror'];
  const { code } = await run('clang-format', [...mode, '--style=file', ...cppFiles()]);
  return code === 0;
}

async function biome(fix) {
  const colors = process.stdout.isTTY ? [] : ['--colors=off'];
  const { code } = await run(BIOME, [...(fix ? ['check', '--write'] : ['ci']), ...colors, '.']);
  return code === 0;
}

/**
 * The sources of core and native, several at a time; files that were clean are left out until
 * something changes.
 */
async function clangTidy() {
  await buildNative();
  const headers = cppFiles().filter((path) => path.endsWith('.h'));
  const common = fingerprint([...headers, join(ROOT, '.clang-tidy'), join(ROOT, 'CMakeLists.txt')]);
  const database = join(BUILD, 'native');
  const compiled = JSON.parse(readFileSync(join(database, 'compile_commands.json'), 'utf8'));
  const waiting = compiled
    .map(({ file }) => file)
    .filter((file) => /^(core|native)\//.test(relative(ROOT, file)) && existsSync(file));
  let isClean = true;
  const work = async () => {
    for (let file = waiting.pop(); file !== undefined; file = waiting.pop()) {
      const mark = stamp(`tidy-${relative(ROOT, file).replaceAll('/', '-')}`);
      const hash = fingerprint([file]) + common;
      if (mark.isFresh(hash)) continue;
      const { code, output } = await run('clang-tidy', ['-p', database, '--quiet', file], {
        capture: true,
      });
      if (code === 0) mark.set(hash);
      else console.log(output);
      isClean &&= code === 0;
    }
  };
  await Promise.all(Array.from({ length: Number(JOBS) }, work));
  return isClean;
}

/** The page sees the package's types as built. */
async function typeCheck() {
  await buildWasm();
  let isClean = true;
  for (const workspace of ['wasm', 'web']) {
    const { code } = await run(TSC, ['--noEmit', '-p', join(ROOT, workspace)]);
    isClean &&= code === 0;
  }
  return isClean;
}

async function generated(fix) {
  const { code } = await run('node', ['scripts/generate.mjs', ...(fix ? [] : ['--check'])]);
  return code === 0;
}

/** A check that could not be carried out has failed; the others still run. */
async function passes(check) {
  try {
    return await check();
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    console.error(error.message);
    return false;
  }
}

await runMain(async () => {
  const fix = process.argv.includes('--fix');
  await setup(['build', 'lint']);
  const checks = fix
    ? { generated, biome, clangFormat }
    : { generated, biome, clangFormat, typeCheck, clangTidy };
  const failed = [];
  for (const [name, check] of Object.entries(checks)) {
    console.log(`== ${name}`);
    if (!(await passes(() => check(fix)))) failed.push(name);
  }
  console.log(failed.length > 0 ? `\nfailed: ${failed.join(', ')}` : '\nall clean');
  if (failed.length > 0 && !fix)
    console.log('npm run format repairs formatting and generated files.');
  if (failed.length > 0) process.exitCode = 1;
});
