// The sheet of keys tells the truth: each key in it does what it says.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid } from '../support/small-meshes.mjs';
import { objText, sphere } from '../support/surfaces.mjs';
import { choose, drawn, drop, dropAndWait, openPage, settled, textOf } from './page.mjs';
import { SMALL } from './seam-page.mjs';
import { isOpen, keysOf } from './sheet-keys.mjs';
import { squares } from './squares.mjs';
import { changed, layoutReady } from './uvs-page.mjs';

const BALL = ['ball.obj', objText(sphere(6))];

/** As the keyboard of playwright has it. */
const pressed = (key) => key.replace('Ctrl+', 'Control+');

for (const [title, canvas] of [
  ['Mesh view', '#mesh-canvas'],
  ['Layout view', '#layout-canvas'],
])
  test(`${title}: each key moves the picture`, async (t) => {
    const page = await openPage(t, { ...SMALL, open: BALL });
    await page.focus(canvas);
    for (const key of keysOf(title)) {
      // From where every key leads elsewhere.
      for (const first of ['Home', 'ArrowLeft', 'ArrowUp', '+']) await page.keyboard.press(first);
      await drawn(page);
      const before = await page.locator(canvas).screenshot();
      await page.keyboard.press(pressed(key));
      await drawn(page);
      assert.notDeepEqual(await page.locator(canvas).screenshot(), before, key);
    }
  });

test('Seams: each key does what the sheet says', async (t) => {
  const page = await openPage(t, { ...SMALL, open: BALL });
  const says = async (pattern) => assert.match(await textOf(page, '#run-text'), pattern);
  const hint = () => page.evaluate(() => document.querySelector('#seam-hint').textContent);
  const cut = async (modifier = '') => {
    await page.keyboard.press(`${modifier}Enter`);
    for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowLeft');
    await drawn(page);
    await page.keyboard.press(`${modifier}Enter`);
    await settled(page);
  };
  const start = async (key) => {
    await page.keyboard.press(key);
    await says(/^Cut started at vertex/);
    await page.keyboard.press('Escape');
    await says(/^Cut cancelled/);
  };
  const effects = {
    Enter: () => start('Enter'),
    Space: () => start('Space'),
    Escape: () => start('Enter'),
    L: async () => {
      // Turned until an edge is in the middle.
      for (let i = 0; i < 40 && !/Double-click/.test(await hint()); ++i) {
        await page.keyboard.press(i % 2 ? 'ArrowLeft' : '+');
        await drawn(page);
      }
      await page.keyboard.press('l');
      await settled(page);
      assert.match(
        await page.locator('#history').evaluate((list) => list.textContent),
        /Cut (1 edge|a loop of \d+ edges)/,
      );
    },
    Alt: async () => {
      const before = await hint();
      await page.keyboard.down('Alt');
      await drawn(page);
      assert.notEqual(await hint(), before);
      await page.keyboard.up('Alt');
      await drawn(page);
    },
    C: async () => {
      for (const state of ['true', 'false']) {
        await page.keyboard.press('c');
        assert.equal(await page.getAttribute('#seam-paint', 'aria-pressed'), state);
      }
    },
    // Painted with in seam-painting.test.mjs.
    Ctrl: async () => undefined,
    Shift: async () => {
      for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowUp');
      await cut('Shift+');
      await page.keyboard.press('Escape');
      await says(/^Cut cancelled/);
    },
  };
  await page.focus('#mesh-canvas');
  await page.keyboard.press('Home');
  await drawn(page);
  const keys = keysOf('Seams');
  assert.deepEqual([...keys].sort(), Object.keys(effects).sort());
  for (const effect of Object.values(effects)) await effect();
});

