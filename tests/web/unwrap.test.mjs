// Any mesh becomes an atlas: charts in both views, options, numbers, repairs, and a file.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { runAbflat } from '../support/run-abflat.mjs';
import { sharedMesh, withoutShared } from '../support/shared.mjs';
import { CUBE, CUBE_OF_PARTS, grid, TETRAHEDRON } from '../support/small-meshes.mjs';
import { defects, objText, sphere, together, torus } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import {
  choose,
  drop,
  dropAndWait,
  exportMesh,
  metrics,
  openPage,
  openSample,
  settled,
  textOf,
} from './page.mjs';

const picture = (page, id) => page.locator(id).screenshot();
const TORUS = objText(torus(24, 12));

/** The colours of a canvas that cover more than a thousandth of it, as [hue, count]; hues in steps of 20 degrees. */
async function hues(page, id) {
  const bytes = (await picture(page, id)).toString('base64');
  return page.evaluate(async (bytes) => {
    const raw = Uint8Array.from(atob(bytes), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([raw]));
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const counts = new Map();
    for (let i = 0; i < data.length; i += 4) {
      const [r, g, b] = [data[i], data[i + 1], data[i + 2]];
      const [high, low] = [Math.max(r, g, b), Math.min(r, g, b)];
      if (high - low < 40) continue;
      const turn =
        high === r
          ? (g - b) / (high - low)
          : high === g
            ? 2 + (b - r) / (high - low)
            : 4 + (r - g) / (high - low);
      const hue = (Math.round((60 * turn + 360) / 20) * 20) % 360;
      counts.set(hue, (counts.get(hue) ?? 0) + 1);
    }
    return [...counts].filter(([, n]) => n > data.length / 4 / 1000).map(([hue]) => hue);
  }, bytes);
}

test('sharp edges stay chosen for the next mesh, and so does their angle', async (t) => {
  const page = await openPage(t, { mode: 'unwrap', open: ['one.obj', grid(3)] });
  await page.click('#seams-sharp');
  await page.fill('#sharp-degrees', '40');
  await page.press('#sharp-degrees', 'Enter');
  await settled(page);
  await dropAndWait(page, 'two.obj', grid(4));
  assert.equal(await page.getAttribute('#seams-sharp', 'aria-pressed'), 'true');
  assert.equal(await page.inputValue('#sharp-degrees'), '40');
});

test('a closed mesh is unwrapped, with its numbers, and cannot be flattened', async (t) => {
  const page = await openPage(t, { mode: 'flatten', open: ['torus.obj', TORUS] });
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.equal(await page.getAttribute('#mode-unwrap', 'aria-pressed'), 'true');
  assert.ok(await page.isDisabled('#mode-flatten'));
  assert.match(await page.getAttribute('#mode-flatten', 'title'), /^Needs an open surface\. /);
  assert.ok(await page.isHidden('#flatten-options'));
  assert.ok(await page.isVisible('#stretch'));
  assert.ok(await page.isHidden('#delaunay'));
  const shown = await metrics(page);
  assert.deepEqual(Object.keys(shown), [
    'Islands',
    'Stretch',
    'Space used',
    'Texels per unit',
    'Seam length',
    'Angular distortion',
    'Faces',
    'Energy',
  ]);
  assert.equal(shown.Faces, '576');
  assert.ok(Number(shown.Islands) >= 1);
  assert.ok(Number(shown['Seam length']) > 0);
  assert.ok(Number(shown.Stretch) >= 1 && Number(shown.Stretch) < 1.1);
  assert.match(shown['Space used'], /^\d+\.\d\s%$/);
  assert.equal(
    await textOf(page, '#layout-info'),
    `${shown.Islands} ${shown.Islands === '1' ? 'island' : 'islands'}`,
  );
  assert.match(await textOf(page, '#run-text'), /^Unwrapped in/);

  // A disk opened after that is flattened again, as chosen before.
  await dropAndWait(page, 'waves.obj', grid(4));
  assert.equal(await page.getAttribute('#mode-flatten', 'aria-pressed'), 'true');
  assert.ok(await page.isEnabled('#mode-flatten'));
  assert.match(await textOf(page, '#run-text'), /^Flattened in/);
  assert.ok(await page.isVisible('#delaunay'));
});

