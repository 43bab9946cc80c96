// What must be right in every release.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { thirdPartyLicenses } from '../../scripts/lib/licenses.mjs';
import { ROOT } from '../../scripts/lib/paths.mjs';

const read = (path) => readFileSync(join(ROOT, path), 'utf8');

test('the version is the same for C++, npm and vcpkg', () => {
  const header = read('core/include/abflat/version.h').match(/ABFLAT_VERSION "(\S+)"/)?.[1];
  assert.equal(JSON.parse(read('wasm/package.json')).version, header);
  assert.equal(JSON.parse(read('packaging/vcpkg/vcpkg.json'))['version-semver'], header);
});

test('every product carries the licences of what is in it', () => {
  for (const [product, others] of [
    ['native', ['fast_float', 'JSON for Modern C++', 'CLI11', 'Draco', 'meshopt', 'zlib']],
    ['wasm', ['Emscripten', 'musl libc']],
    ['web', ['Emscripten', 'musl libc', 'three ']],
  ]) {
    const text = thirdPartyLicenses(product);
    for (const name of ['Eigen', ...others]) {
      assert.match(
        text,
        new RegExp(`^${name.replaceAll('+', '\\+')}`, 'm'),
        `${name} in ${product}`,
      );
    }
  }
  assert.match(thirdPartyLicenses('native'), /Mozilla Public License Version 2\.0/);
});

test('npm dependencies of what ships are among the collected licences', () => {
  const web = JSON.parse(read('web/package.json'));
  const wasm = JSON.parse(read('wasm/package.json'));
  const shipped = Object.keys({ ...web.dependencies, ...wasm.dependencies });
  const text = thirdPartyLicenses('web');
  for (const name of shipped.filter((each) => each !== wasm.name)) {
    assert.match(text, new RegExp(`^${name} \\d`, 'm'), `licence of ${name}`);
  }
});
