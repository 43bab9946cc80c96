// The sheet of keys: it opens, can be read, and no key is missing from it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { objText, sphere } from '../support/surfaces.mjs';
import { choose, openPage, settled, textOf } from './page.mjs';
import { SMALL } from './seam-page.mjs';
import { CONTROLS, isOpen, keysOf } from './sheet-keys.mjs';

test('the sheet opens by its button and by ?, and closes', async (t) => {
  const page = await openPage(t);
  for (const open of [() => page.click('#help'), () => page.keyboard.press('?')])
    for (const close of [
      () => page.keyboard.press('Escape'),
      () => page.click('#help-close'),
      () => page.mouse.click(3, 300),
    ]) {
      await open();
      assert.ok(await isOpen(page));
      await close();
      assert.ok(!(await isOpen(page)));
    }
  await page.click('#help');
  await page.waitForSelector('#help-sheet h3');
  const titles = await page.locator('#help-sheet h3').allTextContents();
  assert.deepEqual(
    titles,
    CONTROLS.map(({ title }) => title),
    'once, however often it is opened',
  );
});

for (const size of [
  { width: 1280, height: 720 },
  { width: 390, height: 844 },
])
  test(`the sheet can be read in full, ${size.width} wide`, async (t) => {
    const page = await openPage(t, { viewport: size });
    await page.click('#help');
    await page.waitForSelector('#help-sheet h3');
    const box = await page.locator('#help-sheet').boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= size.width);
    assert.ok(box.y >= 0 && box.y + box.height <= size.height);
    const cut = await page
      .locator('#help-sheet, #help-sheet *')
      .evaluateAll((parts) =>
        parts.filter((e) => e.scrollWidth > e.clientWidth + 1).map((e) => e.outerHTML),
      );
    assert.deepEqual(cut, []);
    await page.locator('.sheet-foot').scrollIntoViewIfNeeded();
    assert.ok(await page.isVisible('.sheet-foot'));
  });

test('what is typed into a field opens nothing', async (t) => {
  const page = await openPage(t);
  await page.focus('#padding');
  await page.keyboard.press('?');
  assert.ok(!(await isOpen(page)));
});

test('Escape closes the sheet, and the cut that was begun goes on', async (t) => {
  const page = await openPage(t, { ...SMALL, open: ['ball.obj', objText(sphere(6))] });
  await page.focus('#mesh-canvas');
  await page.keyboard.press('Home');
  await page.keyboard.press('Enter');
  assert.match(await textOf(page, '#run-text'), /^Cut started/);
  await page.keyboard.press('?');
  await page.keyboard.press('Escape');
  assert.ok(!(await isOpen(page)));
  assert.match(await textOf(page, '#run-text'), /^Cut started/);
  await page.keyboard.press('Escape');
  assert.equal(await textOf(page, '#run-text'), 'Cut cancelled');
});

/** Sends every key to the elements; returns those that the page takes for itself, by the element. */
function takenKeys(page, selectors) {
  return page.evaluate((selectors) => {
    const signs = Array.from({ length: 95 }, (_, i) => String.fromCharCode(32 + i));
    const names = [
      ...['Enter', 'Escape', 'Tab', 'Backspace', 'Delete', 'Insert', 'Home', 'End'],
      ...['PageUp', 'PageDown', 'ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'],
      ...Array.from({ length: 12 }, (_, i) => `F${i + 1}`),
    ];
    const combinations = [
      {},
      { ctrlKey: true },
      { ctrlKey: true, shiftKey: true },
      { altKey: true },
    ];
    const taken = (element, key, modifiers) => {
      element.focus();
      const how = { ...modifiers, key, bubbles: true, cancelable: true };
      const isTaken = !element.dispatchEvent(new KeyboardEvent('keydown', how));
      document.querySelector('#help-sheet').close();
      return isTaken;
    };
    return selectors.map((selector) => {
      const element = document.querySelector(selector);
      return combinations.flatMap((modifiers) =>
        [...signs, ...names]
          .filter((key) => taken(element, key, modifiers))
          .map((key) => {
            const name = key === ' ' ? 'Space' : key;
            const { ctrlKey, shiftKey, altKey } = modifiers;
            const before = `${altKey ? 'Alt+' : ''}${ctrlKey ? 'Ctrl+' : ''}${shiftKey ? 'Shift+' : ''}`;
            return before + (before && name.length === 1 ? name.toUpperCase() : name);
          }),
      );
    });
  }, selectors);
}

/** The sheet has letters as keyboards do. Alt with Enter or Space is two keys of the sheet. */
const isListed = (key, listed) =>
  listed.has(key.replace(/^Alt\+(?=Enter|Space)/, '')) || listed.has(key.toUpperCase());

test('no key is missing from the sheet', async (t) => {
  const page = await openPage(t, SMALL);
  const everywhere = [...keysOf('Page'), ...keysOf('Seams')];
  const check = async (places) => {
    const taken = await takenKeys(page, Object.keys(places));
    for (const [i, [selector, titles]] of Object.entries(places).entries()) {
      const numbers = titles.includes('Moving islands') ? '0123456789.-' : '';
      const listed = new Set([...everywhere, ...titles.flatMap(keysOf), ...numbers]);
      assert.ok(taken[i].length > 0, `${selector} takes keys`);
      assert.deepEqual(
        taken[i].filter((key) => !isListed(key, listed)),
        [],
        selector,
      );
    }
  };
  await check({
    body: [],
    '#mesh-canvas': ['Mesh view', 'Islands'],
    '#layout-canvas': ['Layout view', 'Islands', 'Pins', 'Moving islands'],
    '#stretch': [],
    '#padding': [],
    '#open': [],
  });
  await settled(page);
  await choose(page, 'flatten');
  await page.click('#details-toggle');
  await page.locator('#residual-chart .chart-column').first().waitFor({ state: 'attached' });
  await check({
    '#mesh-canvas': ['Mesh view', 'Bounds'],
    '#layout-canvas': ['Layout view', 'Bounds'],
    '#t-number': ['Details and t'],
    '#residual-chart .chart-column': ['Details and t'],
    '#tab-solver': ['Details and t'],
  });
  await settled(page);
});
