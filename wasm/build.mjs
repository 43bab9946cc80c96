// Compiles the TypeScript into dist/ and puts the WebAssembly modules of build/wasm* and the licences beside it.

import { execFileSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildSync, transformSync } from 'esbuild';
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

/** As bundlers have to see it: the address of a script that is there as it is, no module of theirs. */
const IGNORED = '/* webpackIgnore: true */ /* turbopackIgnore: true */ /* @vite-ignore */';

/**
 * What a thread begins with, so that bundlers leave its import alone and a thread that cannot start is an error of its worker, which
 * ends the run: of a promise that nobody looks at, nobody would hear. The engine always says which script is to be loaded, so there is
 * no other one.
 */
function ownStarter(text, file) {
  const found = text.match(
    /\(e\.data\.urlOrBlob\s*\?\s*import\(e\.data\.urlOrBlob\)\s*:\s*import\((['"])\.\/(\S+?)\1\)\)(\.then\(.*?Module\s*=\s*instance;?\s*\}\))/s,
  );
  if (found?.[2] !== file) {
    console.error(`The script that starts a thread should import ${file}, and does not.`);
    process.exit(1);
  }
  const load = `import(${IGNORED} e.data.urlOrBlob)${found[3]}`;
  const tell = '.catch((error) => setTimeout(() => { throw error; }))';
  return text.replace(found[0], load + tell);
}

/**
 * Emscripten's script, small: its names say nothing, while ours stay readable. The engine instantiates the module itself, so bundlers
 * need not find one here. Newer releases of Emscripten start threads from the script by its name.
 */
function ownScript(text, built, name) {
  const address = new RegExp(
    `new URL\\((['"])${built}\\.wasm\\1,\\s*import\\.meta\\.url\\)\\.(toString\\(\\)|href)`,
  );
  const own = text.replace(address, "''").replaceAll(`${built}.mjs`, `${name}.js`);
  return transformSync(own, { minify: true }).code;
}

/** Workers in one file each, beside the script of Emscripten: one request less for each module, and nothing that bundlers share. */
function joinWorkers() {
  const workers = readdirSync(DIST).filter((name) => /^worker.*\.js$/.test(name));
  buildSync({
    entryPoints: workers.map((name) => join(DIST, name)),
    bundle: true,
    format: 'esm',
    target: 'es2022',
    outdir: DIST,
    allowOverwrite: true,
    external: ['node:*', ...Object.values(MODULES).map(({ name }) => `./${name}.js`)],
  });
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
joinWorkers();
for (const [build, { folder, built, name }] of Object.entries(MODULES)) {
  const read = (file) => readFileSync(pathOf(folder, file), 'utf8');
  const wasm = readFileSync(pathOf(folder, `${built}.wasm`));
  writeFileSync(join(DIST, `${name}.wasm`), labelled(wasm, build));
  // Not .mjs, which some servers send without a type.
  writeFileSync(join(DIST, `${name}.js`), ownScript(read(`${built}.mjs`), built, name));
  // What a thread begins with; newer releases of Emscripten have it in the module's script.
  const starter = `${built}.worker.js`;
  if (existsSync(pathOf(folder, starter)))
    writeFileSync(join(DIST, `${name}.worker.js`), ownStarter(read(starter), `${built}.mjs`));
}
writeLicenses(DIST, 'wasm');
