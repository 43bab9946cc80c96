// Objects and materials of a scene: listed, selected, hidden, and given a density.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import axe from 'axe-core';
import { addMesh, emptyDocument, io, primitiveOf } from '../support/gltf.mjs';
import { CUBE, CUBE_OF_PARTS } from '../support/small-meshes.mjs';
import { sphere, torus } from '../support/surfaces.mjs';
import { loadModule } from './modules.mjs';
import { dropAndWait, metrics, openPage, settled, textOf } from './page.mjs';

const { objParts } = await loadModule('files/obj-parts');
const { chartsOf, hiding, isolating, selecting } = await loadModule('details/part-charts');

/** A table of two materials, chairs that are one mesh, and a lamp with neither name nor material. */
function room() {
  const document = emptyDocument();
  const [wood, steel] = ['wood', 'steel'].map((name) => document.createMaterial(name));
  const top = primitiveOf(document, sphere(6)).setMaterial(wood);
  const legs = primitiveOf(document, torus(8, 6)).setMaterial(steel);
  addMesh(document, 'table', top, legs);
  const seat = primitiveOf(document, sphere(4)).setMaterial(wood);
  const { mesh, node } = addMesh(document, 'chair', seat);
  node.setTranslation([3, 0, 0]);
  const scene = document.getRoot().listScenes()[0];
  for (const x of [6, 9, 12])
    scene.addChild(document.createNode(`chair ${x}`).setMesh(mesh).setTranslation([x, 0, 0]));
  addMesh(document, '', primitiveOf(document, torus(6, 5))).node.setTranslation([0, 5, 0]);
  return io.writeBinary(document);
}

/** With the list of objects open. */
async function openRoom(t, options = {}) {
  const page = await openPage(t, options);
  await dropAndWait(page, 'room.glb', await room());
  const press = (selector) => (options.hasTouch ? page.tap(selector) : page.click(selector));
  await press('#details-toggle');
  await press('#tab-objects');
  await page.waitForFunction(
    () => document.querySelector('.part-table td:nth-child(3)')?.innerText,
  );
  return page;
}

/** Name, triangles and islands of each row. */
const rows = (page) =>
  page
    .locator('.part-table tbody tr')
    .evaluateAll((all) => all.map(({ cells }) => [...cells].slice(0, 3).map((c) => c.innerText)));

const named = (page, name) => page.locator('.part-table tbody tr', { hasText: name });
const select = (page, name) => named(page, name).locator('.part-name');
const button = (page, what) => page.getByRole('button', { name: what, exact: true });
const isPressed = async (locator) => (await locator.getAttribute('aria-pressed')) === 'true';

test('objects and materials are listed with their copies, triangles and islands', async (t) => {
  const page = await openRoom(t);
  const charts = Number((await metrics(page)).Islands);
  const all = await rows(page);
  assert.deepEqual(
    all.map(([name, triangles]) => [name, triangles]),
    [
      ['table', '528'],
      ['chair ×4', '192'],
      ['Object 3', '60'],
      ['wood', '624'],
      ['steel', '96'],
      ['No material', '60'],
    ],
  );
  const islands = all.map(([, , count]) => Number(count));
  const sum = (counts) => counts.reduce((total, count) => total + count, 0);
  assert.ok(islands.every((count) => count > 0));
  assert.equal(sum(islands.slice(0, 3)), charts, 'no island belongs to two of them');
  assert.equal(sum(islands.slice(3)), charts);

  await dropAndWait(page, 'cube.obj', CUBE);
  await page.locator('#tab-objects').waitFor({ state: 'hidden' });
  assert.equal(await page.getAttribute('#tab-charts', 'aria-selected'), 'true');
  await dropAndWait(page, 'parts.obj', CUBE_OF_PARTS);
  await page.click('#tab-objects');
  await page.waitForFunction(() => document.querySelector('.part-name')?.innerText === 'most');
  assert.deepEqual(
    (await rows(page)).map(([name, triangles]) => [name, triangles]),
    [
      ['most', '10'],
      ['last', '2'],
    ],
  );
});

test('islands of an object are selected, hidden and isolated, by keyboard too', async (t) => {
  const page = await openRoom(t);
  const [[, , ofTable], [, , ofChair]] = await rows(page);
  await select(page, 'table').focus();
  await page.keyboard.press('Enter');
  const selected = () => textOf(page, '#selection-text');
  const inAll = (count) => new RegExp(count === 1 ? '^Island' : `^${count} islands: `);
  assert.match(await selected(), inAll(Number(ofTable)));
  assert.ok(await isPressed(select(page, 'table')));
  await select(page, 'chair').click({ modifiers: ['Shift'] });
  assert.match(await selected(), inAll(Number(ofTable) + Number(ofChair)));
  await select(page, 'table').click({ modifiers: ['Shift'] });
  assert.match(await selected(), inAll(Number(ofChair)));
  assert.ok(!(await isPressed(select(page, 'table'))));

  await button(page, 'Hide chair').click();
  assert.match(await selected(), new RegExp(`^${ofChair} islands? hidden$`));
  assert.ok(await isPressed(button(page, 'Hide chair')));
  await button(page, 'Hide chair').click();
  assert.ok(await page.isHidden('#selection'));

  await button(page, 'Isolate chair').click();
  assert.ok(await isPressed(button(page, 'Isolate chair')));
  for (const other of ['table', 'Object 3', 'steel', 'No material'])
    assert.ok(await isPressed(button(page, `Hide ${other}`)), other);
  assert.ok(!(await isPressed(button(page, 'Hide wood'))), 'a part of it is shown');
  // What hides charts elsewhere shows in the list.
  await page.click('#selection-show-all');
  assert.ok(!(await isPressed(button(page, 'Isolate chair'))));
  await button(page, 'Isolate chair').click();
  await button(page, 'Isolate chair').click();
  assert.ok(await page.isHidden('#selection'));
});

