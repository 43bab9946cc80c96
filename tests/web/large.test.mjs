// With large meshes the page stays as responsive as with small ones: everything that loops over all
// triangles runs in workers.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { addMesh, emptyDocument, io, primitiveOf } from '../support/gltf.mjs';
import { grid } from '../support/small-meshes.mjs';
import { objText, torus } from '../support/surfaces.mjs';
import { laterParts } from './later-parts.mjs';
import { dropAndWait, exportMesh, openPage, settled, textOf } from './page.mjs';

/**
 * Counts how often each part of the page's own scripts runs on its main thread; returns a function
 * that gives the part that ran most often.
 */
async function countRuns(page) {
  const session = await page.context().newCDPSession(page);
  await session.send('Profiler.enable');
  await session.send('Profiler.startPreciseCoverage', { callCount: true, detailed: true });
  return async () => {
    const { result } = await session.send('Profiler.takePreciseCoverage');
    const parts = result
      .filter(({ url }) => /\/assets\/.*js$/.test(url))
      .flatMap(({ functions }) =>
        functions.flatMap(({ functionName, ranges }) =>
          ranges.map(({ count, startOffset }) => ({ count, functionName, startOffset })),
        ),
      );
    assert.ok(parts.length > 0, 'the scripts are looked at');
    return parts.reduce((most, part) => (part.count > most.count ? part : most));
  };
}

/**
 * Practically no loops over triangles; the remaining runs are frames, charts, boundary edges and
 * names.
 */
const SHARE = 1 / 4;

async function assertIdle(mostRun, faces, doing) {
  const { count, functionName, startOffset } = await mostRun();
  assert.ok(
    count < SHARE * faces,
    `${doing}: ${functionName || 'a function'} at ${startOffset} runs ${count} times for ${faces} triangles`,
  );
}

const SURFACE = torus(120, 60);
/** Each quad has two triangles. */
const FACES = 2 * SURFACE.faces.length;

/** Everything that is done with a mesh, from drop to save. */
async function assertIdleThroughout(page, name, content) {
  const mostRun = await countRuns(page);
  await dropAndWait(page, name, content);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  await assertIdle(mostRun, FACES, 'opened and unwrapped');
  await page.selectOption('#shading', 'angle');
  await page.click('#theme');
  await page.setViewportSize({ width: 1000, height: 800 });
  await assertIdle(mostRun, FACES, 'looked at');
  await exportMesh(page);
  await assertIdle(mostRun, FACES, 'exported');
  for (const id of ['#layout-png', '#layout-heat', '#layout-svg'])
    await Promise.all([page.waitForEvent('download'), page.click(id)]);
  await assertIdle(mostRun, FACES, 'pictures saved');
  await page.click('#details-toggle');
  await page.click('#tab-charts');
  await page.locator('.chart-name').first().click();
  await assertIdle(mostRun, FACES, 'an island looked at');
}

/**
 * Records how many bytes of arrays each message to a worker copies, meaning those that are not
 * transferred.
 */
function prepareCounting() {
  globalThis.copies = [];
  const bytesOf = (value) => {
    if (ArrayBuffer.isView(value)) return value.byteLength;
    if (typeof value !== 'object' || value === null) return 0;
    return Object.values(value).reduce((sum, each) => sum + bytesOf(each), 0);
  };
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function (message, ...how) {
    postMessage.call(this, message, ...how);
    globalThis.copies.push(bytesOf(message)); // transferred arrays have no bytes any more
  };
}

/** In bytes: options and names, but nothing per triangle. */
const SMALL = FACES;

async function assertHandedOver(page) {
  const copies = await page.evaluate(() => globalThis.copies);
  assert.ok(copies.length > 5, 'messages are looked at');
  assert.ok(Math.max(...copies) < SMALL, `a message copies ${Math.max(...copies)} bytes`);
}

test('a large OBJ keeps the page idle, from drop to saved', async (t) => {
  const page = await openPage(t, { prepare: (page) => page.addInitScript(prepareCounting) });
  await assertIdleThroughout(page, 'ring.obj', objText(SURFACE));
  await assertHandedOver(page);
});

/** Aims at points on the upper half of a ring seen from above. */
async function aim(page, from, to) {
  const { x, y, width, height } = await page.locator('#mesh-canvas').boundingBox();
  for (let i = from; i < to; ++i) {
    const angle = (Math.PI * (i + 0.5)) / 12;
    const r = 0.3 * Math.min(width, height);
    await page.mouse.move(
      x + width / 2 + r * Math.cos(angle),
      y + height / 2 - r * Math.sin(angle),
    );
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => done())));
  }
}

test('on a large mesh the pointer finds its vertex without looking at all triangles', async (t) => {
  let rest;
  const page = await openPage(t, {
    prepare: (page) => {
      rest = laterParts(page);
      return page.addInitScript(prepareCounting);
    },
  });
  const mostRun = await countRuns(page);
  // With the tools that come later, what the pointer finds things in is made anew, when it is first
  // over the mesh.
  await rest;
  await dropAndWait(page, 'ring.obj', objText(SURFACE));
  await aim(page, 0, 2);
  await mostRun();
  await aim(page, 2, 11);
  assert.match(await textOf(page, '#seam-hint'), /^Vertex \d+: start a cut/);
  await assertIdle(mostRun, FACES, 'aimed at');
  await page.mouse.down();
  await page.mouse.up();
  await aim(page, 6, 7);
  await page.mouse.down();
  await page.mouse.up();
  await settled(page);
  assert.ok(await page.isEnabled('#undo'), 'a seam was cut');
  await assertHandedOver(page);
});

test('a large GLB keeps the page idle, from drop to saved', async (t) => {
  const document = emptyDocument();
  addMesh(document, 'ring', primitiveOf(document, SURFACE));
  const page = await openPage(t);
  await assertIdleThroughout(page, 'ring.glb', await io.writeBinary(document));
});

test('a large disk keeps the page idle, with marks and by other methods', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  const mostRun = await countRuns(page);
  const n = 80;
  await dropAndWait(page, 'waves.obj', grid(n));
  await page.click('#delaunay');
  await settled(page);
  await page.click('#details-toggle');
  await page.click('#tab-methods');
  await page.click('#compare');
  await page.getByRole('button', { name: /^Tutte/ }).click();
  await page.locator('#method-note').waitFor();
  await assertIdle(mostRun, 2 * n * n, 'compared');
});
