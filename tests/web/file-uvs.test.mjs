// The UVs that a file has: shown as they are, judged, and packed again.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { complaints, parseObj } from '../support/atlas.mjs';
import { accessor, addMesh, emptyDocument, io, primitiveOf } from '../support/gltf.mjs';
import { CUBE } from '../support/small-meshes.mjs';
import {
  choose,
  dropAndWait,
  exportAs,
  exportMesh,
  metrics,
  openPage,
  reload,
  settled,
  textOf,
} from './page.mjs';
import { CORNERS, squares } from './squares.mjs';

const OVERLAPPING = [
  [0.1, 0.1, 0.3, 0.2],
  [0.35, 0.1, 0.3, 0.3],
];
const OUTSIDE = [1.5, -0.25, 0.25, 0.5];
const MIRRORED = [0.9, 0.6, -0.25, 0.25];
const EMPTY = [0.75, 0.25, 0.125, 0];
const FAULTY = squares([...OVERLAPPING, OUTSIDE, MIRRORED, EMPTY]);
/** Nothing is wrong with these but where they are. */
const MISPLACED = squares([...OVERLAPPING, OUTSIDE]);

const isPressed = (page, id) => page.locator(id).getAttribute('aria-pressed');

async function pack(page) {
  await page.click('#pack-islands');
  await settled(page);
}

/** The lengths in uv of the edges of each face. */
function edgesOf({ texcoords, faces }) {
  return faces.map((face) =>
    face.map(([, t], k) => {
      const [a, b] = [texcoords[t], texcoords[face[(k + 1) % face.length][1]]];
      return Math.hypot(a[0] - b[0], a[1] - b[1]);
    }),
  );
}

/** Whether the boxes of two faces have more than their sides in common. */
function overlaps({ texcoords, faces }) {
  const boxes = faces.map((face) =>
    [0, 1].map((d) => {
      const values = face.map(([, t]) => texcoords[t][d]);
      return [Math.min(...values), Math.max(...values)];
    }),
  );
  return boxes.some((a, i) =>
    boxes.slice(0, i).some((b) => a.every(([low, high], d) => low < b[d][1] && b[d][0] < high)),
  );
}

test('islands that overlap, are mirrored, empty or outside are counted and marked', async (t) => {
  const page = await openPage(t, { open: ['faulty.obj', FAULTY] });
  await choose(page, 'pack');
  const shown = await metrics(page);
  const { Islands, Overlapping, Outside, Flipped, Empty, Faces } = shown;
  assert.deepEqual(
    [Islands, Overlapping, Outside, Flipped, Empty, Faces],
    ['5', '2', '1', '1', '1', '5'],
  );
  assert.equal(await textOf(page, '#badge'), 'Not valid');
  const faults = '2 faces overlap, 1 face outside the square, 1 face without area, 1 face flipped';
  assert.equal(await textOf(page, '#reason'), faults);
  assert.match(await textOf(page, '#run-text'), /^Checked in .*, not valid$/);
  assert.equal(await textOf(page, '#layout-info'), '5 islands');
  assert.deepEqual((await textOf(page, '#marks')).split(/\n+/), faults.split(', '));
  for (const fault of ['overlapping', 'outside', 'empty', 'flipped'])
    assert.equal(await page.locator(`#marks .${fault}`).count(), 1, fault);
  await pack(page);
  assert.ok(await page.isHidden('#marks'));
  assert.equal(await textOf(page, '#reason'), 'No overlaps, 1 mirrored', 'on purpose, perhaps');
});

