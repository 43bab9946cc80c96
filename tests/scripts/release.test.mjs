// What must be right in every release.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { thirdPartyLicenses } from '../../scripts/lib/licenses.mjs';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { isVersion, openVersion, PLACES, versionsIn } from '../../scripts/lib/version.mjs';

/** Compares versions number by number. */
const isNewer = (a, b) => a.localeCompare(b, 'en', { numeric: true }) > 0;

const read = (path) => readFileSync(join(ROOT, path), 'utf8');

const versionOf = (file) => read(file).match(PLACES[file])?.[0];

test('every file that names the version names that of C++, wherever it does', () => {
  const version = versionOf('core/include/abflat/version.h');
  assert.ok(isVersion(version), version);
  for (const [file, place] of Object.entries(PLACES)) {
    const named = read(file).match(place) ?? [];
    assert.ok(named.length > 0 && named.every((each) => each === version), `${file}: ${named}`);
  }
  assert.equal(JSON.parse(read('wasm/package.json')).version, version);
  assert.equal(JSON.parse(read('package-lock.json')).packages.wasm.version, version);
});

test('the changelog has each version once, newest first, with its date', () => {
  const changes = read('CHANGELOG.md');
  const versions = versionsIn(changes);
  assert.equal(versions.length, changes.match(/^## /gm).length, 'every heading is a version');
  assert.equal(versions[0].version, versionOf('core/include/abflat/version.h'));
  for (const [i, { version, released }] of versions.entries()) {
    if (i > 0 || released) assert.match(released ?? '', /^\d{4}-\d\d-\d\d$/, version);
    if (i > 0) assert.ok(isNewer(versions[i - 1].version, version), `${version} is out of order`);
  }
});

test('a version is opened above the last release, and renamed until it is released', () => {
  const released = '# Changelog\n\n## 0.1.0 - 2030-01-31\n\n* Something.\n';
  const opened = openVersion(released, '0.2.0');
  assert.deepEqual(versionsIn(opened), [
    { version: '0.2.0', released: undefined },
    { version: '0.1.0', released: '2030-01-31' },
  ]);
  assert.equal(openVersion(opened, '1.0.0'), opened.replace('0.2.0', '1.0.0'));
  assert.equal(opened.replace('## 0.2.0 (unreleased)\n\n', ''), released);
});

test('every product carries the licences of what is in it', () => {
  for (const [product, others] of [
    ['native', ['fast_float', 'JSON for Modern C++', 'CLI11', 'Draco', 'meshopt', 'zlib']],
    ['python', ['fast_float', 'pybind11']],
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
