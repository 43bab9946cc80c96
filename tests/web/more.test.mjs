// The less common options of an atlas: they reach abflat, stay visible, and several tiles are
// shown.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { runAbflat } from '../support/run-abflat.mjs';
import { grid } from '../support/small-meshes.mjs';
import { objText, sphere, together, torus } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { loadModule } from './modules.mjs';
import { choose, dropAndWait, exportMesh, metrics, openPage, settled, textOf } from './page.mjs';

const RINGS = objText(together([0, 1, 2].map((i) => [torus(16, 8), [2.6 * i, 0, 0]])));

async function fill(page, id, text) {
  await page.fill(id, text);
  await settled(page);
}

async function click(page, id) {
  await page.click(id);
  await settled(page);
}

/**
 * Exports the current result, and compares it with what the program makes with the same options.
 */
async function assertAsProgram(t, page, text, options) {
  const path = tempFolder(t);
  const exported = await exportMesh(page);
  writeFileSync(path('in.obj'), text);
  const { code, stderr } = await runAbflat([
    'unwrap',
    path('in.obj'),
    '-o',
    path('out.obj'),
    ...options,
  ]);
  assert.equal(code, 0, stderr);
  assert.equal(readFileSync(exported.path, 'utf8'), readFileSync(path('out.obj'), 'utf8'));
}

test('more options change the atlas as those of the command line do, and are named when closed', async (t) => {
  const page = await openPage(t, { open: ['rings.obj', RINGS] });
  assert.ok(await page.isHidden('#more'));
  assert.equal(await textOf(page, '#more-state'), '');
  await page.focus('#more-toggle');
  await page.keyboard.press('Enter');
  assert.equal(await page.getAttribute('#more-toggle', 'aria-expanded'), 'true');
  assert.deepEqual(await page.locator('#more-fill-holes option').allInnerTexts(), [
    'Auto',
    'Never',
    'Always',
  ]);
  await page.selectOption('#more-fill-holes', 'never');
  await settled(page);
  await page.selectOption('#more-symmetric-seams', 'never');
  await settled(page);
  await fill(page, '#more-t', '1');
  await click(page, '#more-straight-seams');
  await settled(page);
  await page.selectOption('#more-rotate', 'none');
  await settled(page);
  assert.equal(
    await textOf(page, '#more-state'),
    'fill holes never, symmetric seams never, boundary t 1, rotation none, straight seams',
  );
  await assertAsProgram(t, page, RINGS, [
    ...['--fill-holes', 'never', '--symmetric-seams', 'never', '--t', '1'],
    ...['--straight-seams', '--rotate', 'none'],
  ]);
  // A disk in one piece has other options.
  await dropAndWait(page, 'waves.obj', grid(4));
  await choose(page, 'flatten');
  assert.ok(await page.isHidden('#unwrap-options'));
  assert.ok(await page.isHidden('#more'));
  await page.click('#mode-unwrap');
  await settled(page);
  assert.ok(await page.isVisible('#more'));
  await page.click('#more-toggle');
  assert.ok(await page.isHidden('#more'));
  assert.match(await textOf(page, '#more-state'), /^fill holes never/);
});

test('faces that have uv in the file keep it, as with the command line, until another mesh is opened', async (t) => {
  const page = await openPage(t, { open: ['rings.obj', RINGS] });
  await page.click('#more-toggle');
  assert.ok(await page.isHidden('#more-keep-uv'), 'it has none');

  // Two of three rings are painted.
  const path = tempFolder(t);
  writeFileSync(path('in.obj'), RINGS);
  const { code, stderr } = await runAbflat(['unwrap', path('in.obj'), '-o', path('all.obj')]);
  assert.equal(code, 0, stderr);
  const faces = RINGS.match(/^f /gm).length;
  let face = -1;
  const painted = readFileSync(path('all.obj'), 'utf8').replace(/^f .*$/gm, (line) => {
    face += 1;
    return 3 * face < 2 * faces ? line : line.replace(/\/\d+/g, '');
  });
  await dropAndWait(page, 'painted.obj', painted);
  await page.focus('#more-keep-uv');
  await page.keyboard.press('Enter');
  await settled(page);
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await page.getAttribute('#more-keep-uv', 'aria-pressed'), 'true');
  assert.equal(await textOf(page, '#more-state'), 'keep UVs of the file');
  assert.match(await textOf(page, '#run-text'), /\d+ (of \d+ islands )?as in the file$/);
  await assertAsProgram(t, page, painted, ['--keep', 'uv']);
  const kept = await metrics(page);

  // A chart that is kept for the file's sake stays as long as that option is on.
  await page.click('#details-toggle');
  const locked = page.locator('.lock[aria-pressed="true"]');
  assert.ok((await locked.count()) > 0);
  await click(page, '#more-keep-uv');
  assert.equal(await locked.count(), 0);
  await assertAsProgram(t, page, painted, []);
  assert.notDeepEqual(await metrics(page), kept);
  await click(page, '#more-keep-uv');
  await dropAndWait(page, 'again.obj', painted);
  assert.equal(await page.getAttribute('#more-keep-uv', 'aria-pressed'), 'false');
  assert.equal(await textOf(page, '#more-state'), '');
});