test('islands that are stacked on purpose are told from those that overlap, and all are listed', async (t) => {
  const place = [0.1, 0.1, 0.25, 0.25];
  const mirrored = [0.35, 0.1, -0.25, 0.25];
  const apart = [
    [0.5, 0.5, 0.25, 0.25],
    [0.7, 0.7, 0.125, 0.125],
  ];
  const page = await openPage(t, {
    open: ['stacked.obj', squares([place, place, mirrored, ...apart])],
  });
  await choose(page, 'pack');
  const { Overlapping, Stacked, Flipped } = await metrics(page);
  assert.deepEqual([Overlapping, Stacked, Flipped], ['2', '3', '1']);
  const faults = '2 faces overlap, 3 faces stacked, 1 face flipped';
  assert.equal(await textOf(page, '#reason'), faults);
  assert.deepEqual((await textOf(page, '#marks')).split(/\n+/), faults.split(', '));

  await page.click('#details-toggle');
  await page.locator('.island-table tbody tr').nth(4).waitFor();
  const rows = () =>
    page
      .locator('.island-table tbody tr')
      .evaluateAll((rows) =>
        rows.map((row) => [...row.cells].map((cell) => cell.innerText.trim())),
      );
  const byNumber = new Map((await rows()).map((row) => [row[0], row]));
  assert.deepEqual(
    [0, 1, 2, 3, 4].map((i) => byNumber.get(String(i))[4]),
    [
      'stacked with 1 and 2',
      'stacked with 0 and 2',
      '2 flipped, stacked with 0 and 1',
      '2 overlap',
      '2 overlap',
    ],
  );
  assert.equal(byNumber.get('0')[2], '20\u202f%');
  // Squares of side 1 in a texture of 1,024 texels.
  assert.deepEqual(
    [0, 3, 4].map((i) => byNumber.get(String(i))[3]),
    ['256', '256', '128'],
  );
  await page.getByRole('button', { name: 'Texels', exact: true }).click();
  assert.equal((await rows()).at(-1)[0], '4');
  await page.getByRole('button', { name: 'Show island 4' }).click();
  // Where something else lies on a stack, all that overlaps is called so.
  await dropAndWait(page, 'more.obj', squares([place, place, [0.3, 0.3, 0.25, 0.25]]));
  await choose(page, 'pack');
  const more = await metrics(page);
  assert.deepEqual([more.Overlapping, more.Stacked], ['3', '0']);
});

test('islands in UDIM tiles are not outside', async (t) => {
  const tiles = [
    [0.1, 0.1, 0.25, 0.25],
    [1.5, 0.5, 0.25, 0.25],
    [2.25, 1.5, 0.5, 0.25],
  ];
  const page = await openPage(t, { open: ['tiles.obj', squares(tiles)] });
  await choose(page, 'pack');
  assert.equal((await metrics(page)).Outside, '0');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.equal(await textOf(page, '#layout-info'), '3 islands, 13 tiles');
  const { path } = await exportMesh(page);
  assert.deepEqual(
    parseObj(readFileSync(path, 'utf8')).texcoords,
    parseObj(squares(tiles)).texcoords,
  );
  // Over the edge of a tile, it is.
  await dropAndWait(page, 'over.obj', squares([...tiles, [2.9, 0.5, 0.25, 0.25]]));
  await choose(page, 'pack');
  assert.equal((await metrics(page)).Outside, '3');
});

