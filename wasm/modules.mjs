// The WebAssembly modules of build/wasm* and their scripts, under the names they have in the
// package.

import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { transformSync } from 'esbuild';
import { orderOfLike } from './function-order.mjs';
import { reordered } from './module-code.mjs';

const BUILD = join(dirname(fileURLToPath(import.meta.url)), '../build');
/**
 * For every build in src/builds.ts: folder below build/, base name there, and base name in dist/.
 */
const MODULES = {
  simd: { folder: 'wasm', built: 'abflat', name: 'abflat-simd' },
  threads: { folder: 'wasm-threads', built: 'abflat-threads', name: 'abflat-threads' },
};
export const BUILDS = Object.keys(MODULES);

/** Modules of their own, the same for all builds: they need no threads. */
const LATE = ['pack', 'bake'].map((label) => {
  const name = `abflat-${label}`;
  return { folder: MODULES.simd.folder, built: name, name, label };
});

/** Base names in dist/. */
export const NAMES = [...Object.values(MODULES), ...LATE].map(({ name }) => name);

const pathOf = ({ folder, built }, ending) => join(BUILD, folder, `${built}${ending}`);

/** A file that is missing for `builds`, if any. */
export const missingModule = (builds) =>
  [...builds.map((build) => MODULES[build]), ...LATE]
    .flatMap((module) => ['.mjs', '.wasm'].map((ending) => pathOf(module, ending)))
    .find((path) => !existsSync(path));

/**
 * Adds a section "abflat.build" to the module that says which build or other module it is; all lengths
 * fit in one byte.
 */
function labelled(bytes, build) {
  const name = Buffer.from('abflat.build');
  const content = Buffer.concat([Buffer.from([name.length]), name, Buffer.from(build)]);
  return Buffer.concat([bytes, Buffer.from([0, content.length]), content]);
}

/**
 * Tells bundlers that this is the address of a script that stays as it is, not a module of theirs.
 */
const IGNORED = '/* webpackIgnore: true */ /* turbopackIgnore: true */ /* @vite-ignore */';

/**
 * The script that a thread starts with, changed so that bundlers leave its import alone and so that
 * a thread that cannot start causes an error of its worker, which ends the run; an unhandled
 * rejection would go unnoticed. The engine always says which script to load, so there is no
 * fallback.
 */
function ownStarter(text, file) {
  const found = text.match(
    /\(e\.data\.urlOrBlob\s*\?\s*import\(e\.data\.urlOrBlob\)\s*:\s*import\((['"])\.\/(\S+?)\1\)\)(\.then\(.*?Module\s*=\s*instance;?\s*\}\))/s,
  );
  if (found?.[2] !== file) {
    throw new Error(`The script that starts a thread should import ${file}, and does not.`);
  }
  const load = `import(${IGNORED} e.data.urlOrBlob)${found[3]}`;
  const tell = '.catch((error) => setTimeout(() => { throw error; }))';
  return text.replace(found[0], load + tell);
}

/** How Emscripten's script would read a file. */
const READING = ['read_', 'readBinary', 'readAsync', 'setWindowTitle'];
/** Functions with which it would fetch the module, and what they alone call. */
const FETCHING = [
  'getBinary',
  'getBinaryPromise',
  'instantiateArrayBuffer',
  'instantiateAsync',
  'receiveInstantiationResult',
];

/** The text without what begins with `start` and ends with the bracket that closes its first one. */
function without(text, start, [open, close]) {
  const begin = text.indexOf(start);
  if (begin < 0) return text;
  let depth = 0;
  for (let i = text.indexOf(open, begin + start.length - 1); i < text.length; ++i) {
    if (text[i] === open) ++depth;
    if (text[i] === close && --depth === 0) return text.slice(0, begin) + text.slice(i + 1);
  }
  throw new Error(`Emscripten's script does not end what begins with "${start}".`);
}

/** Emscripten's script without what fetches the module: the engine always instantiates it. */
function withoutFetching(text) {
  const call = 'instantiateAsync().catch(readyPromiseReject);';
  if (!text.includes(call)) return text;
  const bare = FETCHING.reduce(
    (rest, name) => without(rest, `function ${name}(`, '{}'),
    text.replace(call, ''),
  );
  return READING.reduce((rest, name) => without(rest, `${name}=(`, '()'), bare);
}

/**
 * Emscripten's script, minified: its names mean nothing, while ours stay readable. The engine
 * instantiates the module itself, so bundlers need not find one here. Newer releases of Emscripten
 * start threads from this script, by its name.
 */
function ownScript(text, built, name) {
  const address = new RegExp(
    `new URL\\((['"])${built}\\.wasm\\1,\\s*import\\.meta\\.url\\)\\.(toString\\(\\)|href)`,
  );
  const own = withoutFetching(text).replace(address, "''").replaceAll(`${built}.mjs`, `${name}.js`);
  return transformSync(own, { minify: true }).code;
}

/**
 * Puts the modules of `builds` into `dist`. The first one stands in for missing ones, under their
 * names: a module says which build it is, so a caller that wants another is told so and takes the
 * next.
 */
export function placeModules(dist, builds = BUILDS) {
  for (const [wanted, { name }] of Object.entries(MODULES)) {
    const build = builds.includes(wanted) ? wanted : builds[0];
    place(dist, MODULES[build], { label: build, name });
  }
  for (const late of LATE) place(dist, late, late);
}

function place(dist, module, { label, name }) {
  const read = (ending) => readFileSync(pathOf(module, ending), 'utf8');
  const built = readFileSync(pathOf(module, '.wasm'));
  const wasm = reordered(built, orderOfLike(built));
  writeFileSync(join(dist, `${name}.wasm`), labelled(wasm, label));
  // Not .mjs, which some servers send without a content type.
  writeFileSync(join(dist, `${name}.js`), ownScript(read('.mjs'), module.built, name));
  // The script that a thread starts with; newer releases of Emscripten have it in the module's
  // script.
  if (existsSync(pathOf(module, '.worker.js')))
    writeFileSync(
      join(dist, `${name}.worker.js`),
      ownStarter(read('.worker.js'), `${module.built}.mjs`),
    );
}