test('islands of a file that cannot be kept are named, and the others stay', async (t) => {
  const page = await openPage(t, { settles: false });
  // The second triangle lies face down in uv, the third stands alone.
  const text =
    'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 3 0 0\nv 2 1 0\n' +
    'vt 0 0\nvt 0.5 0\nvt 0.5 0.5\nvt 0.4 0.1\nvt 0.6 0.6\nvt 0.9 0.6\nvt 0.6 0.9\n' +
    'f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 5/5 6/6 7/7\n';
  await dropAndWait(page, 'folded.obj', text);
  await page.click('#mode-unwrap');
  await settled(page);
  await page.click('#more-toggle');
  await click(page, '#more-keep-uv');
  assert.equal(await textOf(page, '#alert'), '');
  await page.click('#notes-button');
  const notes = await page.locator('#atlas-notes li').allInnerTexts();
  assert.ok(
    notes.some((note) => /^Kept 1 of 2 UV islands .*face 1 is mirrored/.test(note)),
    notes.join('\n'),
  );
});

test('a texel density may take several tiles, which are numbered', async (t) => {
  const page = await openPage(t, { open: ['rings.obj', RINGS] });
  const density = Math.floor(1.1 * Number((await metrics(page))['Texels per unit']));
  await page.click('#more-toggle');
  assert.ok(await page.isDisabled('#more-udim'));
  assert.equal(await page.locator('.tile').count(), 0);
  await fill(page, '#more-texel-density', String(density));
  assert.match(await textOf(page, '#alert'), /do not fit one tile/);
  await click(page, '#more-udim');
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal((await metrics(page))['Texels per unit'], String(density));
  const tiles = Number(/, (\d+) tiles$/.exec(await textOf(page, '#layout-info'))[1]);
  assert.ok(tiles >= 2);
  await page.waitForFunction((n) => document.querySelectorAll('.tile').length === n, tiles);
  assert.deepEqual(
    await page.locator('.tile').allInnerTexts(),
    Array.from({ length: tiles }, (_, i) => String(1001 + i)),
  );
  const box = await page.locator('#layout-canvas').boundingBox();
  const places = await Promise.all(
    (await page.locator('.tile').all()).map((label) => label.boundingBox()),
  );
  places.forEach(({ x, y, width }, i) => {
    assert.ok(x >= box.x && x + width <= box.x + box.width, `tile ${1001 + i} is in view`);
    if (i > 0) assert.ok(x > places[i - 1].x && y === places[0].y, 'side by side');
  });
  const row = ((places.at(-1).x - places[0].x) * tiles) / (tiles - 1);
  assert.ok(row > box.width - 24, 'the tiles are as large as fits');
  await assertAsProgram(t, page, RINGS, ['--texel-density', String(density), '--udim']);
  // When zoomed out, there is no room for numbers.
  await page.focus('#layout-canvas');
  for (let i = 0; i < 16; i++) await page.keyboard.press('-');
  await page.waitForFunction(() => document.querySelectorAll('.tile').length === 0);
  // An empty field is auto, one tile again.
  await fill(page, '#more-texel-density', '');
  assert.ok(await page.isDisabled('#more-udim'));
  assert.match(await textOf(page, '#layout-info'), /^\d+ islands$/);
});

test('what is no number is marked, and the last one stays', async (t) => {
  const page = await openPage(t, { open: ['ball.obj', objText(sphere(8))] });
  await page.click('#more-toggle');
  await fill(page, '#more-texel-density', '50');
  const before = await metrics(page);
  for (const text of ['0', '-3']) {
    await page.fill('#more-texel-density', text);
    assert.equal(await page.getAttribute('#more-texel-density', 'aria-invalid'), 'true', text);
  }
  await page.locator('#more-texel-density').blur();
  await settled(page);
  assert.equal(await page.inputValue('#more-texel-density'), '50');
  assert.equal(await page.getAttribute('#more-texel-density', 'aria-invalid'), 'false');
  assert.deepEqual(await metrics(page), before);
});

