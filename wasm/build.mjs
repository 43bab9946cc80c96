// Compiles the TypeScript into dist/ and puts the WebAssembly modules of build/wasm* and the licences beside it.

import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { writeLicenses } from '../scripts/lib/licenses.mjs';

const HERE = dirname(fileURLToPath(import.meta.url));
const DIST = join(HERE, 'dist');
/** Folder below build/ and base name in dist/ of every build in src/builds.ts. */
const MODULES = {
  plain: { folder: 'wasm', name: 'abflat' },
  simd: { folder: 'wasm-simd', name: 'abflat-simd' },
};

/** The module with a section "abflat.build" that says which build it is; all lengths fit in one byte. */
function labelled(bytes, build) {
  const name = Buffer.from('abflat.build');
  const content = Buffer.concat([Buffer.from([name.length]), name, Buffer.from(build)]);
  return Buffer.concat([bytes, Buffer.from([0, content.length]), content]);
}

const pathOf = (folder, file) => join(HERE, '../build', folder, file);
const missing = Object.values(MODULES)
  .flatMap(({ folder }) => ['abflat.mjs', 'abflat.wasm'].map((file) => pathOf(folder, file)))
  .find((path) => !existsSync(path));
if (missing) {
  console.error(`${missing} does not exist: run "npm run build:wasm" in the repository.`);
  process.exit(1);
}
const tsc = createRequire(import.meta.url).resolve('typescript/bin/tsc');
rmSync(DIST, { recursive: true, force: true });
execFileSync(process.execPath, [tsc, '-p', HERE], { stdio: 'inherit' });
for (const [build, { folder, name }] of Object.entries(MODULES)) {
  copyFileSync(pathOf(folder, 'abflat.mjs'), join(DIST, `${name}.mjs`));
  const wasm = readFileSync(pathOf(folder, 'abflat.wasm'));
  writeFileSync(join(DIST, `${name}.wasm`), labelled(wasm, build));
}
writeLicenses(DIST, 'wasm');
