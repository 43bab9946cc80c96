// Compiles the TypeScript into dist/ and puts the WebAssembly module of build/wasm and the licences beside it.

import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { writeLicenses } from '../scripts/lib/licenses.mjs';

const HERE = dirname(fileURLToPath(import.meta.url));
const DIST = join(HERE, 'dist');
const MODULE = join(HERE, '../build/wasm');
const FILES = ['abflat.mjs', 'abflat.wasm'];

const missing = FILES.find((name) => !existsSync(join(MODULE, name)));
if (missing) {
  console.error(
    `build/wasm/${missing} does not exist: run "npm run build:wasm" in the repository.`,
  );
  process.exit(1);
}
const tsc = createRequire(import.meta.url).resolve('typescript/bin/tsc');
rmSync(DIST, { recursive: true, force: true });
execFileSync(process.execPath, [tsc, '-p', HERE], { stdio: 'inherit' });
for (const name of FILES) copyFileSync(join(MODULE, name), join(DIST, name));
writeLicenses(DIST, 'wasm');
