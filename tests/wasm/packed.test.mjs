// The package as npm packs it: what tools that check packages say, and what who installs it gets.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { checkPackage, createPackageFromTarballData } from '@arethetypeswrong/core';
import { publint } from 'publint';
import { packPackage } from './support/pack.mjs';

/** Files that are loaded by their address, not imported. */
const NOT_IMPORTED = [/\.wasm$/, './worker.js'];

let folder;
let packed;

/** What a program prints; fails if the program does. */
function run(command, args, cwd) {
  const { status, stdout, stderr } = spawnSync(command, args, { cwd, encoding: 'utf8' });
  assert.equal(status, 0, `${command} ${args.join(' ')}\n${stdout}\n${stderr}`);
  return stdout;
}

before(() => {
  folder = mkdtempSync(join(tmpdir(), 'abflat-packed-'));
  packed = packPackage(folder);
});
after(() => rmSync(folder, { recursive: true, force: true }));

test('npm pack contains the licences, the changes, an example and no sources', () => {
  const { files } = packed;
  for (const name of [
    'package.json',
    'README.md',
    'LICENSE',
    'CHANGELOG.md',
    'examples/unwrap.mjs',
    // For tools that do not read "exports".
    ...['gltf', 'simd', 'single', 'sync', 'threads', 'three', 'watlas'].map(
      (name) => `${name}/package.json`,
    ),
    'dist/index.d.ts',
    ...['abflat-simd', 'abflat-threads', 'abflat-pack', 'abflat-bake'].map(
      (name) => `dist/${name}.wasm`,
    ),
  ]) {
    assert.ok(files.includes(name), name);
  }
  for (const name of ['dist/LICENSE.txt', 'dist/THIRD_PARTY_LICENSES.txt']) {
    assert.ok(files.includes(name), name);
  }
  assert.deepEqual(
    files.filter(
      (path) =>
        !/^(dist\/|examples\/|(((gltf|simd|single|sync|threads|three|watlas)\/)?package\.json|README\.md|LICENSE|CHANGELOG\.md)$)/.test(
          path,
        ),
    ),
    [],
  );
  // They are beside package.json only while it is packed.
  assert.deepEqual(packed.left, []);
});

test('publint finds nothing, not even a suggestion', async () => {
  const bytes = new Uint8Array(readFileSync(packed.tarball));
  const { messages } = await publint({ pack: { tarball: bytes.buffer }, strict: true });
  assert.deepEqual(messages, []);
});

test('types and modules are found however they are resolved', async () => {
  const archive = createPackageFromTarballData(new Uint8Array(readFileSync(packed.tarball)));
  const { entrypoints, problems } = await checkPackage(archive, {
    excludeEntrypoints: NOT_IMPORTED,
  });
  assert.deepEqual(Object.keys(entrypoints).sort(), [
    ...['.', './gltf', './package.json', './simd', './single', './sync', './threads', './three'],
    './watlas',
  ]);
  // CommonJS requires the ES modules; places.test.mjs checks what older releases of Node say.
  const others = problems.filter(({ kind }) => kind !== 'CJSResolvesToESM');
  assert.deepEqual(others, []);
});

test('installed without anything else, it unwraps', () => {
  const project = join(folder, 'project');
  mkdirSync(project);
  writeFileSync(join(project, 'package.json'), '{ "private": true }');
  // It depends on nothing, so no registry is asked.
  run('npm', ['install', '--offline', '--no-audit', '--no-fund', packed.tarball], project);
  const { packages } = JSON.parse(readFileSync(join(project, 'package-lock.json'), 'utf8'));
  assert.deepEqual(Object.keys(packages), ['', 'node_modules/abflat']);
  const code = `
    import { createAbflat } from 'abflat';
    import { unwrap } from 'abflat/gltf';
    import { createAbflatSync } from 'abflat/sync';
    import { Atlas, Initialize } from 'abflat/watlas';
    const abflat = await createAbflat();
    const { report } = await abflat.unwrap(await abflat.sample('head'));
    console.log(report.valid, typeof unwrap);
    abflat.terminate();
    const inThread = await createAbflatSync();
    console.log(inThread.unwrap(inThread.sample('hemisphere')).report.valid);
    await Initialize();
    console.log(new Atlas().meshCount);
  `;
  writeFileSync(join(project, 'main.mjs'), code);
  assert.equal(run(process.execPath, ['main.mjs'], project), 'true function\ntrue\n0\n');
});
