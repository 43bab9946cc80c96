// Seams are edited by clicks on the surface: cut, joined, undone, and laid out again.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { objText, sphere, together, torus } from '../support/surfaces.mjs';
import { dropAndWait, metrics, openPage, settled, textOf } from './page.mjs';
import {
  charts,
  click,
  clickAt,
  edited,
  hint,
  openGrid,
  point,
  pointAtSeam,
  SMALL,
  vertices,
} from './seam-page.mjs';

test('two clicks cut along the shortest path, and the islands follow', async (t) => {
  const n = 4;
  const page = await openGrid(t, n);
  assert.equal(await charts(page), 1);
  const seen = await vertices(page);
  assert.equal(seen.size, (n + 1) ** 2, 'every vertex can be aimed at');
  // Straight across, from boundary to boundary.
  await clickAt(page, seen.get(2 * (n + 1)));
  assert.match(await textOf(page, '#run-text'), /^Cut started at vertex 10$/);
  assert.match(
    await point(page, ...seen.get(2 * (n + 1) + n)),
    /^Vertex 10 to 14: cut 4 edges, 4\.00 long$/,
  );
  await click(page);
  await settled(page);
  assert.equal(await edited(page), 4);
  assert.equal(await charts(page), 2);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.equal(await page.getAttribute('#seams-auto', 'aria-pressed'), 'false');

  // Undo and redo, by button and by keys.
  await page.click('#undo');
  await settled(page);
  assert.equal(await charts(page), 1);
  assert.equal(await page.getAttribute('#seams-auto', 'aria-pressed'), 'true');
  assert.ok(await page.isDisabled('#undo'));
  await page.keyboard.press('Control+Shift+Z');
  await settled(page);
  assert.equal(await charts(page), 2);
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal(await charts(page), 1);
  await page.click('#redo');
  await settled(page);
  assert.equal(await charts(page), 2);

  // Join: pointing at a seam shows all of it, a click removes it.
  await page.click('#seam-join');
  await pointAtSeam(page, seen.get(11), seen.get(12));
  assert.equal(await hint(page), 'Seam of 4 edges: join');
  await click(page);
  await settled(page);
  assert.equal(await edited(page), 0);
  assert.equal(await charts(page), 1);
  // Automatic seams again.
  await page.click('#seams-auto');
  await settled(page);
  assert.equal(await textOf(page, '#seams-state'), '');
});

test('a cut is kept and cut further where islands are stretched, and edits go on from there', async (t) => {
  const page = await openPage(t, { ...SMALL, open: ['ball.obj', objText(sphere(6))] });
  await page.click('#seams-auto');
  await settled(page);
  const state = () => textOf(page, '#seams-state');
  const cut = async (from, to) => {
    await clickAt(page, from);
    await clickAt(page, to);
    await settled(page);
  };
  await cut([0.44, 0.5], [0.56, 0.5]);
  const own = await state();
  assert.match(own, /^seams edited: \d+ edges?$/);
  assert.equal(await textOf(page, '#badge'), 'Stretched');
  await page.click('#remedy');
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.equal(await state(), `${own}, cut further`);
  // The slider cuts again.
  const stretch = async () => Number((await metrics(page)).Stretch);
  const before = await stretch();
  await page.focus('#stretch');
  await page.keyboard.press('Home');
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.ok((await stretch()) < before);
  const further = Number((await metrics(page))['Seam length']);
  await cut([0.5, 0.4], [0.5, 0.6]);
  assert.match(await state(), /^seams edited: \d+ edges$/);
  assert.ok(Number((await metrics(page))['Seam length']) >= further, 'nothing was joined');
  // The second cut, the slider, and cutting further.
  for (let i = 0; i < 3; ++i) await page.click('#undo');
  await settled(page);
  assert.equal(await state(), own);
});

test('seams that islands need to be disks stay, and say so', async (t) => {
  const page = await openPage(t, { ...SMALL, open: ['torus.obj', objText(torus(24, 12))] });
  await page.click('#seams-auto');
  await settled(page);
  assert.equal(await textOf(page, '#seams-state'), 'fewest possible seams');
  const needed = Number((await metrics(page))['Seam length']);
  assert.ok(needed > 0);
  await page.click('#seam-join');
  await page.click('#undo');
  await settled(page);
  assert.equal(await page.getAttribute('#seams-auto', 'aria-pressed'), 'true');
  assert.ok(Number((await metrics(page))['Seam length']) > needed);
});

test('an edit solves only the islands that it changes', async (t) => {
  const page = await openPage(t, SMALL);
  // Two balls: cutting one leaves the other unchanged.
  const ball = sphere(10);
  await dropAndWait(
    page,
    'balls.obj',
    objText(
      together([
        [ball, [0, 0, 0]],
        [ball, [2.4, 0, 0]],
      ]),
    ),
  );
  const before = await charts(page);
  const first = [...(await vertices(page, 16))].filter(
    ([vertex]) => vertex < ball.positions.length,
  );
  assert.ok(first.length > 4, `${first.length} vertices of the first ball`);
  await clickAt(page, first[0][1]);
  await clickAt(page, first[first.length - 1][1]);
  await settled(page);
  assert.ok((await edited(page)) > 0);
  const said = /^Unwrapped in [^;]+; (\d+) of (\d+) islands kept$/.exec(
    await textOf(page, '#run-text'),
  );
  assert.ok(said, await textOf(page, '#run-text'));
  assert.ok(Number(said[1]) >= before / 2 && Number(said[1]) < Number(said[2]));
  assert.equal(await textOf(page, '#badge'), 'Valid');
});
