// Each object or material of an atlas has a UDIM tile of its own.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { parseObj } from '../support/atlas.mjs';
import { sphere, torus } from '../support/surfaces.mjs';
import { middleOf } from './layout.mjs';
import { exportAs, exportMesh, openPage, pathOf, reload, settled, textOf } from './page.mjs';

/** Objects beside each other; each may have a material. */
function scene(parts) {
  const lines = [];
  let from = 1;
  parts.forEach(({ positions, faces, material }, i) => {
    lines.push(`o part ${i}`);
    if (material) lines.push(`usemtl ${material}`);
    lines.push(...positions.map(([x, y, z]) => `v ${x + 3 * i} ${y} ${z}`));
    lines.push(...faces.map((face) => `f ${face.map((v) => v + from).join(' ')}`));
    from += positions.length;
  });
  return `${lines.join('\n')}\n`;
}

const scaled = (mesh, by) => ({
  ...mesh,
  positions: mesh.positions.map((place) => place.map((x) => by * x)),
});
const PARTS = [torus(16, 8), scaled(sphere(4), 0.2), torus(12, 6)];

const openScene = async (t, parts, options) => {
  const page = await openPage(t, { mode: 'unwrap', open: ['scene.obj', scene(parts)], ...options });
  await page.click('#more-toggle');
  return page;
};

async function setTiles(page, tiles) {
  await page
    .locator(`#more-tiles option[value="${tiles}"]:not(:disabled)`)
    .waitFor({ state: 'attached' });
  await page.selectOption('#more-tiles', tiles);
  await settled(page);
}

/** The corners in uv of the faces of each part of the export. */
async function exported(page, parts) {
  const { texcoords, faces } = parseObj(readFileSync((await exportMesh(page)).path, 'utf8'));
  const uv = faces.map((face) => face.map(([, t]) => texcoords[t]));
  let from = 0;
  return parts.map(({ faces }) => {
    from += faces.length;
    return uv.slice(from - faces.length, from);
  });
}

const tilesOf = (faces) => [...new Set(faces.map((face) => Math.floor(middleOf(face)[0])))];

/** The longer side of the box around faces. */
function sizeOf(faces) {
  const sides = [0, 1].map((d) => {
    const along = faces.flat().map((corner) => corner[d]);
    return Math.max(...along) - Math.min(...along);
  });
  return Math.max(...sides);
}

const areTiled = (byPart) => {
  byPart.forEach((faces, i) => {
    assert.deepEqual(tilesOf(faces), [i], `part ${i} is in tile ${i}`);
    assert.ok(sizeOf(faces) > 0.9, 'which it fills');
  });
};

const info = (page) => textOf(page, '#layout-info');

