// What a product contains, as a CycloneDX bill of materials: the same list as the licences.

import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { machine } from 'node:os';
import { join } from 'node:path';
import { contentsOf } from './licenses.mjs';
import { ROOT } from './paths.mjs';
import { Failure } from './run.mjs';

const PREFIXES = ['/usr/local', '/usr', '/opt/homebrew'];
const MACHINE = machine();

/** `files`: where CMake looks for the version, below a prefix. */
const LIBRARIES = {
  eigen: {
    license: 'MPL-2.0',
    files: ['share/eigen3/cmake/Eigen3ConfigVersion.cmake'],
  },
  fast_float: {
    license: 'MIT',
    files: ['lib', 'share'].map((place) => `${place}/cmake/FastFloat/FastFloatConfigVersion.cmake`),
  },
  'nlohmann-json': {
    license: 'MIT',
    files: ['share/cmake/nlohmann_json/nlohmann_jsonConfigVersion.cmake'],
  },
  draco: {
    license: 'Apache-2.0',
    versionOf: () => versionInHeader('draco/core/draco_version.h', /kDracoVersion\[\] = "([^"]+)"/),
  },
  // The number 180 means 0.18.
  meshoptimizer: {
    license: 'MIT',
    versionOf: () =>
      versionInHeader('meshoptimizer.h', /MESHOPTIMIZER_VERSION (\d+)/)?.replace(
        /^(\d*)(\d\d)\d$/,
        (_, major, minor) => `${major || 0}.${Number(minor)}`,
      ),
  },
  zlib: { license: 'Zlib', versionOf: () => versionInHeader('zlib.h', /ZLIB_VERSION "([^"]+)"/) },
  libpng: { license: 'libpng-2.0', versionOf: () => versionForLinking('libpng') },
  'libjpeg-turbo': {
    license: 'IJG AND BSD-3-Clause AND Zlib',
    versionOf: () => versionForLinking('libturbojpeg'),
  },
  libwebp: { license: 'BSD-3-Clause', versionOf: () => versionForLinking('libwebp') },
  pybind11: {
    license: 'BSD-3-Clause',
    files: ['lib', 'share'].map((place) => `${place}/cmake/pybind11/pybind11ConfigVersion.cmake`),
  },
  cli11: { license: 'BSD-3-Clause', files: ['share/cmake/CLI11/CLI11ConfigVersion.cmake'] },
  // Part of three.js, which has its own copy.
  basis_universal: {
    license: 'Apache-2.0 AND BSD-3-Clause',
    versionOf: () => `three-${packageOf('node_modules/three').version}`,
  },
  emscripten: { license: 'MIT', versionOf: emscriptenVersion },
  // Parts of Emscripten, which has its own copies.
  musl: { license: 'MIT', versionOf: () => `emscripten-${emscriptenVersion()}` },
  'llvm-runtimes': {
    license: 'Apache-2.0 WITH LLVM-exception',
    versionOf: () => `emscripten-${emscriptenVersion()}`,
  },
};

function emscriptenVersion() {
  const { stdout } = spawnSync('emcc', ['--version'], { encoding: 'utf8' });
  return stdout?.match(/^emcc .*?(\d+\.\d+\.\d+)/)?.[1];
}

function versionIn(files) {
  const paths = PREFIXES.flatMap((prefix) => files.map((file) => join(prefix, file)));
  const found = paths.find((path) => existsSync(path));
  return found && readFileSync(found, 'utf8').match(/set\(PACKAGE_VERSION "([^"]+)"\)/)?.[1];
}

function versionInHeader(file, pattern) {
  const found = PREFIXES.map((prefix) => join(prefix, 'include', file)).find((path) =>
    existsSync(path),
  );
  return found && readFileSync(found, 'utf8').match(pattern)?.[1];
}

/** The version that pkg-config would tell. */
function versionForLinking(name) {
  const folders = PREFIXES.flatMap((prefix) =>
    ['lib', 'lib64', `lib/${MACHINE}-linux-gnu`].map((place) => join(prefix, place, 'pkgconfig')),
  );
  const found = folders.map((folder) => join(folder, `${name}.pc`)).find(existsSync);
  return found && readFileSync(found, 'utf8').match(/^Version: *(\S+)/m)?.[1];
}

function libraryOf(entry) {
  const { license, files, versionOf = () => versionIn(files) } = LIBRARIES[entry];
  const version = versionOf();
  if (!version) throw new Failure(`The version of ${entry} cannot be found; is it installed?`);
  const [, url] = readFileSync(join(ROOT, `scripts/licenses/${entry}.txt`), 'utf8').split('\n');
  return { name: entry, version, license, url, purl: `pkg:generic/${entry}@${version}` };
}

function packageOf(folder) {
  const json = JSON.parse(readFileSync(join(ROOT, folder, 'package.json'), 'utf8'));
  const { name, version, license, homepage = `https://www.npmjs.com/package/${name}` } = json;
  const purl = `pkg:npm/${name.replace('@', '%40')}@${version}`;
  return { name, version, license, url: homepage, purl };
}

const LIBRARY_PRODUCTS = ['python', 'wasm'];

/** `product`: native, python, wasm or web. The same contents give the same bytes. */
export function billOfMaterials(product) {
  const { version } = JSON.parse(readFileSync(join(ROOT, 'wasm/package.json'), 'utf8'));
  const components = contentsOf(product)
    .map((entry) => (entry.startsWith('node_modules/') ? packageOf(entry) : libraryOf(entry)))
    .map(({ name, version, license, url, purl }) => ({
      type: 'library',
      'bom-ref': purl,
      name,
      version,
      licenses: [{ expression: license }],
      purl,
      externalReferences: [{ type: 'website', url }],
    }));
  return {
    bomFormat: 'CycloneDX',
    specVersion: '1.5',
    version: 1,
    metadata: {
      component: {
        type: LIBRARY_PRODUCTS.includes(product) ? 'library' : 'application',
        'bom-ref': `abflat-${product}`,
        name: `abflat-${product}`,
        version,
        licenses: [{ expression: 'MIT' }],
      },
    },
    components,
  };
}
