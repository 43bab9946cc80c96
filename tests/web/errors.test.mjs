// Errors are reported in a sentence, and what was there stays.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid } from '../support/small-meshes.mjs';
import { isPlain } from './layout.mjs';
import {
  choose,
  drawn,
  drop,
  dropAndWait,
  exportMesh,
  metrics,
  openPage,
  settled,
  textOf,
} from './page.mjs';

const SENTENCE = /^[A-Za-z].*\.$/s;

test('a broken file is refused with a sentence, the open mesh stays', async (t) => {
  const page = await openPage(t, { open: ['waves.obj', grid(4)] });
  const before = await metrics(page);
  await dropAndWait(page, 'broken.obj', 'v 0 0 0\nv 1 0 zero\nf 1 2 3\n');
  const alert = await page.locator('#alert p').first().innerText();
  assert.match(alert, SENTENCE);
  assert.match(alert, /broken\.obj/);
  assert.match(alert, /\b2\b/, 'names the line');
  assert.equal(await textOf(page, '#source'), 'waves.obj');
  assert.deepEqual(await metrics(page), before);
  assert.match(await textOf(page, '#run-text'), /broken\.obj was not opened/);
  assert.ok(await page.isEnabled('#export'));

  await page.click('.alert-close');
  assert.equal(await textOf(page, '#alert'), '');
});

/** Whether the view of the layout has a single colour, apart from the corner with its note. */
async function isEmpty(page) {
  await drawn(page);
  const { x, y, width, height } = await page.locator('#layout-canvas').boundingBox();
  const clip = { x: x + width / 4, y: y + height / 4, width: width / 2, height: height / 2 };
  return isPlain(page, clip);
}

/** Nothing beside the mesh on screen is of the one before. */
async function assertNoLayout(page) {
  await page.locator('#layout-note').waitFor();
  assert.equal(await textOf(page, '#layout-note'), 'No layout yet');
  assert.equal(await textOf(page, '#badge'), 'No result');
  assert.equal(await page.getAttribute('#badge', 'class'), 'badge');
  assert.equal(await textOf(page, '#reason'), '');
  assert.equal(await textOf(page, '#layout-info'), '');
  assert.deepEqual(new Set(Object.values(await metrics(page))), new Set(['\u2013']));
  for (const id of ['export', 'export-formats', 'copy-report', 'layout-png', 'pack-again'])
    assert.ok(await page.isDisabled(`#${id}`), id);
  assert.equal(await page.locator('#charts tbody tr').count(), 0);
  assert.ok(await isEmpty(page), 'nothing is drawn');
}

test('a mesh that cannot be laid out is shown without the layout of the one before', async (t) => {
  const page = await openPage(t, { open: ['waves.obj', grid(4)] });
  // No face has three distinct corners.
  await dropAndWait(page, 'needle.obj', 'v 0 0 0\nv 1 0 0\nf 1 2 2\nf 2 1 1\n');
  const alert = await page.locator('#alert p').first().innerText();
  assert.match(alert, SENTENCE);
  assert.match(alert, /needle\.obj/);
  assert.match(alert, /corners/);
  assert.equal(await textOf(page, '#mesh-info'), '2 triangles');
  await assertNoLayout(page);
  assert.doesNotMatch(await textOf(page, '#alert'), /waves/);

  await dropAndWait(page, 'again.obj', grid(4));
  assert.equal(await textOf(page, '#alert'), '');
  assert.ok(await page.isHidden('#layout-note'));
  assert.ok(await page.isEnabled('#export'));
});

test('a mesh whose unwrapping is cancelled is shown without the layout of the one before', async (t) => {
  const viewport = { width: 1440, height: 900 };
  const page = await openPage(t, { viewport, open: ['waves.obj', grid(4)] });
  assert.ok(!(await isEmpty(page)));
  assert.match(await textOf(page, '#grid-info'), /^grid \d/);
  const sizes = () =>
    page.locator('canvas').evaluateAll((all) => all.map((canvas) => canvas.clientHeight));
  const before = await sizes();
  await page.evaluate(() => {
    const source = document.querySelector('#source');
    new MutationObserver(() => document.querySelector('#cancel').click()).observe(source, {
      childList: true,
    });
  });
  await dropAndWait(page, 'other.obj', grid(40));
  assert.equal(await textOf(page, '#run-text'), 'Cancelled');
  await assertNoLayout(page);
  assert.equal(await textOf(page, '#grid-info'), '');
  assert.deepEqual(await sizes(), before, 'the views stay as large');
  for (const id of ['seam-cut', 'sharp-mark']) assert.ok(await page.isDisabled(`#${id}`), id);
  await page.click('#again');
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.ok(!(await isEmpty(page)));
  assert.ok(await page.isHidden('#layout-note'));
});

test('an impossible t is refused, the layout of the last one stays', async (t) => {
  const page = await openPage(t, { mode: 'flatten', open: ['waves.obj', grid(8)] });
  // 32 boundary vertices: t is at least 1 - 2/32 = 0.9375.
  await page.fill('#t-number', '0.93');
  await page.waitForFunction(() => document.querySelector('#alert').textContent !== '');
  await settled(page);
  assert.match(await textOf(page, '#alert'), /0\.93/);
  await page.locator('#layout-note').waitFor();
  assert.equal(await textOf(page, '#layout-note'), 'Previous layout');
  assert.equal(await textOf(page, '#export'), 'Export last layout');
  assert.match(await page.getAttribute('#export', 'title'), /waves\.obj, t = auto$/);
  assert.equal((await exportMesh(page)).name, 'waves-uv.obj');
  assert.match(await textOf(page, '#run-text'), /^Exported waves-uv\.obj, .*, t = auto$/);
  await page.fill('#t-number', '1');
  await page.waitForFunction(() => document.querySelector('#alert').textContent === '');
  await settled(page);
  assert.ok(await page.isHidden('#layout-note'));
  assert.equal(await textOf(page, '#export'), 'Export OBJ');
});