test('Bounds: each key does what the sheet says', async (t) => {
  const page = await openPage(t, { ...SMALL, mode: 'flatten', open: ['grid.obj', grid(4)] });
  const says = async (pattern) => assert.match(await textOf(page, '#run-text'), pattern);
  // Once the brush is there.
  const painting = async () => {
    await page.waitForFunction(() => {
      const canvas = document.querySelector('#mesh-canvas');
      const { left, top, width, height } = canvas.getBoundingClientRect();
      const how = { pointerType: 'mouse', isPrimary: true, bubbles: true };
      for (let i = 0; i < 40; ++i) {
        const [clientX, clientY] = [left + width / 2, top + (height * i) / 40];
        canvas.dispatchEvent(new PointerEvent('pointermove', { ...how, clientX, clientY }));
        if (/vert/.test(document.querySelector('#bound-hint').textContent)) return true;
      }
      return false;
    });
  };
  const effects = {
    B: async () => {
      await page.keyboard.press('b');
      assert.equal(await page.getAttribute('#bound-paint', 'aria-pressed'), 'true');
      await painting();
    },
    Enter: async () => {
      await page.keyboard.press('Enter');
      await says(/^No boundary here$/);
    },
    Space: async () => {
      await page.keyboard.press('Space');
      await says(/^No boundary here$/);
    },
    // Painted and erased in bounds.test.mjs.
    Alt: async () => undefined,
  };
  await page.locator('#bound-paint').waitFor();
  await page.focus('#mesh-canvas');
  assert.deepEqual(keysOf('Bounds').sort(), Object.keys(effects).sort());
  for (const effect of Object.values(effects)) await effect();
});

test('Densities: each key does what the sheet says', async (t) => {
  const page = await openPage(t, { ...SMALL, open: CUBE });
  const says = async (pattern) => assert.match(await textOf(page, '#run-text'), pattern);
  await page.locator('#density-tools:not([hidden])').waitFor({ state: 'attached' });
  const effects = {
    D: async () => {
      await page.keyboard.press('d');
      assert.equal(await page.getAttribute('#density-paint', 'aria-pressed'), 'true');
      // Once the brush is there.
      await page.waitForFunction(() => {
        const canvas = document.querySelector('#mesh-canvas');
        const { left, top, width, height } = canvas.getBoundingClientRect();
        const [clientX, clientY] = [left + width / 2, top + height / 2];
        const how = { clientX, clientY, pointerType: 'mouse', isPrimary: true, bubbles: true };
        canvas.dispatchEvent(new PointerEvent('pointermove', how));
        return /island/.test(document.querySelector('#density-hint').textContent.slice(2));
      });
    },
    Enter: async () => {
      await page.keyboard.press('Enter');
      await settled(page);
      await says(/^Painted density 2 on/);
    },
    Space: async () => {
      await page.keyboard.press('Space');
      await says(/^No densities changed$/);
    },
    // Painted and erased in density-painting.test.mjs.
    Alt: async () => undefined,
  };
  await page.focus('#mesh-canvas');
  assert.deepEqual(keysOf('Densities').sort(), Object.keys(effects).sort());
  for (const effect of Object.values(effects)) await effect();
});

/** Of several charts. */
const CUBE = [
  'cube.obj',
  'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n' +
    'f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n',
];

