// Seams are edited by clicks on the surface: cut, joined, undone, and laid out again.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { drum, glbBytes, objWithGroups } from '../support/drums.mjs';
import { CUBE, CUBE_OF_PARTS, grid } from '../support/small-meshes.mjs';
import { objText, sphere, together, torus } from '../support/surfaces.mjs';
import { dropAndWait, metrics, openPage, pathOf, settled, textOf } from './page.mjs';
import {
  CANVAS,
  click,
  clickAt,
  drawn,
  edited,
  hint,
  point,
  SMALL,
  vertices,
} from './seam-page.mjs';

/** Moves the pointer to a seam between two vertices that were seen near these places. */
async function pointAtSeam(page, [a, b], [c, d]) {
  const [x, y] = [(a + c) / 2, (b + d) / 2];
  for (const off of [0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5])
    if (/^Seam/.test(await point(page, x, y + off / 60))) return;
  assert.fail('there is no seam near');
}

const charts = async (page) => Number((await metrics(page)).Charts);

/** The grid in the plane of the screen, unwrapped. */
const openGrid = (t, n, options = SMALL) =>
  openPage(t, { ...options, open: ['grid.obj', flatGrid(n)] });

const flatGrid = (n) => grid(n).replace(/^(v \S+ \S+) \S+$/gm, '$1 0');

