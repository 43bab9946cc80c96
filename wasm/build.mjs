// Compiles the TypeScript into dist/ and puts the WebAssembly modules of build/wasm* and the licences beside it.

import { execFileSync } from 'node:child_process';
import {
  copyFileSync,
  existsSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { transformSync } from 'esbuild';
import { writeLicenses } from '../scripts/lib/licenses.mjs';

const HERE = dirname(fileURLToPath(import.meta.url));
const DIST = join(HERE, 'dist');
/** Folder below build/, base name there and in dist/ of every build in src/builds.ts. */
const MODULES = {
  plain: { folder: 'wasm', built: 'abflat', name: 'abflat' },
  simd: { folder: 'wasm-simd', built: 'abflat', name: 'abflat-simd' },
  threads: { folder: 'wasm-threads', built: 'abflat-threads', name: 'abflat-threads' },
};

/** The module with a section "abflat.build" that says which build it is; all lengths fit in one byte. */
function labelled(bytes, build) {
  const name = Buffer.from('abflat.build');
  const content = Buffer.concat([Buffer.from([name.length]), name, Buffer.from(build)]);
  return Buffer.concat([bytes, Buffer.from([0, content.length]), content]);
}

/**
 * The engine always says which script a thread is to load. The import that is there in case it did not would make
 * bundlers split the worker, which not all of their formats allow.
 */
function withoutImport(text, file) {
  const unused = [`import("./${file}")`, `import('./${file}')`].find((part) => text.includes(part));
  if (unused) return text.replace(unused, 'undefined');
  console.error(`The script that starts a thread should import ${file}, and does not.`);
  process.exit(1);
}

/** Smaller, with the names that errors and users see; those of Emscripten's script say nothing anyway. */
function minify(name) {
  const path = join(DIST, name);
  const isGlue = name.endsWith('.mjs');
  const options = { minifyWhitespace: true, minifySyntax: true, minifyIdentifiers: isGlue };
  writeFileSync(path, transformSync(readFileSync(path, 'utf8'), options).code);
}

const pathOf = (folder, file) => join(HERE, '../build', folder, file);
const missing = Object.values(MODULES)
  .flatMap(({ folder, built }) =>
    [`${built}.mjs`, `${built}.wasm`].map((file) => pathOf(folder, file)),
  )
  .find((path) => !existsSync(path));
if (missing) {
  console.error(`${missing} does not exist: run "npm run build:wasm" in the repository.`);
  process.exit(1);
}
const tsc = createRequire(import.meta.url).resolve('typescript/bin/tsc');
rmSync(DIST, { recursive: true, force: true });
execFileSync(process.execPath, [tsc, '-p', HERE], { stdio: 'inherit' });
for (const [build, { folder, built, name }] of Object.entries(MODULES)) {
  copyFileSync(pathOf(folder, `${built}.mjs`), join(DIST, `${name}.mjs`));
  const wasm = readFileSync(pathOf(folder, `${built}.wasm`));
  writeFileSync(join(DIST, `${name}.wasm`), labelled(wasm, build));
  // What a thread begins with; newer releases of Emscripten have it in the module's script.
  const starter = pathOf(folder, `${built}.worker.js`);
  if (existsSync(starter)) {
    const text = withoutImport(readFileSync(starter, 'utf8'), `${built}.mjs`);
    writeFileSync(join(DIST, `${name}.worker.js`), text);
  }
}
for (const name of readdirSync(DIST)) if (/\.m?js$/.test(name)) minify(name);
writeLicenses(DIST, 'wasm');
