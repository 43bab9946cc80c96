// Everyone can use it: by keyboard, with a screen reader, on a phone, in either theme.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid } from '../support/small-meshes.mjs';
import { openPage, settled, textOf } from './page.mjs';

const WAVES = ['waves.obj', grid(12)];

/** Luminance contrast of two css colours (WCAG), computed in the page. */
function contrast(page, selector) {
  return page.locator(selector).evaluate((element) => {
    const channels = (css) => {
      const context = new OffscreenCanvas(1, 1).getContext('2d');
      context.fillStyle = css;
      context.fillRect(0, 0, 1, 1);
      return [...context.getImageData(0, 0, 1, 1).data];
    };
    const luminance = (css) => {
      const [r, g, b] = channels(css).map((x) =>
        x / 255 <= 0.04045 ? x / 255 / 12.92 : ((x / 255 + 0.055) / 1.055) ** 2.4,
      );
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    let behind = element;
    while (channels(getComputedStyle(behind).backgroundColor)[3] < 255)
      behind = behind.parentElement;
    const [low, high] = [
      luminance(getComputedStyle(element).color),
      luminance(getComputedStyle(behind).backgroundColor),
    ].sort((a, b) => a - b);
    return (high + 0.05) / (low + 0.05);
  });
}

test('the theme follows the system, can be switched and is remembered', async (t) => {
  const page = await openPage(t, { colorScheme: 'light' });
  const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
  const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.equal(await theme(), 'light');
  const light = await background();
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.waitForFunction(() => document.documentElement.dataset.theme === 'dark');
  assert.notEqual(await background(), light);
  await page.click('#theme');
  assert.equal(await theme(), 'light');
  assert.equal(await background(), light);
  await page.reload();
  await settled(page);
  assert.equal(await theme(), 'light', 'remembered although the system is dark');
});

test('text has contrast in both themes', async (t) => {
  const page = await openPage(t, { mode: 'flatten', open: WAVES });
  await page.click('#details-toggle');
  await page.mouse.move(0, 0);
  for (const theme of ['dark', 'light']) {
    for (const selector of [
      '#open',
      '#mesh-info',
      '#reason',
      '#t-hint',
      '#wireframe',
      '#run-text',
      '#tab-sweep',
      '#solver-readout',
    ])
      assert.ok((await contrast(page, selector)) >= 4.5, `${selector} in the ${theme} theme`);
    await page.click('#theme');
  }
});

test('text of an atlas has contrast in both themes', async (t) => {
  const page = await openPage(t);
  await page.click('#more-toggle');
  await page.click('#more-straight-seams');
  await settled(page);
  await page.click('#details-toggle');
  await page.locator('.lock').first().click();
  await page.mouse.move(0, 0);
  for (const theme of ['dark', 'light']) {
    for (const selector of [
      '#more-state',
      '.more-row label',
      '#more-rotate',
      '#layout-png',
      '#layout-tools label',
      '#locks-summary',
      '.lock[aria-pressed="true"]',
    ])
      assert.ok(
        (await contrast(page, `${selector} >> nth=0`)) >= 4.5,
        `${selector} in the ${theme} theme`,
      );
    await page.click('#theme');
  }
});

test('Tab reaches every control, in the order of the page', async (t) => {
  const page = await openPage(t, { mode: 'flatten', open: WAVES });
  // By script, so that Tab starts at the beginning of the page.
  await page.evaluate(() => document.querySelector('#details-toggle').click());
  // A chart is drawn once its size is known, in a frame after the pane has opened.
  for (const chart of ['#residual-chart', '#active-chart'])
    await page.locator(`${chart} rect[tabindex="0"]`).waitFor({ state: 'attached' });
  // Tab reaches one of the tabs and one of a chart's columns, arrow keys the others.
  const expected = await page.evaluate(() =>
    [...document.querySelectorAll('button, input, select, canvas[tabindex], rect[tabindex]')]
      .filter((element) => element.checkVisibility() && !element.disabled && element.tabIndex === 0)
      .map((element) => element.id || element.ariaLabel || element.textContent),
  );
  assert.ok(expected.length >= 20);
  const reached = [];
  for (let i = 0; i < expected.length; i++) {
    await page.keyboard.press('Tab');
    reached.push(
      await page.evaluate(() => {
        const { id, ariaLabel, textContent } = document.activeElement;
        return id || ariaLabel || textContent;
      }),
    );
    const mark = await page.evaluate(() => {
      const { outlineStyle, stroke } = getComputedStyle(document.activeElement);
      return [outlineStyle, stroke];
    });
    assert.notDeepEqual(mark, ['none', 'none'], `focus is visible on ${reached.at(-1)}`);
  }
  assert.deepEqual(reached, expected);
});

test('every control has a name, results are announced', async (t) => {
  const page = await openPage(t, { mode: 'flatten', open: WAVES });
  for (const role of ['button', 'slider', 'combobox', 'spinbutton', 'img']) {
    const all = await page.getByRole(role).all();
    const named = await page.getByRole(role, { name: /\w/ }).all();
    assert.ok(all.length > 0, role);
    assert.equal(named.length, all.length, `each ${role} has a name`);
  }
  assert.match(await page.locator('#live').textContent(), /^Flattened in/);
  assert.equal(await page.getAttribute('#live', 'aria-live'), 'polite');
  assert.equal(await page.getAttribute('#t', 'aria-valuetext'), '2, auto: free');
});

test('both pictures answer to keys', async (t) => {
  const page = await openPage(t);
  for (const id of ['#mesh-canvas', '#layout-canvas']) {
    const start = await page.locator(id).screenshot();
    await page.focus(id);
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('+');
    await page.locator(id).blur();
    assert.notDeepEqual(await page.locator(id).screenshot(), start, id);
  }
});

/** A finger that does not move what views show can scroll the page beside each of them. */
const haveStrips = (page) =>
  page.locator('.stage').evaluateAll((stages) =>
    stages.every((stage) => {
      const { right, top, height } = stage.getBoundingClientRect();
      const beside = document.elementFromPoint(right + 16, top + height / 2);
      return beside && getComputedStyle(beside).touchAction === 'auto';
    }),
  );

for (const [name, width, height, hasTouch] of [
  ['a small screen', 1280, 720, false],
  ['a narrow window', 390, 844, false],
  ['a phone', 390, 844, true],
  ['a narrow phone', 360, 740, true],
  ['a tablet', 820, 1180, true],
]) {
  test(`${name}: nothing is cut off sideways, every control can be reached`, async (t) => {
    const page = await openPage(t, {
      viewport: { width, height },
      hasTouch,
      mode: 'flatten',
      open: WAVES,
    });
    const overflow = await page.evaluate(() => {
      const root = document.documentElement;
      return [root.scrollWidth - innerWidth, root.scrollHeight - innerHeight];
    });
    assert.ok(overflow[0] <= 0, 'no horizontal scrolling');
    // Buttons that fit a finger make a page taller than a phone.
    if (hasTouch) assert.ok(overflow[1] <= 0 || (await haveStrips(page)), 'a finger can scroll');
    else assert.ok(overflow[1] <= 0, 'no vertical scrolling');
    for (const id of [
      'open',
      'sample',
      'export',
      'theme',
      't',
      't-auto',
      't-number',
      'cancel',
      'fit',
    ]) {
      await page.locator(`#${id}`).scrollIntoViewIfNeeded();
      const box = await page.locator(`#${id}`).boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= width, `${id} is inside`);
    }
    for (const id of ['mesh-canvas', 'layout-canvas']) {
      const box = await page.locator(`#${id}`).boundingBox();
      assert.ok(box.width > 250 && box.height > 120, `${id} has room: ${JSON.stringify(box)}`);
    }
    await page.click('#details-toggle');
    for (const tab of await page.getByRole('tab').all()) {
      await tab.click();
      const scrollWidth = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(scrollWidth <= width, 'no horizontal scrolling with the details open');
      for (const id of ['details-close', 'layout-canvas']) {
        await page.locator(`#${id}`).scrollIntoViewIfNeeded();
        const box = await page.locator(`#${id}`).boundingBox();
        assert.ok(box.x >= 0 && box.x + box.width <= width, `${id} is inside`);
      }
    }
  });
}

test('nothing moves while t is dragged', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  await page.click('#details-toggle');
  const places = () =>
    page.evaluate(() =>
      [
        ...document.querySelectorAll(
          '.pane, canvas, .dock > *, .metric, #cancel, #t-number, .chart-picture',
        ),
      ].map((element) => JSON.stringify(element.getBoundingClientRect())),
    );
  // The canvases get their size in the frame after that of the pane.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
  await settled(page);
  const before = await places();
  await page.focus('#t');
  for (let i = 0; i < 20; i++) {
    await page.keyboard.press('ArrowLeft');
    assert.deepEqual(await places(), before);
  }
  await settled(page);
  assert.deepEqual(await places(), before);
  assert.equal(await textOf(page, '#layout-info'), 't = 1.8');
});
