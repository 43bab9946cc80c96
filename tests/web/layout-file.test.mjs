// The atlas as a picture: the saved file has its charts, sizes and colours.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { parseObj } from '../support/atlas.mjs';
import { parsePng } from '../support/png.mjs';
import { grid } from '../support/small-meshes.mjs';
import { objText, sphere, together, torus } from '../support/surfaces.mjs';
import { loadModule } from './modules.mjs';
import {
  choose,
  dropAndWait,
  exportMesh,
  metrics,
  openPage,
  pathOf,
  settled,
  textOf,
} from './page.mjs';

const RINGS = together([0, 1].map((i) => [torus(16, 8), [2.6 * i, 0, 0]]));

/** Saves with a button; returns name and bytes. */
async function save(page, id) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(id)]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await pathOf(download)) };
}

const middle = (points) =>
  [0, 1].map((d) => points.reduce((sum, point) => sum + point[d], 0) / points.length);

/** The middle of each face of the atlas, in uv. */
async function centers(page) {
  const { path } = await exportMesh(page);
  const { texcoords, faces } = parseObj(readFileSync(path, 'utf8'));
  return faces.map((face) => middle(face.map(([, t]) => texcoords[t])));
}

/** The colours of the picture at these points. */
function colorsAt({ width, height, at }, uvs) {
  return uvs.map(([u, v]) => at(Math.floor(width * u), Math.floor(height * (1 - v))));
}

function opaqueShare({ width, height, at }) {
  let opaque = 0;
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) opaque += Number(at(x, y)[3] === 255);
  return opaque / (width * height);
}

test('the PNG has a pixel per texel: islands are painted, the rest is clear', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  assert.ok(await page.isHidden('#layout-tools'), 'a disk in one piece is no atlas');
  await dropAndWait(page, 'rings.obj', objText(RINGS));
  await page.selectOption('#resolution', '512');
  await settled(page);
  const { name, bytes } = await save(page, '#layout-png');
  assert.equal(name, 'rings-layout.png');
  await page.waitForFunction(() =>
    /^Saved rings-layout\.png, 512.×.512.px$/.test(document.querySelector('#run-text').textContent),
  );
  const image = parsePng(bytes);
  assert.deepEqual([image.width, image.height], [512, 512]);
  const pixels = colorsAt(image, await centers(page));
  for (const [, , , alpha] of pixels) assert.equal(alpha, 255);
  // Outlines reach a pixel beyond the charts.
  const opaque = opaqueShare(image);
  const covered = parseFloat((await metrics(page))['Space used']) / 100;
  assert.ok(opaque > covered - 0.02 && opaque < covered + 0.1, `${opaque} of ${covered}`);
  assert.ok(new Set(pixels.map(String)).size >= 2, 'islands have colours of their own');
});

test('the SVG has the size of the surface, a group for each island', async (t) => {
  const page = await openPage(t, { open: ['rings.obj', objText(RINGS)] });
  await page.focus('#layout-svg');
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'layout-scale');
  await page.keyboard.type('25.4');
  const { name, bytes } = await save(page, '#layout-svg');
  assert.equal(name, 'rings-layout.svg');
  const drawn = await page.evaluate((text) => {
    const root = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
    const [, , across] = root.getAttribute('viewBox').split(' ').map(Number);
    const areaOf = (d) =>
      d
        .split('M')
        .slice(1)
        .reduce((sum, run) => {
          const points = run
            .replace('Z', '')
            .split('L')
            .map((point) => point.split(' ').map(Number));
          return points.reduce((part, [x, y], i) => {
            const [a, b] = points[(i + 1) % points.length];
            return part + (x * b - a * y) / 2;
          }, sum);
        }, 0);
    return {
      groups: root.querySelectorAll('g').length,
      width: root.getAttribute('width'),
      across,
      area: [...root.querySelectorAll('.area')]
        .map((path) => Math.abs(areaOf(path.getAttribute('d'))))
        .reduce((sum, area) => sum + area, 0),
    };
  }, bytes.toString());
  assert.equal(String(drawn.groups), (await metrics(page)).Islands);
  assert.match(drawn.width, /^[\d.]+mm$/);
  const mm = parseFloat(drawn.width) / drawn.across;
  const { triangleAreas } = await loadModule('mesh/mesh');
  const surface = triangleAreas(
    Float64Array.from(RINGS.positions.flat()),
    3,
    Uint32Array.from(RINGS.faces.flat()),
  ).reduce((sum, area) => sum + area, 0);
  const ratio = (drawn.area * mm * mm) / (surface * 25.4 * 25.4);
  assert.ok(Math.abs(ratio - 1) < 1e-3, `drawn ${ratio} of the surface`);

  await page.fill('#layout-scale', '');
  const plain = (await save(page, '#layout-svg')).bytes.toString();
  assert.match(plain, /<svg [^>]*width="1024" height="1024"/);
});