test('two clicks cut along the shortest path, and the charts follow', async (t) => {
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

/** On a first visit what edits seams comes after the first layout; here it does not come before `release` is called. */
async function openHeld(t, options = SMALL) {
  let release;
  const held = new Promise((resolve) => {
    release = resolve;
  });
  const prepare = (page) =>
    page.route(/\/assets\/solid-/, async (route) => {
      await held;
      await route.continue();
    });
  return { page: await openPage(t, { ...options, prepare }), release };
}

test('what is done to seams before they can be edited waits for that', async (t) => {
  const { page, release } = await openHeld(t);
  await page.click('#details-toggle');
  assert.ok(await page.isEnabled('#seam-cut'));
  assert.equal(
    await point(page, 0.5, 0.5),
    'Click a vertex to start a cut, double-click to cut a loop',
  );
  await click(page);
  const saving = page.waitForEvent('download');
  await page.click('#seams-save');
  assert.doesNotMatch(await textOf(page, '#run-text'), /Cut|Saved/);
  release();
  const saved = await saving;
  assert.match(readFileSync(await pathOf(saved), 'utf8'), /^\d+ \d+$/m);
  await point(page, 0.5, 0.5);
  await page.waitForFunction(() =>
    /^Vertex \d+ to|^From vertex/.test(document.querySelector('#seam-hint').textContent),
  );
});

test('if what edits seams cannot be loaded, the page says so and tries again', async (t) => {
  const script = /\/assets\/solid-/;
  const page = await openPage(t, {
    ...SMALL,
    prepare: (page) => page.route(script, (route) => route.abort()),
    expected: /ERR_FAILED/,
  });
  await point(page, 0.5, 0.5);
  await click(page);
  const said =
    'Seams cannot be edited: a part of this page could not be loaded. Check the connection, then try again.';
  await page.waitForFunction(
    (said) => document.querySelector('#run-text').textContent === said,
    said,
  );
  assert.ok(await page.isDisabled('#seam-cut'));
  await page.unroute(script);
  await page.click('#seams-sharp');
  await settled(page);
  await point(page, 0.5, 0.5);
  await page.waitForFunction(() =>
    /^Vertex \d+: start/.test(document.querySelector('#seam-hint').textContent),
  );
});

test('a cut is kept and cut further where charts are stretched, and edits go on from there', async (t) => {
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

test('Escape lets go, a drag turns the view, Alt does the other thing, Shift goes on', async (t) => {
  const page = await openGrid(t, 4);
  const seen = await vertices(page);
  await clickAt(page, seen.get(6));
  assert.match(await point(page, ...seen.get(7)), /^Vertex 6 to 7/);
  await page.keyboard.press('Escape');
  await drawn(page);
  assert.match(await hint(page), /^Vertex 7: start a cut/);
  assert.equal(await textOf(page, '#run-text'), 'Cut cancelled');

  // From 6 to 8 and on to 18.
  await clickAt(page, seen.get(6));
  await point(page, ...seen.get(8));
  await page.keyboard.down('Shift');
  await click(page);
  await settled(page);
  assert.equal(await edited(page), 2);
  await clickAt(page, seen.get(18));
  await page.keyboard.up('Shift');
  await settled(page);
  assert.equal(await edited(page), 4);
  await page.keyboard.press('Escape');

  await page.keyboard.down('Alt');
  await pointAtSeam(page, seen.get(6), seen.get(7));
  assert.equal(await hint(page), 'Seam of 4 edges: join');
  await page.keyboard.down('Shift');
  await drawn(page);
  assert.equal(await hint(page), 'Seam of 1 edge: join');
  await click(page);
  await page.keyboard.up('Shift');
  await page.keyboard.up('Alt');
  await settled(page);
  assert.equal(await edited(page), 3);

  const before = await edited(page);
  const still = await page.locator(CANVAS).screenshot();
  const box = await page.locator(CANVAS).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  await drawn(page);
  assert.notDeepEqual(await page.locator(CANVAS).screenshot(), still);
  assert.equal(await edited(page), before);
  assert.doesNotMatch(await hint(page), /^From vertex/);
});

test('seams that charts need to be disks stay, and say so', async (t) => {
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

test('sources of seams: what the file has is offered, and they combine', async (t) => {
  const page = await openPage(t, { ...SMALL, open: ['cube.obj', CUBE] });
  assert.ok(await page.isHidden('#seams-hard'));
  assert.ok(await page.isHidden('#seams-uv'));
  assert.ok(await page.isHidden('#seams-material'));
  await page.click('#seams-sharp');
  await settled(page);
  assert.equal(await charts(page), 6);
  await page.fill('#sharp-degrees', '95');
  await settled(page);
  const blunt = await charts(page);
  assert.ok(blunt < 6);
  await page.fill('#sharp-degrees', '-3');
  assert.equal(await page.getAttribute('#sharp-degrees', 'aria-invalid'), 'true');
  await page.locator('#sharp-degrees').blur();
  assert.equal(await page.inputValue('#sharp-degrees'), '95');

  await dropAndWait(page, 'parts.obj', CUBE_OF_PARTS);
  assert.equal(await textOf(page, '#alert'), '');
  assert.ok(await page.isVisible('#seams-uv'));
  assert.ok(await page.isVisible('#seams-material'));
  await page.click('#seams-auto');
  await page.click('#seams-uv');
  await settled(page);
  assert.equal(await charts(page), 2);
  await page.click('#seams-material');
  await settled(page);
  assert.equal(await charts(page), 3);
});

test('seams on hard edges, from the groups of an OBJ and the normals of a glTF', async (t) => {
  const page = await openPage(t, { ...SMALL, open: ['drum.obj', objWithGroups(drum(12, 2))] });
  const ask = async () => {
    await page.click('#seams-hard');
    await page.click('#seams-auto');
    await settled(page);
    assert.equal(await page.getAttribute('#seams-hard', 'aria-pressed'), 'true');
    assert.equal(await charts(page), 3);
  };
  await ask();
  await dropAndWait(page, 'drum.glb', glbBytes(drum(12, 2)));
  assert.equal(await page.getAttribute('#seams-hard', 'aria-pressed'), 'false', 'another mesh');
  await ask();
  // Without the lid above it is a disk once its vertices are joined.
  const { faces, parts, ...rest } = drum(12, 2);
  const isKept = (_, i) => parts[i] < 2;
  const cup = { ...rest, faces: faces.filter(isKept), parts: parts.filter(isKept) };
  await dropAndWait(page, 'cup.glb', glbBytes(cup));
  await page.click('#seams-hard');
  await page.click('#seams-auto');
  await settled(page);
  assert.equal(await charts(page), 2);
  await dropAndWait(page, 'cube.obj', CUBE);
  assert.ok(await page.isHidden('#seams-hard'));
});

test('seams are cut by keyboard and by touch', async (t) => {
  const page = await openGrid(t, 4, { ...SMALL, hasTouch: true });
  const seen = await vertices(page);
  await page.mouse.move(0, 0);
  const box = await page.locator(CANVAS).boundingBox();
  const tap = ([x, y]) => page.touchscreen.tap(box.x + x * box.width, box.y + y * box.height);
  await tap(seen.get(6));
  await drawn(page);
  assert.equal(await textOf(page, '#run-text'), 'Cut started at vertex 6');
  await page.locator('#seam-cancel').tap();
  await drawn(page);
  assert.equal(await textOf(page, '#run-text'), 'Cut cancelled');
  assert.ok(await page.isHidden('#seam-cancel'));
  await tap(seen.get(6));
  await drawn(page);
  await tap(seen.get(8));
  await drawn(page);
  await settled(page);
  assert.equal(await edited(page), 2);

  await page.focus(CANVAS);
  await page.keyboard.press('Home');
  await drawn(page);
  const first = /^Vertex (\d+): start/.exec(await hint(page));
  assert.ok(first, await hint(page));
  await page.keyboard.press('Enter');
  for (let i = 0; i < 4; ++i) await page.keyboard.press('ArrowLeft');
  await drawn(page);
  assert.match(await hint(page), /^(Vertex|From vertex) \d+/);
  await page.keyboard.press('Escape');
  await drawn(page);
  assert.match(await hint(page), /^Vertex \d+: start|^Click a vertex/);
  assert.equal(await edited(page), 2);
});

test('the table of charts: sorted by any column, and its charts are shown', async (t) => {
  const page = await openPage(t, { ...SMALL, open: ['ball.obj', objText(sphere(12))] });
  await page.click('#seams-sharp');
  await page.fill('#sharp-degrees', '9');
  await settled(page);
  const count = await charts(page);
  assert.ok(count > 2, `${count} charts`);
  await page.click('#details-toggle');
  const column = (i) =>
    page
      .locator(`#charts tbody tr > :nth-child(${i})`)
      .evaluateAll((cells) =>
        cells.map((cell) => Number.parseFloat(cell.textContent.replaceAll(',', ''))),
      );
  assert.equal((await column(1)).length, Math.min(200, count));
  const isSorted = (values, sign) =>
    values.every((x, i) => i === 0 || sign * (x - values[i - 1]) >= 0);
  assert.ok(isSorted(await column(2), -1), 'by faces, the most first');
  for (const [name, at] of [
    ['Area', 3],
    ['Stretch', 4],
    ['Angle', 5],
  ]) {
    const header = page.locator('#charts th').filter({ hasText: name });
    await header.locator('button').click();
    assert.equal(await header.getAttribute('aria-sort'), 'descending');
    assert.ok(isSorted(await column(at), -1), name);
    await header.locator('button').click();
    assert.equal(await header.getAttribute('aria-sort'), 'ascending');
    assert.ok(isSorted(await column(at), 1), name);
  }
  const pictures = async () => {
    await drawn(page);
    return [
      await page.locator(CANVAS).screenshot(),
      await page.locator('#layout-canvas').screenshot(),
    ];
  };
  await page.mouse.move(0, 0);
  const plain = await pictures();
  await page.locator('#charts .chart-name').first().focus();
  const lit = await pictures();
  plain.forEach((picture, i) => {
    assert.notDeepEqual(lit[i], picture);
  });
  await page.focus('#tab-charts');
  assert.deepEqual(await pictures(), plain);
  await page.locator('#charts .chart-name').first().focus();
  await page.keyboard.press('Enter');
  const close = await pictures();
  close.forEach((picture, i) => {
    assert.notDeepEqual(picture, lit[i]);
  });
});

test('an edit solves only the charts that it changes', async (t) => {
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
  const said = /^Unwrapped in [^;]+; (\d+) of (\d+) charts kept$/.exec(
    await textOf(page, '#run-text'),
  );
  assert.ok(said, await textOf(page, '#run-text'));
  assert.ok(Number(said[1]) >= before / 2 && Number(said[1]) < Number(said[2]));
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

test('seams are opened from a file and saved to one', async (t) => {
  const page = await openGrid(t, 4);
  await page.click('#details-toggle');
  const open = (text) =>
    page.setInputFiles('#seams-file', {
      name: 'mine.txt',
      mimeType: 'text/plain',
      buffer: Buffer.from(text),
    });
  const text = '10 11\n11 12\n12 13\n13 14\n';
  await open(text);
  await page.waitForFunction(() => document.querySelector('#seams-state').textContent !== '');
  await settled(page);
  assert.equal(await edited(page), 4);
  assert.equal(await charts(page), 2);
  const [saved] = await Promise.all([page.waitForEvent('download'), page.click('#seams-save')]);
  assert.equal(saved.suggestedFilename(), 'grid-seams.txt');
  assert.equal(await textOf(page, '#run-text'), 'Saved grid-seams.txt');
  assert.equal(readFileSync(await pathOf(saved), 'utf8'), text);
  await open('10 11\n0 13\n');
  await page.waitForFunction(() => document.querySelector('#alert').textContent !== '');
  assert.match(await textOf(page, '#alert'), /mine\.txt:2: 0-13 is not an edge of any face\./);
  assert.equal(await edited(page), 4, 'the seams stay');
});
