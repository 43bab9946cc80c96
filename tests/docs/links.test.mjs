// Links of the documents on the site.

import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { build } from 'vitepress';
import { relinked, slugOf } from '../../scripts/docs/links.mjs';
import { REPOSITORY, stagePages } from '../../scripts/docs/stage.mjs';
import { BUILD } from '../../scripts/lib/paths.mjs';

const places = {
  'wasm/README.md': 'javascript.md',
  'docs/cpp.md': 'cpp.md',
  'core/include': `${REPOSITORY}/tree/main/core/include`,
};
const link = (text, file = 'docs/python.md', place = 'python.md') =>
  relinked(text, file, place, (path) => places[path]);

test('links lead to pages of the site, with their anchors, or to the repository', () => {
  assert.equal(link('[a](../wasm/README.md#gltf)'), '[a](./javascript.md#gltf)');
  assert.equal(link('[a](cpp.md)'), '[a](./cpp.md)');
  assert.equal(link('[a](../core/include/)'), `[a](${REPOSITORY}/tree/main/core/include)`);
  assert.equal(link('[a](../cpp.md)', 'docs/decisions/x.md', 'decisions/x.md'), '[a](../cpp.md)');
});

test('addresses, anchors of the page itself and code stay as they are', () => {
  for (const text of ['[a](https://a.b/c.md)', '[a](#b)', '`[a](b.md)`', '```js\n[a](b.md)\n```\n'])
    assert.equal(link(text), text);
});

test('a picture for dark pages follows the switch of the site', () => {
  const text = `<picture>
  <source media="(prefers-color-scheme: dark)" srcset="https://a/dark.webp">
  <img src="https://a/light.webp" alt="A cow">
</picture>`;
  assert.equal(
    link(text),
    '<img class="if-light" src="https://a/light.webp" alt="A cow"><img class="if-dark" src="https://a/dark.webp" alt="A cow">',
  );
});

test('anchors are those of GitHub', () => {
  assert.equal(slugOf('three.js'), 'threejs');
  assert.equal(slugOf('xatlas in C++'), 'xatlas-in-c');
  assert.equal(slugOf('Which t?'), 'which-t');
});

/** A folder inside the repository, so that packages are found. */
function inFolder(work) {
  mkdirSync(join(BUILD, 'tests'), { recursive: true });
  const folder = mkdtempSync(join(BUILD, 'tests/links-'));
  return Promise.resolve(work(folder)).finally(() => rmSync(folder, { recursive: true }));
}

const groupsOf = (file) => [{ pages: [{ file, place: 'a.md', title: 'A' }] }];

test('pages and their pictures are put into one folder', () =>
  inFolder((root) => {
    writeFileSync(join(root, 'a.md'), '# A\n\n![b](b.webp)\n');
    writeFileSync(join(root, 'b.webp'), 'picture');
    const site = join(root, 'site');
    stagePages(groupsOf('a.md'), site, root);
    assert.equal(readFileSync(join(site, 'a.md'), 'utf8'), '# A\n\n![b](./pictures/b.webp)\n');
    assert.equal(readFileSync(join(site, 'pictures/b.webp'), 'utf8'), 'picture');
  }));

test('a link to nothing is named', () =>
  inFolder((root) => {
    writeFileSync(join(root, 'a.md'), '# A\n\n[b](missing.md)\n');
    assert.throws(() => stagePages(groupsOf('a.md'), join(root, 'site'), root), {
      message: 'a.md links to missing.md, which does not exist.',
    });
  }));

test('VitePress ends with an error at a link that leads nowhere', () =>
  inFolder(async (root) => {
    writeFileSync(join(root, 'index.md'), '# A\n\n[b](./missing.md)\n');
    await assert.rejects(
      build(root, { outDir: join(root, 'site'), logLevel: 'silent' }),
      /dead link/,
    );
  }));
