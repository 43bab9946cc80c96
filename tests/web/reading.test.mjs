// Meshes that take long to read: what the user does in the meantime is neither lost nor applied to
// the previous mesh.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { grid } from '../support/small-meshes.mjs';
import { objText, sphere } from '../support/surfaces.mjs';
import {
  drop,
  dropAndWait,
  exportMesh,
  metrics,
  openPage,
  pathOf,
  sampleOf,
  settled,
  textOf,
} from './page.mjs';

/** Files whose name begins with "slow" are read when `release` is called. */
const withSlowFiles = (page) =>
  page.addInitScript(() => {
    const gate = new Promise((resolve) => {
      window.release = resolve;
    });
    window.slowReads = 0;
    for (const method of ['arrayBuffer', 'text']) {
      const read = Blob.prototype[method];
      Blob.prototype[method] = async function () {
        if (this.name?.startsWith('slow')) {
          window.slowReads += 1;
          await gate;
        }
        return read.call(this);
      };
    }
  });

const openSlow = (t) => openPage(t, { prepare: withSlowFiles, mode: 'flatten' });

async function beginReading(page, name, content) {
  await drop(page, name, content);
  await page.waitForFunction(() => window.slowReads > 0);
}

const release = (page) => page.evaluate(() => window.release());

/**
 * Waits until every timer of the page that is set for less than a second has fired: timers fire in
 * order.
 */
const outlastTimers = (page) => page.evaluate(() => new Promise((done) => setTimeout(done, 1000)));

test('an option changed while a mesh is read is for that mesh', async (t) => {
  const page = await openSlow(t);
  await dropAndWait(page, 'waves.obj', grid(4));
  await beginReading(page, 'slow.obj', grid(6));
  await page.fill('#t-number', '1.3');
  await outlastTimers(page);
  assert.ok(await page.evaluate(() => document.body.ariaBusy), 'it is still read');
  assert.equal(await textOf(page, '#run-text'), 'Reading slow.obj');
  assert.equal(await textOf(page, '#source'), 'waves.obj');
  await release(page);
  await settled(page);
  assert.equal(await textOf(page, '#source'), 'slow.obj');
  assert.equal((await metrics(page)).Faces, '72');
  assert.equal(await textOf(page, '#layout-info'), 't = 1.3');
  assert.ok(await page.isHidden('#layout-note'));
});

test('a second mesh that is dropped while the first is read is the one that stays', async (t) => {
  const page = await openSlow(t);
  await beginReading(page, 'slow.obj', grid(6));
  await dropAndWait(page, 'quick.obj', grid(5));
  await release(page);
  await outlastTimers(page);
  await settled(page);
  assert.equal(await textOf(page, '#source'), 'quick.obj');
  assert.equal((await metrics(page)).Faces, '50');
});

test('Escape ends reading and leaves the mesh before, which can be exported all the while', async (t) => {
  const page = await openSlow(t);
  const before = await metrics(page);
  await beginReading(page, 'slow.obj', grid(6));
  assert.equal((await exportMesh(page)).name, 'head-uv.obj');
  await page.keyboard.press('Escape');
  await settled(page);
  assert.equal(await textOf(page, '#run-text'), 'Cancelled');
  await release(page);
  await outlastTimers(page);
  assert.equal(await sampleOf(page), 'head');
  assert.equal(await textOf(page, '#source'), '');
  assert.deepEqual(await metrics(page), before);
  assert.ok(await page.isHidden('#again'));
});

test('a sample that is cancelled is not the one that the list shows', async (t) => {
  const page = await openSlow(t);
  const other = await page.evaluate(() => {
    const item = document.querySelector('.sample-item[aria-checked="false"]');
    item.click();
    // In the same task: nothing can have been read yet.
    document.querySelector('#cancel').click();
    return item.dataset.value;
  });
  await settled(page);
  assert.notEqual(other, 'head');
  assert.equal(await sampleOf(page), 'head');
  assert.equal(await textOf(page, '#run-text'), 'Cancelled');
});

test('cancelled before anything was read, the page waits for a mesh', async (t) => {
  const page = await openPage(t, {
    prepare: (page) =>
      page.addInitScript(() =>
        document.addEventListener('DOMContentLoaded', () =>
          document.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape' })),
        ),
      ),
  });
  assert.equal(await textOf(page, '#run-text'), 'Cancelled');
  assert.ok(await page.isHidden('#again'), 'there is nothing to do again');
  assert.ok(await page.isDisabled('#export'));
  await dropAndWait(page, 'waves.obj', grid(4));
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

test('a file of seams is for the mesh for which it was chosen', async (t) => {
  const page = await openSlow(t);
  await dropAndWait(page, 'ball.obj', objText(sphere(8)));
  await page.click('#details-toggle');
  await page.setInputFiles('#seams-file', {
    name: 'slow-seams.txt',
    mimeType: 'text/plain',
    buffer: Buffer.from('0 1\n'),
  });
  await page.waitForFunction(() => window.slowReads > 0);
  await dropAndWait(page, 'other.obj', objText(sphere(6)));
  await release(page);
  await outlastTimers(page);
  await settled(page);
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await page.getAttribute('#seams-auto', 'aria-pressed'), 'true');
  assert.equal(await textOf(page, '#seams-state'), '');
});

test('what is exported during a run is what is on screen', async (t) => {
  const page = await openPage(t, { mode: 'flatten', open: ['waves.obj', grid(8)] });
  const before = readFileSync((await exportMesh(page)).path, 'utf8');
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.evaluate(() => {
      const field = document.querySelector('#t-number');
      field.value = '1';
      field.dispatchEvent(new Event('input'));
      // In the same task: the run has begun and cannot have ended.
      document.querySelector('#export').click();
    }),
  ]);
  assert.equal(readFileSync(await pathOf(download), 'utf8'), before);
  await settled(page);
  assert.notEqual(readFileSync((await exportMesh(page)).path, 'utf8'), before);
});
