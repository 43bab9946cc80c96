// The button that exports, its menu of formats, and the statistics on the clipboard.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { complaints, parseObj } from '../support/atlas.mjs';
import {
  addMesh,
  assertValidFile,
  atlasOf,
  emptyDocument,
  flaws,
  io,
  primitiveOf,
  primitivesOf,
} from '../support/gltf.mjs';
import { parsePly, plyToObj } from '../support/ply.mjs';
import { richGltf } from '../support/rich-gltf.mjs';
import { grid } from '../support/small-meshes.mjs';
import { objText, sphere } from '../support/surfaces.mjs';
import {
  choose,
  dropAndWait,
  exportAs,
  exportMesh,
  openPage,
  openSample,
  settled,
  textOf,
} from './page.mjs';

const BALL = ['ball.obj', objText(sphere(8))];

/** Without what a format loses. */
const focused = (page) =>
  page.evaluate(() => {
    const { firstChild, textContent } = document.activeElement;
    return (firstChild?.nodeType === Node.TEXT_NODE ? firstChild : { textContent }).textContent;
  });

const READERS = {
  obj: async (bytes) => complaints(bytes.toString()),
  ply: async (bytes) => complaints(plyToObj(parsePly(bytes))),
  glb: async (bytes) => {
    const document = await io.readBinary(bytes);
    await assertValidFile(document);
    return flaws(atlasOf(primitivesOf(document)));
  },
};

async function assertEveryFormat(page, base, formats = Object.keys(READERS)) {
  for (const format of formats) {
    const { name, bytes } = await exportAs(page, format);
    assert.equal(name, `${base}-uv.${format}`);
    assert.deepEqual(await READERS[format](bytes), [], format);
  }
}

test('any mesh is exported in any format, in islands or in one piece', async (t) => {
  const page = await openPage(t, { open: BALL });
  await assertEveryFormat(page, 'ball');
  await openSample(page, 'hemisphere');
  await choose(page, 'flatten');
  await assertEveryFormat(page, 'hemisphere');
});

test('a glTF is exported as OBJ and PLY, too', async (t) => {
  const document = emptyDocument();
  addMesh(document, 'ball', primitiveOf(document, sphere(6)));
  const page = await openPage(t, { open: ['scene.glb', await io.writeBinary(document)] });
  await assertEveryFormat(page, 'scene');
  await exportAs(page, 'obj');
  assert.match(
    await textOf(page, '#run-text'),
    /^Exported scene-uv\.obj, \d+\s*KB, shape and UVs only$/,
  );
});

test('the format that was chosen holds for the mesh that is open', async (t) => {
  const page = await openPage(t, { open: BALL });
  await exportAs(page, 'ply');
  assert.equal(await textOf(page, '#export'), 'Export PLY');
  await page.focus('#stretch');
  await page.keyboard.press('ArrowLeft');
  await settled(page);
  assert.equal((await exportMesh(page)).name, 'ball-uv.ply');
  await page.click('#export-formats');
  assert.equal(
    await page.getByRole('menuitemradio', { name: 'PLY' }).getAttribute('aria-checked'),
    'true',
  );
  await page.keyboard.press('Escape');
  await dropAndWait(page, 'waves.obj', grid(4));
  assert.equal(await textOf(page, '#export'), 'Export OBJ');
  assert.equal((await exportMesh(page)).name, 'waves-uv.obj');
});

test('all formats have the coordinates that are on screen', async (t) => {
  const page = await openPage(t, { open: BALL });
  const [{ bytes: obj }, { bytes: ply }] = [
    await exportAs(page, 'obj'),
    await exportAs(page, 'ply'),
  ];
  const corners = ({ texcoords, faces }) => faces.flat().map(([, i]) => texcoords[i]);
  assert.deepEqual(corners(parseObj(plyToObj(parsePly(ply)))), corners(parseObj(obj.toString())));
});

test('the menu says what a file loses in another format', async (t) => {
  const page = await openPage(t);
  const limits = async () => {
    await page.click('#export-formats');
    const items = page.locator('#export-menu > [role=menuitemradio]');
    const texts = await items.evaluateAll((all) =>
      all.map((item) => item.querySelector('small')?.innerText ?? ''),
    );
    await page.keyboard.press('Escape');
    return texts;
  };
  assert.deepEqual(await limits(), ['', '', ''], 'a sample has only a shape');
  await dropAndWait(page, 'rich.glb', richGltf().glb());
  const lost = 'loses materials, names, skins, morph targets and animations';
  assert.deepEqual(await limits(), [lost, lost, '']);
  const document = emptyDocument();
  addMesh(document, '', primitiveOf(document, sphere(4)));
  await dropAndWait(page, 'plain.glb', await io.writeBinary(document));
  assert.deepEqual(await limits(), ['shape and UVs only', 'shape and UVs only', '']);
  await dropAndWait(page, ...BALL);
  assert.deepEqual(await limits(), ['', 'shape and UVs only', 'shape and UVs only']);
  await openSample(page, 'hemisphere');
  assert.deepEqual(await limits(), ['', '', '']);
});