test('Islands: each key does what the sheet says', async (t) => {
  const page = await openPage(t, { ...SMALL, open: CUBE });
  const press = (key) => page.keyboard.press(key);
  const isSelected = () => page.isVisible('#selection-frame');
  const isHidden = () => page.isVisible('#selection-show-all');
  const picture = async () => {
    await drawn(page);
    return page.locator('#layout-canvas').screenshot();
  };
  const middle = (key) => async () => {
    await press(key);
    assert.ok(await isSelected());
    await press('Escape');
  };
  const gesture = (key) => async () => {
    await press('a');
    await press(key);
    assert.match(await textOf(page, '#selection-text'), /^(Move|Rotate|Scale) /);
    await press('Escape');
    assert.ok(await isSelected());
  };
  /** A drag over a chart selects it. */
  const draws = (begin) => async () => {
    await press('Alt+a');
    await begin();
    const { x, y, width, height } = await page.locator('#layout-canvas').boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + 40, y + height / 2 + 30, { steps: 3 });
    await page.mouse.up();
    await page.keyboard.up('Control');
    assert.ok(await isSelected());
    await press('Alt+a');
  };
  const effects = {
    A: async () => {
      await press('a');
      assert.ok(await isSelected());
    },
    '.': async () => {
      const before = await picture();
      await press('.');
      assert.notDeepEqual(await picture(), before);
    },
    'Alt+A': async () => {
      await press('Alt+a');
      assert.ok(!(await isSelected()));
    },
    '/': async () => {
      await page.locator('.chart-name').first().click();
      await page.focus('#layout-canvas');
      await press('/');
      assert.ok(await isHidden());
      await press('/');
      assert.ok(!(await isHidden()));
    },
    G: gesture('g'),
    R: gesture('r'),
    S: gesture('s'),
    Escape: async () => {
      await press('Escape');
      assert.ok(!(await isSelected()));
    },
    Enter: middle('Enter'),
    Space: middle('Space'),
    H: async () => {
      await press('a');
      await press('h');
      assert.ok((await isHidden()) && !(await isSelected()));
    },
    'Alt+H': async () => {
      await press('Alt+h');
      assert.ok(!(await isHidden()));
    },
    B: draws(() => press('b')),
    Ctrl: draws(() => page.keyboard.down('Control')),
    I: async () => {
      await press('Alt+a');
      await press('i');
      assert.ok(await isSelected());
      await press('i');
      assert.ok(!(await isSelected()));
    },
    E: async () => {
      await press('e');
      assert.match(await textOf(page, '#run-text'), /^Click an edge/);
      await press('Escape');
    },
    F: async () => {
      await dropAndWait(page, 'square.obj', squares([[0.2, 0.2, 0.5, 0.5]]));
      await choose(page, 'pack');
      await layoutReady(page);
      await press('a');
      await press('f');
      await changed(page, 'Flipped island 0');
    },
  };
  await page.locator('#select-charts').waitFor();
  await page.click('#details-toggle');
  await page.focus('#layout-canvas');
  await press('+');
  assert.deepEqual(keysOf('Islands').sort(), Object.keys(effects).sort());
  for (const effect of Object.values(effects)) await effect();
});

test('Moving islands: each key does what the sheet says', async (t) => {
  const page = await openPage(t, { ...SMALL, open: BALL });
  const text = () => textOf(page, '#selection-text');
  const press = (key) => page.keyboard.press(key);
  await page.focus('#layout-canvas');
  await press('a');
  const first = await text();
  await press('g');
  const changes = (key) => async () => {
    const before = await text();
    await press(key);
    assert.notEqual(await text(), before, key);
  };
  const again = async (key) => {
    await press('g');
    await press('2');
    await press(key);
    await settled(page);
    assert.match(await textOf(page, '#run-text'), /^Moved /);
  };
  const effects = {
    ArrowLeft: changes('ArrowLeft'),
    ArrowRight: changes('ArrowRight'),
    ArrowUp: changes('ArrowUp'),
    ArrowDown: changes('ArrowDown'),
    X: changes('x'),
    Y: changes('y'),
    Backspace: async () => {
      await press('5');
      await changes('Backspace')();
    },
    Ctrl: async () => {
      const { x, y } = await page.locator('#layout-canvas').boundingBox();
      await page.mouse.move(x + 31, y + 77);
      await page.keyboard.down('Control');
      const snapped = await text();
      await page.keyboard.up('Control');
      assert.notEqual(await text(), snapped);
    },
    Escape: async () => {
      await press('Escape');
      assert.equal(await text(), first);
    },
    Enter: () => again('Enter'),
    Space: () => again('Space'),
  };
  assert.deepEqual([...new Set(keysOf('Moving islands'))].sort(), Object.keys(effects).sort());
  for (const effect of Object.values(effects)) await effect();
});

