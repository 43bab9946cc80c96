// The compressed copies of the page's files.

import assert from 'node:assert/strict';
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { brotliDecompressSync, gunzipSync } from 'node:zlib';
import { compressFolder } from '../../web/scripts/compress.mjs';

const TEXT = 'export const same = 1;\n'.repeat(50);

let folder;
let site;
let kept;

before(() => {
  folder = mkdtempSync(join(tmpdir(), 'abflat-compress-'));
  site = join(folder, 'site');
  kept = join(folder, 'kept');
  mkdirSync(join(site, 'assets'), { recursive: true });
  writeFileSync(join(site, 'index.html'), TEXT);
  writeFileSync(join(site, 'assets/a.js'), TEXT);
  writeFileSync(join(site, 'tiny.json'), '{}');
  writeFileSync(join(site, 'icon.png'), TEXT);
});
after(() => rmSync(folder, { recursive: true }));

test('there are copies where they are smaller, with the same content', async () => {
  await compressFolder(site, kept);
  for (const name of ['index.html', 'assets/a.js']) {
    const path = join(site, name);
    assert.equal(brotliDecompressSync(readFileSync(`${path}.br`)).toString(), TEXT);
    assert.equal(gunzipSync(readFileSync(`${path}.gz`)).toString(), TEXT);
  }
  for (const name of ['tiny.json', 'icon.png'])
    for (const ending of ['.br', '.gz']) assert.ok(!existsSync(join(site, name + ending)), name);
});

test('what has not changed is not compressed again, and copies of earlier builds go', async () => {
  const before = readdirSync(kept);
  for (const name of before) writeFileSync(join(kept, name), 'kept');
  await compressFolder(site, kept);
  assert.equal(readFileSync(join(site, 'index.html.br'), 'utf8'), 'kept');
  writeFileSync(join(site, 'index.html'), `${TEXT}//`);
  writeFileSync(join(site, 'assets/a.js'), `${TEXT}//`);
  await compressFolder(site, kept);
  assert.equal(
    brotliDecompressSync(readFileSync(join(site, 'index.html.br'))).toString(),
    `${TEXT}//`,
  );
  const after = readdirSync(kept);
  assert.equal(after.length, before.length);
  assert.notDeepEqual(after, before);
});
