// The licences of everything that ships beside abflat's own code, as one text.

import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from './paths.mjs';

const FOLDER = join(ROOT, 'scripts/licenses');

/**
 * What each product contains. Names with a slash are npm packages, with their own LICENSE or, if
 * they come without one, the one in FOLDER.
 */
const WASM = ['eigen', 'emscripten', 'musl', 'llvm-runtimes'];
const CONTENTS = {
  native: [
    'eigen',
    'fast_float',
    'nlohmann-json',
    'cli11',
    'draco',
    'meshoptimizer',
    'zlib',
    'libpng',
    'libjpeg-turbo',
    'libwebp',
  ],
  python: ['eigen', 'fast_float', 'pybind11'],
  wasm: [...WASM, 'node_modules/fflate'],
  web: [
    ...WASM,
    'node_modules/three',
    'basis_universal',
    'node_modules/three-mesh-bvh',
    'node_modules/comlink',
    'node_modules/@gltf-transform/core',
    'node_modules/@gltf-transform/extensions',
    'node_modules/property-graph',
    'node_modules/ktx-parse',
    'node_modules/draco3d',
    'node_modules/meshoptimizer',
    'node_modules/fflate',
  ],
};

export const PRODUCTS = Object.keys(CONTENTS);

/** Names of files in scripts/licenses, and folders of npm packages. */
export const contentsOf = (product) => CONTENTS[product];

function licenseText(entry) {
  if (!entry.startsWith('node_modules/')) return readFileSync(join(FOLDER, `${entry}.txt`), 'utf8');
  const folder = join(ROOT, entry);
  const json = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const { name, version, homepage = `https://www.npmjs.com/package/${name}` } = json;
  const file = readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
  const path = file ? join(folder, file) : join(FOLDER, `${name}.txt`);
  return `${name} ${version}\n${homepage}\n\n${readFileSync(path, 'utf8')}`;
}

export const thirdPartyLicenses = (product) => licensesOf(CONTENTS[product]);

/** The licences of these entries, which are as in CONTENTS. */
export function licensesOf(entries) {
  const head = `abflat is distributed under the MIT License (see LICENSE). It contains the following software.\n`;
  const rule = `\n${'-'.repeat(80)}\n\n`;
  return [head, ...entries.map((entry) => `${licenseText(entry).trimEnd()}\n`)].join(rule);
}

/** Writes LICENSE and THIRD_PARTY_LICENSES.txt of `product` (native, python, wasm or web) into a folder. */
export function writeLicenses(folder, product) {
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'LICENSE.txt'), readFileSync(join(ROOT, 'LICENSE'), 'utf8'));
  writeFileSync(join(folder, 'THIRD_PARTY_LICENSES.txt'), thirdPartyLicenses(product));
}