test('the heat map is white where areas are kept, and shows where they are not', async (t) => {
  const page = await openPage(t, {
    open: ['flat.obj', grid(6).replace(/^(v \S+ \S+) .*$/gm, '$1 0')],
  });
  await page.click('#mode-unwrap');
  await settled(page);
  const flat = await save(page, '#layout-heat');
  assert.equal(flat.name, 'flat-heat-map.png');
  for (const pixel of colorsAt(parsePng(flat.bytes), await centers(page)))
    assert.deepEqual(pixel, [0xf7, 0xf7, 0xf7, 255]);
  await dropAndWait(page, 'ball.obj', objText(sphere(12)));
  await page.focus('#stretch');
  await page.keyboard.press('End');
  await settled(page);
  const { bytes } = await save(page, '#layout-heat');
  const pixels = colorsAt(parsePng(bytes), await centers(page));
  assert.ok(
    pixels.some(([r, , b]) => r > b + 20),
    'somewhere area is gained',
  );
  assert.ok(
    pixels.some(([r, , b]) => b > r + 20),
    'somewhere it is lost',
  );
});

for (const [name, width, height] of [
  ['a small screen', 1280, 720],
  ['a narrow phone', 360, 740],
]) {
  test(`${name}: the bar below the layout fits, and belongs to atlases only`, async (t) => {
    const page = await openPage(t, {
      viewport: { width, height },
      hasTouch: width < 1000,
      open: ['rings.obj', objText(RINGS)],
    });
    for (const id of ['layout-png', 'layout-heat', 'layout-svg', 'layout-scale']) {
      const box = await page.locator(`#${id}`).boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= width, `${id} is inside`);
      const bar = await page.locator('#layout-tools').boundingBox();
      assert.ok(box.x + box.width <= bar.x + bar.width, `${id} is within its bar`);
    }
    const tools = await page.locator('#layout-tools').boundingBox();
    const seams = await page.locator('#seam-tools').boundingBox();
    // On a phone the hint below the mesh has a line of its own.
    if (width > 700) assert.equal(tools.height, seams.height, 'the bars of both views are alike');
    await dropAndWait(page, 'waves.obj', grid(4));
    await choose(page, 'flatten');
    assert.ok(await page.isHidden('#layout-tools'));
    assert.match(await textOf(page, '#run-text'), /^Flattened/);
  });
}

test('chains have every edge once', async () => {
  const { chains } = await loadModule('files/chains');
  // Two triangles that meet at a point, and a loose edge.
  const pairs = [0, 1, 1, 2, 2, 0, 2, 3, 3, 4, 4, 2, 6, 5];
  for (const bothWays of [false, true]) {
    const found = chains(pairs, bothWays);
    const edges = found.flatMap((chain) =>
      chain.slice(1).map((to, i) => [chain[i], to].sort().join('-')),
    );
    assert.deepEqual(edges.sort(), ['0-1', '0-2', '1-2', '2-3', '2-4', '3-4', '5-6']);
  }
  assert.deepEqual(chains([0, 1, 2, 1], true), [[0, 1, 2]]);
  assert.equal(chains([0, 1, 2, 1], false).length, 2);
});

test('outlines enclose their islands, edges inside are those of faces', async () => {
  const { chartLines } = await loadModule('files/chart-lines');
  // Two quads side by side, each of two triangles; the second one is a separate chart that touches
  // the first.
  const shape = {
    uv: Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1, 1, 0, 2, 0, 2, 1, 1, 1),
    indices: Uint32Array.of(0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7),
    charts: Uint32Array.of(0, 0, 1, 1),
    chartCount: 2,
  };
  for (const { outline, inner } of chartLines(shape)) {
    assert.equal(outline.length, 1);
    assert.equal(outline[0].length, 5);
    assert.equal(outline[0][0], outline[0][4], 'closed');
    assert.equal(inner.length, 1, 'the diagonal');
  }
  const ofQuads = chartLines({ ...shape, faces: Uint32Array.of(0, 0, 1, 1) });
  assert.deepEqual(
    ofQuads.map(({ inner }) => inner.length),
    [0, 0],
  );
  const one = chartLines({ ...shape, charts: Uint32Array.of(0, 0, 0, 0), chartCount: 1 });
  assert.equal(one[0].outline[0].length, 7, 'around both');
});

test('colours of areas do not depend on the scale, and end at half and double', async () => {
  const { heatSteps, heatColor, HEAT_STEPS } = await loadModule('files/heat');
  const areas = Float64Array.of(1, 2, 3);
  const middle = (HEAT_STEPS - 1) / 2;
  assert.deepEqual(
    [
      ...heatSteps(
        areas,
        areas.map((x) => 7 * x),
      ),
    ],
    [middle, middle, middle],
  );
  const inUv = Float64Array.of(1e-3, 100, 0);
  const [low, high, none] = heatSteps(Float64Array.of(50, 50.001, 0), inUv);
  assert.deepEqual([low, high, none], [0, HEAT_STEPS - 1, -1]);
  assert.equal(heatColor(0), 'rgb(33 102 172)');
  assert.equal(heatColor(HEAT_STEPS - 1), 'rgb(178 24 43)');
  assert.equal(heatColor(middle), 'rgb(247 247 247)');
});

test('a picture that no browser can draw is refused with what to do', async () => {
  const { pictureSize } = await loadModule('files/picture-size');
  assert.deepEqual(pictureSize({ resolution: 4096, tiles: 3 }), { width: 12288, height: 4096 });
  assert.throws(
    () => pictureSize({ resolution: 4096, tiles: 5 }),
    /at most 16384 pixels per side\. Lower the resolution, or save SVG/,
  );
});
