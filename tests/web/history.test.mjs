// Undo, redo and the history in the page; what an edit of seams leaves in place.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { parseObj } from '../support/atlas.mjs';
import { objText, sphere, together, torus } from '../support/surfaces.mjs';
import { arrangeAll } from './layout.mjs';
import { dropAndWait, exportMesh, metrics, openPage, pathOf, settled, textOf } from './page.mjs';

const BOTH = objText(
  together([
    [torus(24, 12), [0, 0, 0]],
    [sphere(6), [3, 0, 0]],
  ]),
);

async function exported(page) {
  const { path } = await exportMesh(page);
  return readFileSync(path, 'utf8');
}

const lines = (page) => page.locator('#history .step').allInnerTexts();

test('every control is undone and done again, with its earlier result', async (t) => {
  const page = await openPage(t, { open: ['both.obj', BOTH] });
  assert.ok(await page.isDisabled('#undo'));
  const states = [await exported(page)];
  const shown = () =>
    page.evaluate(() =>
      [
        ...document.querySelectorAll(
          '.dock input, .dock select, .dock [aria-pressed], .dock output',
        ),
      ].map((each) => `${each.id} ${each.value} ${each.ariaPressed}`),
    );
  const asked = [await shown()];
  const change = async (action) => {
    await action();
    await settled(page);
    states.push(await exported(page));
    asked.push(await shown());
  };
  await change(async () => {
    await page.focus('#stretch');
    await page.keyboard.press('End');
  });
  await change(() => page.selectOption('#resolution', '512'));
  await change(() => page.fill('#padding', '9'));
  await change(() => page.click('#seams-sharp'));
  await change(async () => {
    await page.click('#more-toggle');
    await page.selectOption('#more-fill-holes', 'never');
  });
  await change(() => page.selectOption('#more-rotate', 'none'));
  await change(() => page.fill('#more-texel-density', '20'));
  await page.focus('#mesh-canvas');
  const walk = async (key, from, to) => {
    for (let i = from; i !== to; i += Math.sign(to - from)) {
      const next = i + Math.sign(to - from);
      await page.keyboard.press(key);
      await settled(page);
      assert.match(await textOf(page, '#run-text'), to < from ? /^Undone: / : /^Redone: /);
      assert.deepEqual(await shown(), asked[next], `controls of step ${next}`);
      assert.equal(await exported(page), states[next], `layout of step ${next}`);
    }
  };
  const last = states.length - 1;
  await walk('Control+z', last, 0);
  assert.ok((await page.isDisabled('#undo')) && (await page.isEnabled('#redo')));
  await walk('Control+Shift+z', 0, last);
  assert.ok((await page.isEnabled('#undo')) && (await page.isDisabled('#redo')));
});

test('the history lists the steps, leads back to each, and starts over with another mesh', async (t) => {
  const page = await openPage(t, { open: ['both.obj', BOTH] });
  await page.click('#details-toggle');
  await page.click('#tab-history');
  await page.selectOption('#resolution', '512');
  await settled(page);
  await page.click('#seams-sharp');
  await settled(page);
  const all = ['Open both.obj', 'Resolution 512\u202fpx', 'Seams: auto, sharp=60'];
  assert.deepEqual(await lines(page), all);
  const current = page.locator('#history [aria-current="step"]');
  assert.equal(await current.innerText(), all[2]);
  assert.match(
    await page.getAttribute('#undo', 'title'),
    /Undo: Seams: auto, sharp=60 \(Ctrl\+Z\)/,
  );
  await page.locator('#history .step').first().click();
  await settled(page);
  assert.equal(await textOf(page, '#run-text'), `Undone: ${all[2]}`);
  assert.equal(await page.inputValue('#resolution'), '1024');
  assert.equal(await page.getAttribute('#seams-sharp', 'aria-pressed'), 'false');
  assert.deepEqual(await lines(page), all, 'what was undone can be done again');
  assert.equal(await current.innerText(), all[0]);
  await page.locator('#history .step').nth(1).press('Enter');
  await settled(page);
  assert.equal(await page.inputValue('#resolution'), '512');
  assert.equal(await current.evaluate((item) => item === document.activeElement), true);
  await dropAndWait(page, 'again.obj', BOTH);
  assert.deepEqual(await lines(page), ['Open again.obj']);
  assert.ok((await page.isDisabled('#undo')) && (await page.isDisabled('#redo')));
});