test('a number outside the range is marked and not used', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  await page.fill('#t-number', '7');
  assert.equal(await page.getAttribute('#t-number', 'aria-invalid'), 'true');
  assert.equal(await page.inputValue('#t'), '2');
  await page.locator('#t-number').blur();
  assert.equal(await page.inputValue('#t-number'), '2');
  assert.equal(await page.getAttribute('#t-auto', 'aria-pressed'), 'true');
  const reason = '7 was ignored: t must be from 0.9 to 2. It is still auto.';
  assert.equal(await textOf(page, '#run-text'), reason);
  assert.equal(await page.locator('#live').textContent(), reason);

  await choose(page, 'unwrap');
  await page.fill('#padding', '2.5');
  await page.locator('#padding').blur();
  assert.match(
    await textOf(page, '#run-text'),
    /^2\.5 was ignored: Padding must be a whole number from 0 to 256\. It is still 2\.$/,
  );
});

test('without WebGL the page says so and still flattens', async (t) => {
  const page = await openPage(t, { webgl: false });
  assert.match(await textOf(page, '#mesh-stage'), /WebGL/);
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

/** Presses the button that repeats what failed. */
async function tryAgain(page) {
  assert.equal(await textOf(page, '#again'), 'Try again');
  for (const button of ['#again', '#cancel'])
    assert.ok(
      await page.$eval(button, (each) => {
        const { top, bottom } = each.getBoundingClientRect();
        const dock = each.closest('.dock').getBoundingClientRect();
        const isInside = top >= dock.top && bottom <= dock.bottom;
        return isInside && each.scrollWidth <= each.clientWidth;
      }),
      `${button} shows all of its label`,
    );
  await page.click('#again');
  await settled(page);
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#badge'), 'Valid');
}

test('a program that cannot be loaded is reported, and loaded when it can be', async (t) => {
  const page = await openPage(t, {
    prepare: (page) => page.route('**/*.wasm', (route) => route.fulfill({ status: 404 })),
    expected: /404/,
  });
  assert.equal(
    await page.locator('#alert p').first().innerText(),
    'Head was not opened: a part of this page could not be loaded. Check the connection, then try again.',
  );
  assert.match(await textOf(page, '#alert'), /wasm.*404/s);
  assert.ok(await page.isDisabled('#export'));
  await page.unroute('**/*.wasm');
  await tryAgain(page);
});

test('a browser without vectors is told what is missing', async (t) => {
  const page = await openPage(t, {
    prepare: (page) =>
      page.addInitScript(() => {
        WebAssembly.validate = () => false;
      }),
  });
  assert.match(
    await page.locator('#alert p').first().innerText(),
    /^Head was not opened: abflat needs WebAssembly with 128-bit vectors .* Safari 16\.4/,
  );
});

for (const [which, script] of [
  ['that draws', /\/assets\/worker-(?!simd-|threads-)/],
  ['that unwraps', /\/assets\/worker-(simd|threads)-/],
])
  test(`a worker ${which} and cannot be loaded is reported, and loaded when it can be`, async (t) => {
    const page = await openPage(t, {
      prepare: (page) => page.route(script, (route) => route.abort()),
      expected: /ERR_FAILED/,
    });
    assert.equal(
      await page.locator('#alert p').first().innerText(),
      'Head was not opened: a part of this page could not be loaded. Check the connection, then try again.',
    );
    await page.unroute(script);
    await tryAgain(page);
  });

/**
 * Makes the next message stop the worker that `globalThis.dying` names, as running out of memory
 * would. The workshop is also sent what later parts need of the mesh before; it stops when it is to
 * draw another one.
 */
function prepareDying() {
  globalThis.Worker = class extends Worker {
    constructor(url, options) {
      super(url, options);
      this.is = options?.name ?? 'abflat';
    }
    postMessage(...message) {
      const isOther = this.is === 'workshop' && message[0].path?.[0] !== 'mesh';
      if (globalThis.dying !== this.is || isOther) {
        super.postMessage(...message);
        return;
      }
      globalThis.dying = null;
      this.terminate();
      const error = new ErrorEvent('error', { message: 'out of memory', cancelable: true });
      queueMicrotask(() => this.dispatchEvent(error));
    }
  };
}

test('a worker that stops is reported, and another one goes on', async (t) => {
  const page = await openPage(t, { prepare: (page) => page.addInitScript(prepareDying) });
  for (const which of ['workshop', 'abflat']) {
    await page.evaluate((which) => {
      globalThis.dying = which;
    }, which);
    await dropAndWait(page, `${which}.obj`, grid(4));
    assert.equal(
      await page.locator('#alert p').first().innerText(),
      `${which}.obj was not opened: its worker stopped, possibly because memory ran out. Close other tabs, then try again.`,
    );
    assert.match(await textOf(page, '#alert'), /out of memory/);
    await tryAgain(page);
    assert.equal(await textOf(page, '#source'), `${which}.obj`);
  }
});

test('a file chosen while the page still starts is opened', async (t) => {
  let release;
  const held = new Promise((resolve) => {
    release = resolve;
  });
  const page = await openPage(t, {
    prepare: (page) => {
      page.on('load', async () => {
        await drop(page, 'early.obj', grid(3));
        release();
      });
      return page.route('**/*.wasm', async (route) => {
        await held;
        await route.continue();
      });
    },
  });
  assert.equal(await textOf(page, '#source'), 'early.obj');
  assert.equal((await metrics(page)).Faces, '18');
});
