// Compiles the TypeScript into dist/ and adds the WebAssembly modules of build/wasm* and the
// licences.
// Usage: build.mjs [--only BUILD]   BUILD then stands in for the others, which may be missing or
// old

import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { deflateRawSync } from 'node:zlib';
import { buildSync, transformSync } from 'esbuild';
import { writeLicenses } from '../scripts/lib/licenses.mjs';
import { BUILDS, missingModule, NAMES, placeModules } from './modules.mjs';

const HERE = dirname(fileURLToPath(import.meta.url));
const DIST = join(HERE, 'dist');

/**
 * Bundles each worker into one file, beside Emscripten's script: one request less per module, and
 * nothing shared for bundlers to follow.
 */
function joinWorkers() {
  const workers = readdirSync(DIST).filter((name) => /^worker.*\.js$/.test(name));
  buildSync({
    entryPoints: workers.map((name) => join(DIST, name)),
    bundle: true,
    format: 'esm',
    target: 'es2022',
    minifySyntax: true,
    outdir: DIST,
    allowOverwrite: true,
    external: ['node:*', ...NAMES.map((name) => `./${name}.js`)],
  });
}

/** Puts the module, deflated, and all scripts that it takes into the entry that is one file. */
function joinSingle() {
  const wasm = readFileSync(join(DIST, 'abflat-simd.wasm'));
  const text = deflateRawSync(wasm, { level: 9 }).toString('base64');
  const module = join(DIST, 'single-module.js');
  const entry = join(DIST, 'single.js');
  writeFileSync(
    module,
    `export const DEFLATED = '${text}';\nexport const SIZE = ${wasm.length};\n`,
  );
  buildSync({
    entryPoints: [entry],
    bundle: true,
    format: 'esm',
    target: 'es2022',
    minifySyntax: true,
    legalComments: 'none',
    outfile: entry,
    allowOverwrite: true,
  });
  rmSync(module);
}

/** Browsers load scripts; the comments that people need are in the types. */
function leaveOutComments() {
  for (const name of readdirSync(DIST, { recursive: true }).filter((name) => /\.js$/.test(name))) {
    const path = join(DIST, name);
    const { code } = transformSync(readFileSync(path, 'utf8'), { format: 'esm', target: 'es2022' });
    writeFileSync(path, code);
  }
}

const { values } = parseArgs({ options: { only: { type: 'string' } } });
const builds = values.only === undefined ? BUILDS : [values.only];
const unknown = builds.find((build) => !BUILDS.includes(build));
if (unknown !== undefined) {
  console.error(`There is no build "${unknown}", only ${BUILDS.join(', ')}.`);
  process.exit(1);
}
const missing = missingModule(builds);
if (missing) {
  console.error(`${missing} does not exist: run "npm run build:wasm" in the repository.`);
  process.exit(1);
}
const tsc = createRequire(import.meta.url).resolve('typescript/bin/tsc');
rmSync(DIST, { recursive: true, force: true });
execFileSync(process.execPath, [tsc, '-p', HERE], { stdio: 'inherit' });
joinWorkers();
leaveOutComments();
placeModules(DIST, builds);
joinSingle();
writeLicenses(DIST, 'wasm');