test('a lock, the kind of layout and t are undone as well', async (t) => {
  const page = await openPage(t);
  const pressed = (id) => page.getAttribute(id, 'aria-pressed');
  await page.click('#details-toggle');
  await page.locator('.lock').first().click();
  assert.equal(await page.locator('.lock[aria-pressed="true"]').count(), 1);
  await page.click('#mode-flatten');
  await settled(page);
  await page.fill('#t-number', '1.25');
  await settled(page);
  const distortion = await metrics(page);
  await page.click('#delaunay');
  await settled(page);
  const undo = async () => {
    await page.click('#undo');
    await settled(page);
  };
  await undo();
  assert.equal(await pressed('#delaunay'), 'false');
  assert.deepEqual(await metrics(page), distortion);
  await undo();
  assert.equal(await pressed('#t-auto'), 'true');
  await undo();
  assert.equal(await pressed('#mode-unwrap'), 'true');
  assert.ok(await page.isEnabled('#seam-cut'), 'seams can be edited again');
  assert.equal(await page.locator('.lock[aria-pressed="true"]').count(), 1);
  await undo();
  assert.equal(await page.locator('.lock[aria-pressed="true"]').count(), 0);
  assert.ok(await page.isDisabled('#undo'));
});

test('each kind of layout is as it was left, without a run, until something else is wanted of it', async (t) => {
  const page = await openPage(t);
  const undo = async () => {
    await page.click('#undo');
    await settled(page);
  };
  await arrangeAll(page, 's', '.5');
  await settled(page);
  const arranged = await exported(page);
  await page.click('#mode-flatten');
  await settled(page);
  await page.fill('#t-number', '1.25');
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /^Flattened in/);
  const flat = await exported(page);
  await page.click('#mode-unwrap');
  await settled(page);
  assert.equal(await textOf(page, '#run-text'), 'This layout is as you left it');
  assert.equal(await exported(page), arranged);
  assert.ok(await page.isEnabled('#seam-cut'));
  await page.click('#mode-flatten');
  await settled(page);
  assert.equal(await textOf(page, '#run-text'), 'This layout is as you left it');
  assert.equal(await exported(page), flat);
  await undo();
  assert.equal(await exported(page), arranged);
  // Other settings need a run, after which the arrangement is gone.
  await page.selectOption('#resolution', '512');
  await settled(page);
  const other = await exported(page);
  assert.notEqual(other, arranged);
  await page.click('#mode-flatten');
  await settled(page);
  await page.click('#mode-unwrap');
  await settled(page);
  assert.equal(await exported(page), other);
  for (let i = 0; i < 3; ++i) await undo();
  assert.equal(await exported(page), arranged);
});

test('undo during a run shows what was there before', async (t) => {
  const page = await openPage(t, { open: ['ball.obj', objText(sphere(60))] });
  const before = await exported(page);
  await page.click('#seams-sharp');
  await page.fill('#sharp-degrees', '3');
  await page.focus('#mesh-canvas');
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal(await exported(page), before);
  assert.ok(await page.isDisabled('#undo'));
});

test('an edit of seams moves no island that it leaves as it is', async (t) => {
  const page = await openPage(t, { open: ['both.obj', BOTH] });
  await page.click('#details-toggle');
  const cornersOf = (text) => {
    const { faces, texcoords } = parseObj(text);
    return faces.map((face) => JSON.stringify(face.map(([, uv]) => texcoords[uv])));
  };
  const before = cornersOf(await exported(page));
  // Removes a seam of one chart: that of the edges listed without it.
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#seams-save')]);
  const seams = readFileSync(await pathOf(download), 'utf8')
    .trim()
    .split('\n');
  const isComment = (line) => line.startsWith('#');
  // Vertices of the torus come first.
  const ofTorus = 24 * 12;
  const kept = seams.filter((line) => isComment(line) || Number(line.split(/\s+/)[0]) < ofTorus);
  assert.ok(kept.length < seams.length && kept.length > 1);
  await page.setInputFiles('#seams-file', {
    name: 'some.txt',
    mimeType: 'text/plain',
    buffer: Buffer.from(kept.join('\n')),
  });
  await page.waitForFunction(() => document.querySelector('#seams-state').textContent);
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /kept$/);
  const after = cornersOf(await exported(page));
  const stays = after.filter((corners, f) => corners === before[f]).length;
  assert.ok(stays >= 2 * ofTorus, `${stays} of ${after.length} faces stay`);
  assert.ok(stays < after.length, 'the sphere is laid out anew');
  // All are packed anew only when asked.
  await page.click('#pack-again');
  await settled(page);
  assert.doesNotMatch(await textOf(page, '#run-text'), /kept/);
  const packed = cornersOf(await exported(page));
  assert.ok(packed.filter((corners, f) => corners === before[f]).length < stays);
  await page.click('#undo');
  await settled(page);
  assert.deepEqual(cornersOf(await exported(page)), after);
});
