// What was open is there again after a reload, and a link holds settings.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { addMesh, emptyDocument, io, primitiveOf } from '../support/gltf.mjs';
import { grid } from '../support/small-meshes.mjs';
import { objText, sphere, together, torus } from '../support/surfaces.mjs';
import {
  dropAndWait,
  exportMesh,
  kept,
  openPage,
  openSample,
  reload,
  sampleOf,
  settled,
  textOf,
} from './page.mjs';

const BOTH = objText(
  together([
    [torus(16, 8), [0, 0, 0]],
    [sphere(6), [3, 0, 0]],
  ]),
);

const bytes = async (page) => readFileSync((await exportMesh(page)).path);

const fragment = (page) => page.evaluate(() => location.hash);

/** By its id, even where another control covers it. */
const press = (page, id) => page.evaluate((id) => document.querySelector(id).click(), id);

test('edited seams, a lock, a moved island and options come back bit by bit, twice', async (t) => {
  const page = await openPage(t, { own: true, open: ['both.obj', BOTH] });
  await page.fill('#padding', '9');
  await settled(page);
  await page.click('#details-toggle');
  await page.setInputFiles('#seams-file', {
    name: 'own.txt',
    mimeType: 'text/plain',
    buffer: Buffer.from('1 2\n2 3\n'),
  });
  await settled(page);
  assert.match(await textOf(page, '#seams-state'), /^seams edited: 2 edges/);
  await page.locator('.lock').first().click();
  await page.locator('#charts tbody tr').last().click();
  await page.focus('#layout-canvas');
  for (const key of ['g', 'ArrowRight', 'Shift+ArrowUp', 'Enter']) await page.keyboard.press(key);
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /^Moved island \d+, checked in /);
  const before = await bytes(page);
  for (let i = 0; i < 2; i++) {
    await reload(page);
    assert.equal(await textOf(page, '#run-text'), 'Restored both.obj from your last visit');
    assert.equal(await textOf(page, '#source'), 'both.obj');
    assert.equal(await page.inputValue('#padding'), '9');
    assert.match(await textOf(page, '#seams-state'), /^seams edited: 2 edges/);
    assert.equal(await page.locator('.lock[aria-pressed="true"]').count(), 1);
    assert.ok(before.equals(await bytes(page)), 'the same file');
    assert.ok(await page.isDisabled('#undo'));
  }
  // Another mesh replaces it, and starts with seams of its own.
  await dropAndWait(page, 'next.obj', grid(4));
  const next = await bytes(page);
  await reload(page);
  assert.equal(await textOf(page, '#run-text'), 'Restored next.obj from your last visit');
  assert.ok(next.equals(await bytes(page)));
});

test('a glTF comes back with its companions, and so do samples and flattened disks', async (t) => {
  const page = await openPage(t, { own: true });
  const document = emptyDocument();
  addMesh(document, 'ball', primitiveOf(document, sphere(5)));
  const { json, resources } = await io.writeJSON(document);
  const [buffer] = json.buffers;
  const companion = Buffer.from(resources[buffer.uri]);
  buffer.uri = 'ball.bin';
  await dropAndWait(page, 'ball.gltf', JSON.stringify(json), { 'ball.bin': companion });
  assert.equal(await textOf(page, '#alert'), '');
  await page.click('#details-toggle');
  await page.locator('.lock').first().click();
  const before = await bytes(page);
  await reload(page);
  assert.equal(await textOf(page, '#run-text'), 'Restored ball.gltf from your last visit');
  assert.ok(before.equals(await bytes(page)), 'the same file');

  await openSample(page, 'hemisphere');
  await press(page, '#mode-flatten');
  await settled(page);
  await page.fill('#t-number', '1.25');
  await settled(page);
  const flat = await bytes(page);
  await reload(page);
  assert.equal(await sampleOf(page), 'hemisphere');
  assert.equal(await textOf(page, '#run-text'), 'Restored Hemisphere from your last visit');
  assert.equal(await fragment(page), '#flatten&t=1.25');
  assert.ok(flat.equals(await bytes(page)), 'the same file');

  // What a first visit shows is nothing to restore.
  await press(page, '#mode-unwrap');
  await settled(page);
  await openSample(page, 'head');
  await reload(page);
  assert.equal(await sampleOf(page), 'head');
  assert.match(await textOf(page, '#run-text'), /^Unwrapped in /);
});

const mark = (page) => page.evaluate(() => localStorage.getItem('abflat-visit'));

/** Replaces a value of what is kept. */
const spoil = (page, name, value) =>
  page.evaluate(
    ([name, value]) =>
      new Promise((done) => {
        const opening = indexedDB.open('abflat', 1);
        opening.onsuccess = () => {
          const transaction = opening.result.transaction('visit', 'readwrite');
          transaction.objectStore('visit').put(value, name);
          transaction.oncomplete = () => {
            opening.result.close();
            done();
          };
        };
      }),
    [name, value],
  );

