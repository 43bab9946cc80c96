// The texel density that the page shows is that of the layout, and it says where charts differ.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { parseObj } from '../support/atlas.mjs';
import { exportMesh, metrics, openPage, settled, textOf } from './page.mjs';

/** A strip of squares with sides of 1. */
const SQUARES = 9;
const STRIP = [
  ...Array.from({ length: 2 * (SQUARES + 1) }, (_, i) => {
    return `v ${i % (SQUARES + 1)} ${Math.floor(i / (SQUARES + 1))} 0`;
  }),
  ...Array.from({ length: SQUARES }, (_, i) => {
    const [a, b] = [i + 1, i + SQUARES + 2];
    return `f ${a} ${a + 1} ${b + 1} ${b}`;
  }),
].join('\n');
/** Between its squares, from the one with that number. */
const between = (first) =>
  Array.from({ length: SQUARES - first }, (_, i) => `${first + i} ${first + i + SQUARES + 1}`).join(
    '\n',
  );
const SIZE = 1024;

async function cut(page, text) {
  await page.setInputFiles('#seams-file', {
    name: 'own.txt',
    mimeType: 'text/plain',
    buffer: Buffer.from(text),
  });
  const edges = text.split('\n').length;
  await page.waitForFunction(
    (edges) =>
      document.querySelector('#seams-state').textContent.startsWith(`seams edited: ${edges} `),
    edges,
  );
  await settled(page);
}

/** Texels per unit of each face, from the exported numbers. */
async function densities(page) {
  const obj = parseObj(readFileSync((await exportMesh(page)).path, 'utf8'));
  return obj.faces.map((face) => {
    const uv = face.map(([, t]) => obj.texcoords[t]);
    const area = uv.reduce((sum, [x, y], i) => {
      const [u, v] = uv[(i + 1) % uv.length];
      return sum + (x * v - u * y) / 2;
    }, 0);
    return SIZE * Math.sqrt(area);
  });
}

const shown = async (page) => Number((await metrics(page))['Texels per unit'].replace(',', ''));

/** All faces are as large on the surface. */
const meanOf = (each) => Math.sqrt(each.reduce((sum, d) => sum + d * d, 0) / each.length);

async function isMeasured(page) {
  const mean = meanOf(await densities(page));
  assert.ok(Math.abs((await shown(page)) / mean - 1) < 6e-3, `${await shown(page)} is ${mean}`);
}

test('an island that found too little room is said to be uneven, and one click mends it', async (t) => {
  const viewport = { width: 1440, height: 900 };
  const open = ['strip.obj', STRIP];
  const page = await openPage(t, { webgl: false, viewport, mode: 'unwrap', open });
  const views = () =>
    page.locator('.stage').evaluateAll((all) => all.map(({ clientHeight }) => clientHeight));
  const before = await views();
  await cut(page, between(1));
  assert.deepEqual(await views(), before, 'what is said of seams takes nothing from the views');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  await isMeasured(page);
  // Four squares in a row fit nowhere beside five that stay in a grid of three by three.
  await cut(page, between(4));
  assert.match(await textOf(page, '#run-text'), /, uneven/);
  const each = await densities(page);
  const [low, high] = [Math.min(...each), Math.max(...each)];
  assert.ok(high > 1.2 * low, `${low} to ${high}`);
  await isMeasured(page);
  assert.equal(await textOf(page, '#badge'), 'Uneven');
  assert.deepEqual(await views(), before, 'nor does a remedy');
  const [, least, most] = /^Texel density ([\d.]+) to ([\d.]+):/.exec(
    await textOf(page, '#reason'),
  );
  assert.ok(Math.abs(least / low - 1) < 0.01 && Math.abs(most / high - 1) < 0.01);
  await page.getByRole('button', { name: 'Repack', exact: true }).click();
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.ok(await page.isHidden('#remedy'));
  const packed = await densities(page);
  assert.ok(Math.max(...packed) < 1.01 * Math.min(...packed));
  await isMeasured(page);
});

test('a new island that finds too little room beside kept UVs is said to be uneven', async (t) => {
  const squares = [0, 2].flatMap((x) => [
    `v ${x} 0 0`,
    `v ${x + 1} 0 0`,
    `v ${x + 1} 1 0`,
    `v ${x} 1 0`,
  ]);
  const uv = ['vt 0 0', 'vt 0.9 0', 'vt 0.9 0.9', 'vt 0 0.9'];
  const faces = ['f 1/1 2/2 3/3 4/4', 'f 5 6 7 8'];
  const text = [...squares, ...uv, ...faces].join('\n');
  const page = await openPage(t, { webgl: false, mode: 'unwrap', open: ['half.obj', text] });
  assert.equal(await textOf(page, '#badge'), 'Valid');
  await page.click('#more-toggle');
  await page.click('#more-keep-uv');
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Uneven');
  assert.match(
    await textOf(page, '#reason'),
    /^Texel density [\d.]+ to 922: kept UVs keep theirs$/,
  );
  assert.ok(await page.isHidden('#remedy'), 'packing again would find no more room');
});