for (const [name, width, height] of [
  ['a small screen', 1280, 720],
  ['a tablet', 820, 1180],
  ['a narrow phone', 360, 740],
]) {
  test(`${name}: more options fit, follow in the order of Tab, and leave the views alone where there is room`, async (t) => {
    const page = await openPage(t, {
      viewport: { width, height },
      hasTouch: width < 1000,
      open: ['rings.obj', RINGS],
    });
    const views = () =>
      page.evaluate(() =>
        ['mesh-canvas', 'layout-canvas'].map((id) =>
          JSON.stringify(document.getElementById(id).getBoundingClientRect()),
        ),
      );
    const before = await views();
    await page.focus('#more-toggle');
    await page.keyboard.press('Enter');
    if (width > 1020) assert.deepEqual(await views(), before);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    // Without a density, the button for tiles is disabled.
    for (const id of [
      'fill-holes',
      'symmetric-seams',
      't',
      'texel-density',
      'up',
      'rotate',
      'rectify',
      'packing-cuts',
      'stack',
      'tiles',
      'straight-seams',
    ]) {
      await page.keyboard.press('Tab');
      assert.equal(await page.evaluate(() => document.activeElement.id), `more-${id}`);
      const box = await page.locator(`#more-${id}`).boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= width, `${id} is inside`);
    }
    for (const role of ['button', 'combobox', 'spinbutton', 'group'])
      assert.equal(await unnamed(page, role), 0, `each ${role} has a name`);
    if (width < 1000) await useByFinger(page);
  });
}

/** How many have no name. Counted again while some are added, which is between two counts. */
async function unnamed(page, role) {
  const count = (options) => page.getByRole(role, options).count();
  for (;;) {
    const all = await count();
    const named = await count({ name: /\w/ });
    if (all === (await count())) return all - named;
  }
}

/** Further options, which are open, are used and closed by taps. */
async function useByFinger(page) {
  const controls = page.locator('#more :is(button, select, input):visible');
  for (const control of await controls.all()) {
    const { width, height } = await control.boundingBox();
    assert.ok(width >= 44 && height >= 44, `${await control.getAttribute('id')} fits a finger`);
  }
  await page.tap('#more-straight-seams');
  await settled(page);
  assert.equal(await page.getAttribute('#more-straight-seams', 'aria-pressed'), 'true');
  assert.equal(await textOf(page, '#more-state'), 'straight seams');
  await page.tap('#more-toggle');
  assert.ok(await page.isHidden('#more'));
}

test('options are named only where they are not as usual; tiles need a density', async () => {
  const { changedOptions, defaultOptions, usedOptions } = await loadModule('model/more-options');
  const usual = defaultOptions();
  assert.deepEqual(changedOptions(usual), []);
  assert.deepEqual(changedOptions({ ...usual, udim: true, texelDensity: 7.5, rotate: 'none' }), [
    'texel density 7.5',
    'rotation none',
    'UDIM tiles',
  ]);
  assert.equal(usedOptions({ ...usual, udim: true }).udim, false);
  assert.equal(usedOptions({ ...usual, udim: true, texelDensity: 1 }).udim, true);
});

test('numbers are taken within the bounds of their option only', async () => {
  const { fits } = await loadModule('controls/number-field');
  const whole = { type: 'integer', atLeast: 0, atMost: 256 };
  for (const [value, expected] of [
    [0, true],
    [256, true],
    [257, false],
    [-1, false],
    [1.5, false],
    [Number.NaN, false],
  ])
    assert.equal(fits(value, whole), expected, String(value));
  assert.equal(fits(0, { type: 'number', above: 0 }), false);
  assert.equal(fits(1e-9, { type: 'number', above: 0 }), true);
});

test('tiles lie ten in a row, from 1001 on', async () => {
  const { tileAt, tileFrames, tileGrid } = await loadModule('mesh/tiles');
  assert.deepEqual(tileAt(0), { u: 0, v: 0, number: 1001 });
  assert.deepEqual(tileAt(23), { u: 3, v: 2, number: 1024 });
  assert.deepEqual(tileGrid(1), [1, 1]);
  assert.deepEqual(tileGrid(11), [10, 2]);
  const { points, sides } = tileFrames(12);
  assert.equal(points.length, 12 * 8);
  for (let i = 0; i < sides.length; i += 2) {
    const [a, b] = [sides[i], sides[i + 1]];
    const length = Math.hypot(points[2 * a] - points[2 * b], points[2 * a + 1] - points[2 * b + 1]);
    assert.equal(length, 1);
  }
});

test('settings are the same when every one of them is', async () => {
  const { sameSettings } = await loadModule('model/settings');
  const { defaultOptions } = await loadModule('model/more-options');
  const seamEdges = Uint32Array.of(0, 1);
  const a = { mode: 'unwrap', maxStretch: 1.1, seams: 'none', ...defaultOptions() };
  assert.ok(sameSettings(a, { ...a }));
  assert.ok(!sameSettings(a, { ...a, straightSeams: true }));
  assert.ok(!sameSettings(a, { ...a, seamEdges }));
  assert.ok(!sameSettings({ ...a, seamEdges }, a));
  assert.ok(sameSettings({ ...a, seamEdges }, { ...a, seamEdges }));
  assert.ok(!sameSettings(a, { mode: 'flatten', t: 1, delaunay: false }));
});