test('faces without UVs are left out of the layout, and a note counts them', async (t) => {
  const bare = `${squares(OVERLAPPING)}v 9 9 0\nv 10 9 0\nv 9 10 0\nf -3 -2 -1\n`;
  const page = await openPage(t, { open: ['bare.obj', bare] });
  await choose(page, 'pack');
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal((await metrics(page)).Islands, '2');
  await page.click('#notes-button');
  assert.match(await textOf(page, '#islands-notes'), /^1 face has no UVs/);
  await pack(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

test('UVs are exported as they are, bit by bit', async (t) => {
  const page = await openPage(t, { open: ['faulty.obj', FAULTY] });
  await choose(page, 'pack');
  const { path } = await exportMesh(page);
  const [before, now] = [FAULTY, readFileSync(path, 'utf8')].map(parseObj);
  assert.deepEqual(now.texcoords, before.texcoords);
  assert.deepEqual(now.faces, before.faces);
});

test('Repack separates islands, keeps their shapes, and is undone like anything else', async (t) => {
  const page = await openPage(t, { open: ['misplaced.obj', MISPLACED] });
  await choose(page, 'pack');
  assert.equal(await page.isVisible('#pack-padding'), false);
  await page.click('#remedy');
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.match(await textOf(page, '#run-text'), /^Repacked in /);
  const { path } = await exportMesh(page);
  const packed = readFileSync(path, 'utf8');
  assert.deepEqual(complaints(packed), []);
  assert.equal(overlaps(parseObj(packed)), false);
  const [before, now] = [MISPLACED, packed].map((text) => edgesOf(parseObj(text)).flat());
  const scale = now[0] / before[0];
  assert.ok(scale > 1, 'there was room');
  before.forEach((length, i) => {
    assert.ok(Math.abs(now[i] / (scale * length) - 1) < 1e-9, `edge ${i}`);
  });

  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Not valid');
  assert.equal(await isPressed(page, '#pack-keep'), 'true');
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal(await isPressed(page, '#mode-unwrap'), 'true');
  assert.ok((await metrics(page)).Islands);
  for (let i = 0; i < 2; ++i) {
    await page.keyboard.press('Control+Shift+z');
    await settled(page);
  }
  assert.equal(await isPressed(page, '#pack-islands'), 'true');
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

test('the options of packing are followed, and stay after a reload', async (t) => {
  const page = await openPage(t, { open: ['misplaced.obj', MISPLACED] });
  await choose(page, 'pack');
  await pack(page);
  const sidesOf = async () => {
    const { path } = await exportMesh(page);
    return edgesOf(parseObj(readFileSync(path, 'utf8'))).map(([width]) => width);
  };
  const [a, , c] = await sidesOf();
  assert.ok(Math.abs(c / a - 0.25 / 0.3) < 1e-9);
  await page.selectOption('#pack-sizes', 'even');
  await settled(page);
  // The squares are of one size, so the areas in uv are.
  const areas = async () => {
    const { path } = await exportMesh(page);
    return edgesOf(parseObj(readFileSync(path, 'utf8'))).map(([w, h]) => w * h);
  };
  const [first, ...others] = await areas();
  for (const area of others) assert.ok(Math.abs(area / first - 1) < 1e-9);
  await page.fill('#pack-padding', '64');
  await settled(page);
  assert.ok((await areas())[0] < first);
  await reload(page);
  assert.equal(await isPressed(page, '#pack-islands'), 'true');
  assert.equal(await page.inputValue('#pack-padding'), '64');
  assert.equal(await page.inputValue('#pack-sizes'), 'even');
});

test('a packed layout has any format', async (t) => {
  const page = await openPage(t, { open: ['misplaced.obj', MISPLACED] });
  await choose(page, 'pack');
  await pack(page);
  for (const format of ['ply', 'glb']) {
    const { name } = await exportAs(page, format);
    assert.equal(name, `misplaced-uv.${format}`);
    assert.equal(await textOf(page, '#alert'), '');
  }
});

test('a mesh without UVs has none to show, and another file begins as usual', async (t) => {
  const page = await openPage(t, { open: ['misplaced.obj', MISPLACED] });
  assert.ok(await page.isVisible('#mode-pack'));
  await choose(page, 'pack');
  await pack(page);
  await dropAndWait(page, 'cube.obj', CUBE);
  assert.ok(await page.isHidden('#mode-pack'));
  assert.equal(await isPressed(page, '#mode-unwrap'), 'true');
  assert.equal(await page.locator('#marks').isVisible(), false);
  await dropAndWait(page, 'faulty.obj', FAULTY);
  assert.equal(await isPressed(page, '#mode-unwrap'), 'true');
  await choose(page, 'pack');
  assert.equal(await isPressed(page, '#pack-keep'), 'true', 'nobody has asked to pack this one');
  assert.equal((await metrics(page)).Islands, '5');
});

/** Two squares with two sets of uv: in the first they overlap, in the second not. */
function twoSets(distance = 2) {
  const document = emptyDocument();
  const primitive = primitiveOf(document, {
    positions: [0, 1].flatMap((i) => CORNERS.map(([x, y]) => [x + distance * i, y, 0])),
    faces: [0, 4].flatMap((i) => [
      [i, i + 1, i + 2],
      [i, i + 2, i + 3],
    ]),
  });
  const sets = [OVERLAPPING, [OVERLAPPING[0], [0.5, 0.5, 0.25, 0.25]]];
  for (const [set, rectangles] of sets.entries()) {
    const uv = rectangles.flatMap(([u, v, width, height]) =>
      CORNERS.flatMap(([x, y]) => [u + x * width, 1 - v - y * height]),
    );
    primitive.setAttribute(`TEXCOORD_${set}`, accessor(document, 'VEC2', Float32Array.from(uv)));
  }
  addMesh(document, 'squares', primitive);
  return document;
}

test('each UV set of a glTF can be looked at', async (t) => {
  const page = await openPage(t, { settles: false });
  await dropAndWait(page, 'sets.glb', await io.writeBinary(twoSets()));
  await choose(page, 'pack');
  assert.equal((await metrics(page)).Overlapping, '4');
  await page.selectOption('#pack-texcoord', '1');
  await page.waitForFunction(() => document.title.startsWith('sets.glb, UV 1'));
  await settled(page);
  assert.equal(await isPressed(page, '#mode-pack'), 'true');
  assert.equal((await metrics(page)).Overlapping, '0');
  assert.equal(await textOf(page, '#badge'), 'Valid');
});

test('vertices that are joined to flatten a glTF are apart in its UVs', async (t) => {
  const page = await openPage(t, { settles: false });
  await dropAndWait(page, 'joined.glb', await io.writeBinary(twoSets(1)));
  assert.ok(await page.isEnabled('#mode-flatten'), 'the squares have an edge in common');
  await choose(page, 'pack');
  assert.equal((await metrics(page)).Islands, '2');
  await pack(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  const { bytes } = await exportAs(page, 'glb');
  const document = await io.readBinary(bytes);
  const [primitive] = document.getRoot().listMeshes()[0].listPrimitives();
  assert.deepEqual(primitive.listSemantics().sort(), ['POSITION', 'TEXCOORD_0', 'TEXCOORD_1']);
});

test('all options fit into the dock of a low window', async (t) => {
  const page = await openPage(t, { settles: false });
  await dropAndWait(page, 'sets.glb', await io.writeBinary(twoSets()));
  await choose(page, 'pack');
  for (const isPacked of [false, true]) {
    if (isPacked) await pack(page);
    for (const [width, height] of [
      [1280, 720],
      [1280, 675],
      [1920, 675],
      [1040, 720],
    ]) {
      await page.setViewportSize({ width, height });
      const cut = await page
        .locator('.ask, .result, .run')
        .evaluateAll((parts) =>
          parts.filter((part) => part.scrollHeight > part.clientHeight).map((e) => e.className),
        );
      assert.deepEqual(cut, [], `${width} x ${height}`);
    }
  }
});

test('on a phone, everything about UVs is within reach', async (t) => {
  const page = await openPage(t, {
    open: ['faulty.obj', FAULTY],
    viewport: { width: 360, height: 740 },
  });
  await choose(page, 'pack');
  await pack(page);
  for (const id of ['keep', 'islands', 'resolution', 'sizes', 'padding', 'rotate', 'margin']) {
    const control = page.locator(`#pack-${id}`);
    await control.scrollIntoViewIfNeeded();
    const { x, width } = await control.boundingBox();
    assert.ok(x >= 0 && x + width <= 360, id);
    assert.ok(width >= 40, id);
  }
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(overflow <= 0);
});