test('a disk that is stretched in one piece is unwrapped with one click', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  await openSample(page, 'three-balls');
  assert.equal(await textOf(page, '#badge'), 'Stretched');
  assert.match(await textOf(page, '#reason'), /^Lengths change by \d+\s% on average/);
  assert.match(await textOf(page, '#run-text'), /^Flattened in .*, stretched$/);
  await page.click('#remedy');
  await settled(page);
  assert.equal(await page.getAttribute('#mode-unwrap', 'aria-pressed'), 'true');
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

test('the user chooses for disks, and the choice stays', async (t) => {
  const page = await openPage(t, { mode: 'flatten', open: ['waves.obj', grid(6)] });
  const flat = await picture(page, '#layout-canvas');
  await page.click('#mode-unwrap');
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /^Unwrapped in/);
  assert.equal((await metrics(page)).Islands, '1');
  assert.notDeepEqual(await picture(page, '#layout-canvas'), flat);
  await dropAndWait(page, 'more.obj', grid(5));
  assert.match(await textOf(page, '#run-text'), /^Unwrapped in/);
  await page.focus('#mode-flatten');
  await page.keyboard.press('Enter');
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /^Flattened in/);
  assert.equal((await metrics(page)).Crossings, '0');
});

test('stretch, resolution and padding change the atlas, by keyboard as well', async (t) => {
  const page = await openPage(t, { open: ['ball.obj', objText(sphere(12))] });
  const usual = await metrics(page);
  assert.equal(await textOf(page, '#stretch-value'), '1.02');
  assert.match(await textOf(page, '#stretch-hint'), /^lengths off by up to 10\s%$/);
  await page.focus('#stretch');
  await page.keyboard.press('Home');
  await settled(page);
  assert.equal(await textOf(page, '#stretch-value'), '1.005');
  assert.match(
    await page.getAttribute('#stretch', 'aria-valuetext'),
    /^1\.005: lengths off by up to 5\s%$/,
  );
  const strict = await metrics(page);
  assert.ok(
    Number(strict['Seam length']) > Number(usual['Seam length']),
    'less stretch, more seams',
  );
  assert.ok(Number(strict.Stretch) < Number(usual.Stretch));
  await page.selectOption('#resolution', '2048');
  await settled(page);
  assert.equal(await page.inputValue('#padding'), '4', 'the same share of the resolution');
  const fine = await metrics(page);
  assert.ok(Number(fine['Texels per unit']) > 1.5 * Number(strict['Texels per unit']));
  await page.fill('#padding', '24');
  await settled(page);
  const apart = await metrics(page);
  assert.ok(parseFloat(apart['Space used']) < parseFloat(fine['Space used']));
  await page.fill('#padding', '9000');
  assert.equal(await page.getAttribute('#padding', 'aria-invalid'), 'true');
  await page.locator('#padding').blur();
  assert.equal(await page.inputValue('#padding'), '24');
  await page.selectOption('#resolution', '1024');
  await settled(page);
  assert.equal(await page.inputValue('#padding'), '24', 'it was set by hand');
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

test('above the limit the badge says so, and one click cuts further', async (t) => {
  const page = await openPage(t, {
    open: ['parts.obj', objText(torus(24, 12)).replace(/^f/m, 'usemtl a\nf')],
  });
  await page.click('#seams-auto');
  await settled(page);
  assert.equal(await textOf(page, '#seams-state'), 'fewest possible seams');
  assert.equal(await textOf(page, '#badge'), 'Stretched');
  assert.match(await textOf(page, '#reason'), /^Stretch \d\.\d+; limit 1\.02$/);
  assert.match(await textOf(page, '#stretch-hint'), /^not enforced/);
  const { Stretch } = await metrics(page);
  assert.ok(Number(Stretch) > 1.02);
  // The limit is what the user says, even if nothing is cut to keep it.
  await page.focus('#stretch');
  await page.keyboard.press('End');
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.ok(await page.isHidden('#remedy'));
  for (let i = 0; i < 7; i++) await page.keyboard.press('ArrowLeft');
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Stretched');
  await page.click('#remedy');
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.equal(await page.getAttribute('#seams-auto', 'aria-pressed'), 'true');
  assert.match(await textOf(page, '#stretch-hint'), /^lengths off by/);
});

test('islands have the same colours in both pictures, other than their neighbours', async (t) => {
  for (const colorScheme of ['dark', 'light']) {
    const page = await openPage(t, { colorScheme });
    const boxes = objText(
      together([0, 1, 2, 3].map((i) => [torus(16, 8), [2.6 * (i % 2), 2.6 * (i >> 1), 0]])),
    );
    await dropAndWait(page, 'rings.obj', boxes);
    const charts = Number((await metrics(page)).Islands);
    assert.ok(charts >= 4, `${charts} islands`);
    const inLayout = await hues(page, '#layout-canvas');
    const inMesh = await hues(page, '#mesh-canvas');
    assert.ok(inLayout.length >= 3, `hues of the layout: ${inLayout}`);
    const shared = inLayout.filter((hue) => inMesh.includes(hue));
    assert.ok(shared.length >= 3, `layout ${inLayout}, mesh ${inMesh}`);
    const plain = await picture(page, '#mesh-canvas');
    await page.selectOption('#shading', 'angle');
    assert.notDeepEqual(await picture(page, '#mesh-canvas'), plain);
  }
});

test('what was repaired is said in one line each', async (t) => {
  const page = await openPage(t, { open: ['broken.obj', objText(defects())] });
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  const button = await textOf(page, '#notes-button');
  assert.match(button, /^\d+ notes$/);
  await page.click('#notes-button');
  assert.ok(await page.isVisible('#panel-charts'));
  assert.equal(await page.evaluate(() => document.activeElement.id), 'tab-charts');
  const lines = await page.locator('#atlas-notes li').allInnerTexts();
  assert.equal(lines.length, Number.parseInt(button, 10));
  for (const pattern of [
    /^\d+ duplicate faces? (has its own island|have their own islands): faces? \d+/,
    /^\d+ edges? (has|have) more than two faces and became (a seam|seams): edges? \d+–\d+/,
    /^\d+ degenerate faces? uses? the UVs of neighbouring faces: faces? \d+/,
    /^\d+ edges? lies? between faces of opposite orientation and became (a seam|seams): /,
  ])
    assert.ok(
      lines.some((line) => pattern.test(line)),
      `${pattern} in ${JSON.stringify(lines)}`,
    );
  for (const line of lines) assert.match(line, /\.$/);
  assert.match(await textOf(page, '#charts-summary'), /^\d+ islands, the largest of/);
  // A mesh that is flattened has other tabs.
  await dropAndWait(page, 'waves.obj', grid(4));
  await choose(page, 'flatten');
  assert.ok(await page.isVisible('#panel-solver'));
  assert.ok(await page.isHidden('#tab-charts'));
});

test('the exported OBJ is that of the command line program', async (t) => {
  const page = await openPage(t, { settles: false });
  const path = tempFolder(t);
  for (const [name, text] of [
    ['torus.obj', TORUS],
    ['cube.obj', CUBE],
    ['tetrahedron.off', TETRAHEDRON],
  ]) {
    await dropAndWait(page, name, text);
    const exported = await exportMesh(page);
    assert.equal(exported.name, `${name.replace(/\..*/, '')}-uv.obj`);
    writeFileSync(path(name), text);
    const { code, stderr } = await runAbflat(['unwrap', path(name), '-o', path('out.obj')]);
    assert.equal(code, 0, stderr);
    assert.equal(readFileSync(exported.path, 'utf8'), readFileSync(path('out.obj'), 'utf8'), name);
  }
});

test('real meshes of every kind are unwrapped', { skip: withoutShared }, async (t) => {
  const page = await openPage(t);
  for (const file of [
    'spot-uv.obj',
    'suzanne-quads.obj',
    'beetle-nonmanifold.obj',
    'teapot-5parts.obj',
  ]) {
    await page.setInputFiles('#file', sharedMesh(file));
    await page.waitForFunction(
      (name) => document.querySelector('#source').textContent === name,
      file,
    );
    await settled(page);
    assert.equal(await textOf(page, '#alert'), '', file);
    assert.equal(await textOf(page, '#badge'), 'Valid', file);
    assert.equal(await page.getAttribute('#mode-unwrap', 'aria-pressed'), 'true', file);
  }
});

test('a run shows its stages, can be cancelled and done again', async (t) => {
  const page = await openPage(t);
  await drop(page, 'large.obj', objText(sphere(110)));
  await page.waitForFunction(
    () => /Finding seams|Solving/.test(document.querySelector('#run-text').textContent),
    null,
    { polling: 20 },
  );
  assert.ok(await page.evaluate(() => document.querySelector('#progress').value > 0));
  await page.keyboard.press('Escape');
  await settled(page);
  assert.equal(await textOf(page, '#run-text'), 'Cancelled');
  assert.equal(await textOf(page, '#again'), 'Unwrap');
  await dropAndWait(page, 'torus.obj', TORUS);
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

for (const [name, width, height] of [
  ['a small screen', 1280, 720],
  ['a phone', 390, 844],
  ['a narrow phone', 360, 740],
]) {
  test(`${name}: sources of seams stay in their panel, and the verdict can be read`, async (t) => {
    const page = await openPage(t, {
      viewport: { width, height },
      hasTouch: width < 1000,
      open: ['parts.obj', CUBE_OF_PARTS],
    });
    await page.click('#seams-sharp');
    await settled(page);
    const panel = await page.locator('.ask').boundingBox();
    for (const id of ['seams-auto', 'seams-uv', 'seams-material', 'seams-sharp', 'sharp-box']) {
      const box = await page.locator(`#${id}`).boundingBox();
      assert.ok(box.x >= panel.x && box.x + box.width <= panel.x + panel.width, `${id} is inside`);
      const line = width < 1000 ? 44 : 30; // high enough for a finger
      assert.ok(box.height <= line, `${id} is of one line`);
    }
    await dropAndWait(page, 'torus.obj', TORUS);
    await page.click('#seams-auto');
    await settled(page);
    for (const id of ['badge', 'reason', 'remedy', 'stretch-hint']) {
      const hidden = await page
        .locator(`#${id}`)
        .evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth);
      assert.ok(hidden <= 0, `${id} can be read in full`);
    }
  });

  test(`${name}: the options of an atlas fit, and can be reached by Tab`, async (t) => {
    const page = await openPage(t, {
      viewport: { width, height },
      hasTouch: width < 1000,
      open: ['torus.obj', TORUS],
    });
    const overflow = await page.evaluate(
      () => document.documentElement.scrollWidth - window.innerWidth,
    );
    assert.ok(overflow <= 0, 'no horizontal scrolling');
    for (const id of [
      'mode-unwrap',
      'stretch',
      'resolution',
      'padding',
      'export',
      'layout-canvas',
    ]) {
      await page.locator(`#${id}`).scrollIntoViewIfNeeded();
      const box = await page.locator(`#${id}`).boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= width, `${id} is inside`);
    }
    await page.focus('#stretch');
    for (const id of ['unwrap-balance', 'resolution', 'padding']) {
      await page.keyboard.press('Tab');
      assert.equal(await page.evaluate(() => document.activeElement.id), id);
    }
    for (const role of ['button', 'slider', 'combobox', 'spinbutton', 'img', 'group']) {
      const all = await page.getByRole(role).all();
      const named = await page.getByRole(role, { name: /\w/ }).all();
      assert.ok(all.length > 0, role);
      assert.equal(named.length, all.length, `each ${role} has a name`);
    }
  });
}