test('Page: each key does what the sheet says', async (t) => {
  const page = await openPage(t, { open: BALL });
  const canDo = (id) => page.locator(id).isEnabled();
  const press = async (key) => {
    await page.keyboard.press(key);
    await settled(page);
  };
  const redo = async (key) => {
    await press('Control+z');
    assert.ok(await canDo('#redo'));
    await press(key);
    assert.ok(!(await canDo('#redo')));
  };
  const effects = {
    'Ctrl+Z': async () => {
      await page.click('#seams-sharp');
      await settled(page);
      assert.ok(await canDo('#undo'));
      await press('Control+z');
      assert.ok(!(await canDo('#undo')));
      await press('Control+y');
    },
    'Ctrl+Shift+Z': () => redo('Control+Shift+z'),
    'Ctrl+Y': () => redo('Control+y'),
    'Ctrl+O': async () => {
      await page.locator('#file').evaluate((input) =>
        input.addEventListener('click', (event) => {
          event.preventDefault(); // no window of the system
          globalThis.asked = true;
        }),
      );
      await page.keyboard.press('Control+o');
      await page.waitForFunction(() => globalThis.asked);
    },
    'Ctrl+S': () => Promise.all([page.waitForEvent('download'), page.keyboard.press('Control+s')]),
    'Ctrl+E': async () => {
      await page.keyboard.press('Control+e');
      assert.ok(await page.isVisible('#export-menu'));
      await page.keyboard.press('Escape');
    },
    // What a key of the clipboard sets off, playwright cannot.
    'Ctrl+V': async () => {
      await page.evaluate((text) => {
        const clipboardData = new DataTransfer();
        clipboardData.items.add(new File([text], 'pasted.obj'));
        document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
      }, grid(4));
      await page.waitForFunction(
        () => document.querySelector('#source').textContent === 'pasted.obj',
      );
      await settled(page);
    },
    '?': async () => {
      await page.keyboard.press('?');
      assert.ok(await isOpen(page));
      await page.keyboard.press('Escape');
    },
    Escape: async () => {
      await drop(page, 'large.obj', objText(sphere(90)));
      await page.locator('#cancel:enabled').waitFor();
      await page.keyboard.press('Escape');
      await settled(page);
      assert.equal(await textOf(page, '#run-text'), 'Cancelled');
    },
  };
  assert.deepEqual(keysOf('Page').sort(), Object.keys(effects).sort());
  for (const effect of Object.values(effects)) await effect();
});

test('Details and t: each key does what the sheet says', async (t) => {
  const page = await openPage(t, { ...SMALL, mode: 'flatten' });
  await page.click('#details-toggle');
  const focused = () =>
    page.evaluate(() => document.activeElement.id || document.activeElement.ariaLabel);
  const moves = async (keys) => {
    for (const key of keys) {
      const before = await focused();
      await page.keyboard.press(key);
      assert.notEqual(await focused(), before, key);
    }
  };
  const both = ['ArrowRight', 'ArrowLeft', 'End', 'Home'];
  await page.focus('#tab-solver');
  await moves(both);
  await page.locator('#residual-chart .chart-column').first().focus();
  await moves(both);
  await page.focus('#t-number');
  for (const key of ['ArrowDown', 'ArrowUp']) {
    const before = await page.inputValue('#t-number');
    await page.keyboard.press(key);
    assert.notEqual(await page.inputValue('#t-number'), before, key);
  }
  await settled(page);
  await page.click('#tab-sweep');
  await page.click('#sweep');
  await page.waitForFunction(() => document.querySelector('#sweep').textContent !== 'Stop');
  for (const [key, bound] of [
    ['Enter', '1'],
    ['Space', '1.2'],
  ]) {
    await page.locator(`#sweep-chart [aria-label^="t = ${bound}:"]`).focus();
    await page.keyboard.press(key);
    await settled(page);
    assert.equal(await page.inputValue('#t-number'), bound);
  }
  assert.deepEqual(
    new Set(keysOf('Details and t')),
    new Set([...both, 'ArrowDown', 'ArrowUp', 'Enter', 'Space']),
  );
});