test('an object has a density, and a material another one', async (t) => {
  const page = await openRoom(t);
  const density = (name) => page.getByLabel(`Density of ${name}`, { exact: true });
  /** The list follows the layout. */
  const shows = (name, value) =>
    page.waitForFunction(
      ([name, value]) =>
        document.querySelector(`[aria-label="Density of ${name}"]`).value === value,
      [name, value],
    );
  await shows('chair', '1');
  await density('chair').fill('2');
  await density('chair').press('Enter');
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /^Set density 2 on .* in /);
  await shows('chair', '2');
  await shows('table', '1');
  await shows('wood', '');
  assert.equal(await density('wood').getAttribute('placeholder'), 'mixed');
  await density('steel').fill('0.5');
  await density('steel').press('Enter');
  await settled(page);
  await shows('table', '');
  await density('steel').fill('-1');
  await density('steel').press('Enter');
  await shows('steel', '0.5');
  await page.click('#undo');
  await page.click('#undo');
  await settled(page);
  await shows('chair', '1');

  await page.click('#tab-charts');
  for (const lock of await page.locator('.lock').all()) await lock.click();
  await page.click('#tab-objects');
  await density('chair').fill('3');
  await density('chair').press('Enter');
  await shows('chair', '1');
  assert.match(await textOf(page, '#live'), /^Locked islands stay/);
});

test('what becomes of selected and hidden charts', () => {
  const sets = ({ selected, hidden }) => [[...selected], [...hidden]];
  const states = (selected, hidden) => ({ selected: new Set(selected), hidden: new Set(hidden) });
  const part = new Set([1, 2]);
  assert.deepEqual(sets(selecting(part, false, states([0], [3]))), [[1, 2], [3]]);
  assert.deepEqual(sets(selecting(part, true, states([0, 1], []))), [[0, 1, 2], []]);
  assert.deepEqual(sets(selecting(part, true, states([0, 1, 2], []))), [[0], []]);
  assert.deepEqual(sets(hiding(part, states([0, 1], [3]))), [[0], [3, 1, 2]]);
  assert.deepEqual(sets(hiding(part, states([0], [3, 1, 2]))), [[0], [3]]);
  assert.deepEqual(sets(isolating(part, 4, states([0, 1], []))), [[1], [0, 3]]);
  assert.deepEqual(sets(isolating(part, 4, states([1], [0, 3]))), [[1], []]);
  const runs = [
    [0, 1],
    [3, 2],
  ];
  const found = chartsOf({ runs }, Uint32Array.of(4, 1, 1, 2, 4, 0), 5);
  assert.deepEqual([...found], [2, 4]);
});

test('faces of an OBJ belong to objects or groups, and to materials', () => {
  const parts = (lines, faces) => {
    const { objects, materials } = objParts(lines.join('\n'), faces?.length ?? 4, faces);
    return [objects, materials].map((all) => all.map(({ name, runs }) => [name, runs]));
  };
  const face = 'f 1 2 3';
  assert.deepEqual(parts([face, face, face, face]), [[], []]);
  const mixed = ['o a b', 'g x', face, 'usemtl m', face, 'o c', face, '\to a b', 'usemtl n', face];
  const inObjects = [
    [
      'a b',
      [
        [0, 2],
        [3, 1],
      ],
    ],
    ['c', [[2, 1]]],
  ];
  const inMaterials = [
    ['', [[0, 1]]],
    ['m', [[1, 2]]],
    ['n', [[3, 1]]],
  ];
  assert.deepEqual(parts(mixed), [inObjects, inMaterials]);
  const groups = ['g x', face, face, 'g y', face];
  const [inGroups] = parts(groups, Uint32Array.of(0, 0, 1, 2, 2));
  assert.deepEqual(inGroups, [
    ['x', [[0, 3]]],
    ['y', [[3, 2]]],
  ]);
});

for (const [name, options] of [
  ['desktop', {}],
  ['phone', { viewport: { width: 390, height: 844 }, hasTouch: true }],
])
  test(`the list is without faults, ${name}`, async (t) => {
    const page = await openRoom(t, options);
    await page.evaluate(axe.source);
    const press = (locator) => (options.hasTouch ? locator.tap() : locator.click());
    await press(button(page, 'Hide table'));
    await press(select(page, 'chair'));
    await page.mouse.move(0, 0);
    for (const theme of ['dark', 'light']) {
      await page.evaluate((theme) => {
        document.documentElement.dataset.theme = theme;
      }, theme);
      if (process.env.PICTURES)
        await page.screenshot({ path: `${process.env.PICTURES}/objects-${name}-${theme}.png` });
      const found = await page.evaluate(async () => (await globalThis.axe.run()).violations);
      assert.deepEqual(
        found.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id} ${target}`)),
        [],
        theme,
      );
    }
    const least = options.hasTouch ? 40 : 24;
    for (const part of await page.locator('.part-button, .part-table input').all()) {
      const { width, height } = await part.boundingBox();
      assert.ok(width >= least && height >= least, `${width} x ${height}`);
    }
    const wide = await page
      .locator('#panel-objects')
      .evaluate((panel) => panel.scrollWidth - panel.clientWidth);
    assert.ok(wide <= 0, 'nothing is cut');
  });