test('what cannot be restored is dropped, and said once', async (t) => {
  const page = await openPage(t, { own: true, open: ['waves.obj', grid(4)] });
  const showsSample = async (notice) => {
    await reload(page);
    assert.equal(await sampleOf(page), 'head');
    assert.match(await textOf(page, '#notice'), notice);
    await reload(page);
    assert.equal(await textOf(page, '#notice'), '');
    assert.equal(await mark(page), null);
    await dropAndWait(page, 'waves.obj', grid(4));
    await kept(page);
  };
  await kept(page);
  await spoil(page, 'asked', { text: 5 });
  await showsSample(/^Your last visit could not be restored\./);
  const edited = { seams: 'none', seamEdges: 'none' };
  await spoil(page, 'asked', { text: '', edited });
  await showsSample(/^waves\.obj could not be restored from your last visit: .*\./);
  // As a crash leaves it.
  await page.evaluate(() => localStorage.setItem('abflat-visit', 'restoring'));
  await showsSample(/was not reopened, because the page stopped while opening it\./);
  assert.equal(await mark(page), 'kept');
});

test('a mesh that is too large is not kept, which the next visit says', async (t) => {
  const page = await openPage(t, {
    prepare: (page) =>
      page.addInitScript(() => {
        const { get } = Object.getOwnPropertyDescriptor(Blob.prototype, 'size');
        Object.defineProperty(File.prototype, 'size', {
          get() {
            return this.name === 'large.png' ? 4e8 : get.call(this);
          },
        });
      }),
  });
  await dropAndWait(page, 'waves.obj', grid(4), { 'large.png': 'x' });
  await page.reload();
  await settled(page);
  assert.equal(await sampleOf(page), 'head');
  assert.match(await textOf(page, '#notice'), /too large to keep\. Open it again\./);
});

test('the page works where nothing can be kept', async (t) => {
  const page = await openPage(t, {
    open: ['waves.obj', grid(4)],
    prepare: (page) =>
      page.addInitScript(() => {
        IDBFactory.prototype.open = () => {
          throw new DOMException('refused', 'SecurityError');
        };
      }),
  });
  assert.equal(await textOf(page, '#badge'), 'Valid');
  await page.reload();
  await settled(page);
  assert.equal(await sampleOf(page), 'head');
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#notice'), '');
});

test('a link to a mesh comes first, and leaves what is kept if it is not followed', async (t) => {
  const page = await openPage(t, { own: true, open: ['waves.obj', grid(4)] });
  await kept(page);
  const own = page.url();
  await page.goto(`${own}?url=https://models.example/a.obj`);
  await page.locator('dialog.question').waitFor();
  await page.keyboard.press('Escape');
  await settled(page);
  assert.equal(await sampleOf(page), 'head');
  await kept(page);
  await page.goto(own);
  await settled(page);
  assert.equal(await textOf(page, '#source'), 'waves.obj');
});

test('a link has settings, which hold for the meshes opened next', async (t) => {
  const page = await openPage(t, { own: true });
  const own = page.url();
  const text = '#unwrap&resolution=2048&seams=auto,sharp=45';
  await page.goto(`about:blank`);
  await page.goto(`${own}${text}&max-stretch=0.5&foo`);
  await settled(page);
  const shown = async () => {
    assert.equal(await page.inputValue('#resolution'), '2048');
    assert.equal(await page.getAttribute('#seams-sharp', 'aria-pressed'), 'true');
    assert.equal(await page.inputValue('#sharp-degrees'), '45');
    assert.equal(await fragment(page), text);
  };
  await shown();
  assert.match(
    await textOf(page, '#notice'),
    /^The link asks for max-stretch=0\.5, foo, which this page does not offer\./,
  );
  await dropAndWait(page, 'both.obj', BOTH);
  await shown();
  // They win over what is kept.
  await kept(page);
  const entries = await page.evaluate(() => history.length);
  await page.goto('about:blank');
  await page.goto(`${own}#unwrap&padding=7`);
  await settled(page);
  assert.equal(await textOf(page, '#source'), 'both.obj');
  assert.equal(await page.inputValue('#padding'), '7');
  assert.equal(await page.inputValue('#resolution'), '1024');
  // In an open page as well; undo leads back.
  await page.evaluate(() => {
    location.hash = '#unwrap&padding=3';
  });
  await page.waitForFunction(
    () => document.querySelector('#padding').value === '3' && !document.body.ariaBusy,
  );
  await page.click('#undo');
  await settled(page);
  assert.equal(await page.inputValue('#padding'), '7');
  assert.equal(await fragment(page), '#unwrap&padding=7');
  await page.selectOption('#resolution', '512');
  await settled(page);
  assert.equal(await fragment(page), '#unwrap&resolution=512&padding=7');
  assert.ok((await page.evaluate(() => history.length)) <= entries + 3, 'no entries of its own');
});