test('each object fills a tile of its own; in the link, the files, after a reload and undone', async (t) => {
  const page = await openScene(t, PARTS, { own: true });
  assert.ok(!/tiles/.test(await info(page)));
  await setTiles(page, 'object');
  assert.match(await info(page), /, 3 tiles/);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.match(page.url(), /#unwrap&tiles=object$/);
  assert.equal(await textOf(page, '#more-state'), 'tiles per object');
  assert.ok(await page.isDisabled('#more-udim'));
  const tiled = await exported(page, PARTS);
  areTiled(tiled);
  assert.ok((await exportAs(page, 'glb')).bytes.length > 1000);
  await page.click('#undo');
  await settled(page);
  assert.ok(!/tiles/.test(await info(page)));
  await page.click('#redo');
  await settled(page);
  await reload(page);
  assert.match(await info(page), /, 3 tiles/);
  assert.equal(await page.inputValue('#more-tiles'), 'object');
  await exportAs(page, 'obj');
  assert.deepEqual(await exported(page, PARTS), tiled);
  await page.fill('#padding', '8');
  await settled(page);
  areTiled(await exported(page, PARTS));
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

test('what is scaled, repacked and locked stays in the tile of its object', async (t) => {
  const page = await openScene(t, PARTS, { viewport: { width: 1400, height: 900 } });
  await setTiles(page, 'object');
  await page.click('#more-toggle');
  await page.click('#details-toggle');
  await page.locator('#select-charts').waitFor();
  // The ball is small, so its tile has many times the texels of the others.
  const [, ball] = await exported(page, PARTS);
  await page.click('#tab-objects');
  await page.getByRole('button', { name: 'part 1', exact: true }).click();
  await page.fill('#selection-density', '0.5');
  await page.press('#selection-density', 'Enter');
  await settled(page);
  assert.equal(await page.inputValue('#selection-density'), '0.5');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  const [, smaller] = await exported(page, PARTS);
  assert.ok(Math.abs(sizeOf(smaller) / sizeOf(ball) - 0.5) < 0.1, 'compared with its own tile');
  await page.click('#tab-charts');
  await page.click('#pack-again');
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /^Repacked in/);
  const packed = await exported(page, PARTS);
  areTiled(packed);

  await page.locator('#charts tbody tr .lock').first().click();
  await page.fill('#padding', '8');
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  const now = await exported(page, PARTS);
  now.forEach((faces, i) => {
    assert.deepEqual(tilesOf(faces), [i]);
  });
  const same = (faces, i) => faces.filter((face, f) => `${face}` === `${packed[i][f]}`).length;
  const stayed = now.map(same);
  assert.ok(Math.max(...stayed) > 0, 'the locked island stays bit by bit');
  assert.ok(
    stayed.some((count, i) => count < PARTS[i].faces.length),
    'others do not',
  );
});

test('an edit of seams packs only the tiles whose islands it changes', async (t) => {
  const page = await openScene(t, PARTS);
  await setTiles(page, 'object');
  await page.click('#more-toggle');
  await page.click('#details-toggle');
  const before = await exported(page, PARTS);
  const [saved] = await Promise.all([page.waitForEvent('download'), page.click('#seams-save')]);
  const seams = readFileSync(await pathOf(saved), 'utf8');
  // Across the tube of the first ring, at two places.
  const loops = [5, 11].flatMap((u) =>
    Array.from({ length: 8 }, (_, v) => `${16 * v + u} ${16 * ((v + 1) % 8) + u}`),
  );
  await page.setInputFiles('#seams-file', {
    name: 'cut.txt',
    mimeType: 'text/plain',
    buffer: Buffer.from(`${seams}${loops.join('\n')}\n`),
  });
  await page.waitForFunction(() => document.querySelector('#seams-state').textContent !== '');
  await settled(page);
  const after = await exported(page, PARTS);
  assert.notDeepEqual(after[0], before[0], 'the ring is cut');
  assert.deepEqual(after.slice(1), before.slice(1), 'the others stay to the last digit');
  areTiled(after);
  assert.match(await textOf(page, '#badge'), /^(Valid|Stretched)$/);
  await page.click('#undo');
  await settled(page);
  assert.deepEqual(await exported(page, PARTS), before);
});

test('materials have tiles; equal parts that share texels share a tile', async (t) => {
  const [ring, ball] = PARTS;
  const parts = [
    { ...ring, material: 'red' },
    { ...ball, material: 'blue' },
    { ...ring, material: 'red' },
  ];
  const page = await openScene(t, parts);
  await setTiles(page, 'material');
  assert.match(await info(page), /, 2 tiles/);
  assert.deepEqual((await exported(page, parts)).map(tilesOf), [[0], [1], [0]]);
  await page.selectOption('#more-stack', 'identical');
  await settled(page);
  await setTiles(page, 'object');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.match(await textOf(page, '#reason'), /share their texels|stacked/);
  assert.match(await info(page), /, 2 tiles/);
  assert.deepEqual((await exported(page, parts)).map(tilesOf), [[0], [1], [0]]);
});

test('a mesh of one object has one tile, and a link does not change that', async (t) => {
  const page = await openPage(t, { mode: 'unwrap', open: ['one.obj', scene([PARTS[0]])] });
  await page.click('#more-toggle');
  assert.ok(await page.locator('#more-tiles option[value="object"]').isDisabled());
  await page.evaluate(() => {
    location.hash = '#unwrap&tiles=object';
  });
  await page.waitForFunction(() => document.querySelector('#more-tiles').value === 'object');
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.ok(!/tiles/.test(await info(page)));
});