test('the menu works by keyboard', async (t) => {
  const page = await openPage(t, { open: BALL });
  const menu = page.locator('#export-menu');
  const opener = page.locator('#export-formats');
  for (const key of ['Enter', 'ArrowDown', 'Space']) {
    await opener.focus();
    await page.keyboard.press(key);
    assert.ok(await menu.isVisible(), key);
    assert.equal(await opener.getAttribute('aria-expanded'), 'true');
    assert.equal(await focused(page), 'OBJ', key);
    await page.keyboard.press('Escape');
    assert.ok(await menu.isHidden());
    assert.equal(await page.evaluate(() => document.activeElement.id), 'export-formats');
  }
  await opener.press('ArrowDown');
  for (const [key, text] of [
    ['ArrowDown', 'PLY'],
    ['ArrowDown', 'GLB'],
    ['ArrowDown', 'Picture of both views'],
    ['ArrowDown', 'OBJ'],
    ['ArrowUp', 'Picture of both views'],
    ['Home', 'OBJ'],
    ['End', 'Picture of both views'],
    ['ArrowUp', 'GLB'],
  ]) {
    await page.keyboard.press(key);
    assert.equal(await focused(page), text, key);
  }
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.keyboard.press('Enter'),
  ]);
  assert.equal(download.suggestedFilename(), 'ball-uv.glb');
  assert.ok(await menu.isHidden());
  // It goes where the focus does.
  await opener.press('ArrowDown');
  await page.keyboard.press('Tab');
  assert.ok(await menu.isHidden());
  await opener.click();
  await page.mouse.click(400, 300);
  assert.ok(await menu.isHidden());
});

/** The entries of a menu that no finger can press where the page is now, or that are too small for one. */
const outOfReach = (page, menu) =>
  page.locator(`${menu} button`).evaluateAll((entries) =>
    entries
      .filter((entry) => entry.getClientRects().length > 0) // some are for files with UVs alone
      .filter((entry) => {
        const { left, right, top, bottom, height } = entry.getBoundingClientRect();
        const hit = (x, y) => entry.contains(document.elementFromPoint(x, y));
        const isHit = hit(left + 1, top + height / 2) && hit(right - 1, top + height / 2);
        return !isHit || !hit(left + 8, bottom - 1) || height < 44;
      })
      .map(({ textContent }) => textContent),
  );

test('on a phone the menus are on the screen, and each entry is in reach of a finger', async (t) => {
  const page = await openPage(t, { viewport: { width: 390, height: 844 }, hasTouch: true });
  await page.tap('#export-formats');
  assert.deepEqual(await outOfReach(page, '#export-menu'), []);
  await page.tap('#layout-canvas');
  // Some entries come with a part that is loaded later.
  await page.locator('#arrange-menu button', { hasText: 'Flip' }).waitFor({ state: 'attached' });
  await page.tap('#selection-arrange');
  assert.deepEqual(await outOfReach(page, '#arrange-menu'), []);
  await page.touchscreen.tap(10, 10);
  // With the details open, the view is lower than the menu.
  await page.tap('#details-toggle');
  await page.tap('#selection-arrange');
  assert.deepEqual(await outOfReach(page, '#arrange-menu'), []);
  await page.getByRole('menuitem', { name: 'Even density' }).tap();
  await page.waitForFunction(() =>
    document.querySelector('#run-text').textContent.startsWith('Evened out'),
  );
});

test('all statistics are copied as JSON', async (t) => {
  const page = await openPage(t, { own: true });
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.click('#all-figures');
  await page.click('#copy-report');
  await page.waitForFunction(
    () => document.querySelector('#run-text').textContent === 'Statistics copied as JSON',
  );
  const text = await page.evaluate(() => navigator.clipboard.readText());
  const report = JSON.parse(text);
  assert.equal(text, JSON.stringify(report, null, 2));
  assert.equal(report.valid, true);
  assert.equal(report.charts.length, Number(/^\d+/.exec(await textOf(page, '#layout-info'))[0]));
});

test('where the clipboard is refused, the page says what to do', async (t) => {
  const page = await openPage(t, {
    prepare: (page) =>
      page.addInitScript(() => {
        navigator.clipboard.writeText = () =>
          Promise.reject(new DOMException('Write permission denied.', 'NotAllowedError'));
      }),
  });
  await page.click('#all-figures');
  await page.click('#copy-report');
  await page.waitForFunction(() => document.querySelector('#alert').textContent !== '');
  assert.match(
    await textOf(page, '#alert'),
    /^Nothing was copied, because .*\s+Allow it in the site settings/,
  );
});
