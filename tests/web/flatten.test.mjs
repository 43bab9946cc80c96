// From a file to a layout to a file.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { column, elementOf, parsePly, plyBytes } from '../support/ply.mjs';
import { judge, sharedMesh, withoutShared } from '../support/shared.mjs';
import { grid } from '../support/small-meshes.mjs';
import { textStl, trianglesOf } from '../support/stl.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import {
  choose,
  dropAndWait,
  exportMesh,
  metrics,
  openPage,
  openSample,
  sampleNames,
  sampleOf,
  settled,
  textOf,
} from './page.mjs';

/** A screenshot of a canvas, whose bytes change with anything that is drawn. */
const picture = (page, id) => page.locator(id).screenshot();

const lines = (text, keyword) => text.split('\n').filter((line) => line.startsWith(`${keyword} `));

test('the first visit shows a sample, unwrapped; flattened it is in one piece', async (t) => {
  const page = await openPage(t);
  assert.equal(await sampleOf(page), 'head');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.match(await textOf(page, '#layout-info'), /^\d+ islands?$/);
  assert.match(await textOf(page, '#run-text'), /^Unwrapped in/);
  await choose(page, 'flatten');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  const shown = await metrics(page);
  assert.equal(await page.getAttribute('#t-auto', 'aria-pressed'), 'true');
  assert.equal(await page.inputValue('#t-number'), '2');
  assert.equal(await textOf(page, '#layout-info'), 't = auto: free');
  assert.ok(await page.isHidden('#marks'));
  assert.equal(shown.Crossings, '0');
  assert.equal(shown.Flipped, '0');
  assert.match(shown.Faces, /^[\d,]+$/);
  assert.match(await textOf(page, '#run-text'), /^Flattened in/);
});

test('every sample can be chosen and is unwrapped', async (t) => {
  const page = await openPage(t);
  const names = await sampleNames(page);
  assert.deepEqual([...names].sort(), [
    'alpha-band',
    'head',
    'hemisphere',
    'pumpkin',
    'three-balls',
    'wavy-strip',
  ]);
  for (const name of names) {
    await openSample(page, name);
    assert.equal(await textOf(page, '#badge'), 'Valid', name);
    assert.equal(await textOf(page, '#alert'), '', name);
  }
});

test('a dropped mesh is flattened, t moves by keyboard, the export keeps the mesh', async (t) => {
  const page = await openPage(t, { mode: 'flatten', settles: false });
  const mesh = grid(8);
  await dropAndWait(page, 'waves.obj', mesh);
  assert.equal(await textOf(page, '#source'), 'waves.obj');
  const before = await metrics(page);
  assert.equal(before.Faces, '128');
  assert.ok(Number(before.Stretch) >= 1);

  await page.fill('#t-number', '1');
  await settled(page);
  const convex = await metrics(page);
  const layout = await picture(page, '#layout-canvas');
  await page.focus('#t');
  for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowRight');
  await settled(page);
  assert.equal(await page.inputValue('#t-number'), '1.05');
  assert.equal(await textOf(page, '#layout-info'), 't = 1.05');
  await page.keyboard.press('End');
  await settled(page);
  assert.equal(await textOf(page, '#layout-info'), 't = 2');
  const after = await metrics(page);
  assert.ok(
    Number(after['Angular distortion']) < Number(convex['Angular distortion']),
    'a free boundary distorts angles less',
  );
  assert.notDeepEqual(await picture(page, '#layout-canvas'), layout);

  const { name, path } = await exportMesh(page);
  assert.equal(name, 'waves-uv.obj');
  const text = readFileSync(path, 'utf8');
  assert.deepEqual(lines(text, 'v'), lines(mesh, 'v'));
  const vertices = (face) =>
    face
      .split(' ')
      .slice(1)
      .map((corner) => corner.split('/')[0]);
  assert.deepEqual(lines(text, 'f').map(vertices), lines(mesh, 'f').map(vertices));
  assert.equal(lines(text, 'vt').length, 81);
  const uv = lines(text, 'vt').flatMap((line) => line.split(' ').slice(1).map(Number));
  assert.deepEqual([Math.min(...uv), Math.max(...uv)], [0, 1], 'as textures need it');
});

test('a dropped PLY comes back as PLY with its colours, an STL as OBJ', async (t) => {
  const page = await openPage(t, { mode: 'flatten', settles: false });
  const triangles = trianglesOf(grid(4));
  const vertices = triangles.flat().map((xyz, v) => [...xyz, v]);
  // Three vertices of its own for one triangle: a disk.
  const text = `${plyBytes({
    format: 'ascii',
    elements: [
      {
        name: 'vertex',
        properties: ['x', 'y', 'z', 'red'].map((name) => ({ name, type: 'float' })),
        rows: vertices.slice(0, 3),
      },
      {
        name: 'face',
        properties: [{ name: 'vertex_indices', type: 'int', countType: 'uchar' }],
        rows: [[[0, 1, 2]]],
      },
    ],
  })}`;
  await dropAndWait(page, 'one.PLY', text);
  assert.equal(await textOf(page, '#export'), 'Export PLY');
  const ply = await exportMesh(page);
  assert.equal(ply.name, 'one-uv.ply');
  const vertex = elementOf(parsePly(readFileSync(ply.path)), 'vertex');
  assert.deepEqual(column(vertex, 'red'), [0, 1, 2]);
  const uv = column(vertex, 's', 't').flat();
  assert.deepEqual([uv.length, Math.min(...uv), Math.max(...uv)], [6, 0, 1]);

  await dropAndWait(page, 'waves.stl', `${textStl(triangles)}`);
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal((await metrics(page)).Faces, '32');
  assert.equal(await textOf(page, '#export'), 'Export OBJ');
  const obj = await exportMesh(page);
  assert.equal(obj.name, 'waves-uv.obj');
  assert.equal(lines(readFileSync(obj.path, 'utf8'), 'v').length, 25);
});

test('a chosen file exports what an independent judge calls valid', {
  skip: withoutShared,
}, async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  const path = tempFolder(t);
  for (const [file, bound] of [
    ['nefertiti.off', 1],
    ['woody.obj', 1.05],
  ]) {
    await page.setInputFiles('#file', sharedMesh(file));
    await page.fill('#t-number', String(bound));
    await page.waitForFunction(
      (text) => document.querySelector('#layout-info').textContent === text,
      `t = ${bound}`,
    );
    await page.waitForFunction(
      (text) => document.querySelector('#source').textContent === text,
      file,
    );
    await settled(page);
    const { path: exported } = await exportMesh(page);
    const copy = path(`${file}.obj`);
    writeFileSync(copy, readFileSync(exported));
    const verdict = judge(sharedMesh(file), copy, bound);
    assert.deepEqual(verdict.failures, []);
    assert.equal(verdict.valid, true, JSON.stringify(verdict));
  }
});

test('a layout that crosses itself is called not valid, with the reason', {
  skip: withoutShared,
}, async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  await page.fill('#t-number', '2');
  await page.setInputFiles('#file', sharedMesh('camel-cut.obj'));
  await page.waitForFunction(() => document.querySelector('#badge').textContent === 'Not valid');
  assert.match(await textOf(page, '#reason'), /crosses itself/);
  assert.notEqual((await metrics(page)).Crossings, '0');
});

test('Auto untangles a boundary that crosses itself when it is free', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  await openSample(page, 'alpha-band');
  await page.fill('#t-number', '2');
  await settled(page);
  const { Crossings } = await metrics(page);
  assert.notEqual(Crossings, '0');
  assert.equal(await textOf(page, '#marks'), `${Crossings} crossings`);
  await page.click('#t-auto');
  await settled(page);
  assert.equal(await page.getAttribute('#t-auto', 'aria-pressed'), 'true');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.equal((await metrics(page)).Crossings, '0');
  assert.match(await textOf(page, '#layout-info'), /^t = auto: free except at \d+ vertices$/);
  assert.match(await textOf(page, '#marks'), /^\d+ tightened vertices$/);
  assert.match(await textOf(page, '#t-hint'), /^auto: /);
  await page.focus('#t');
  await page.keyboard.press('ArrowLeft');
  await settled(page);
  assert.equal(await page.getAttribute('#t-auto', 'aria-pressed'), 'false');
  assert.match(await textOf(page, '#layout-info'), /^t = \d/);
});

test('wireframe and distortion change the pictures', async (t) => {
  const page = await openPage(t, { mode: 'flatten' });
  const plain = await picture(page, '#mesh-canvas');
  await page.click('#wireframe');
  assert.equal(await page.getAttribute('#wireframe', 'aria-pressed'), 'true');
  const wired = await picture(page, '#mesh-canvas');
  assert.notDeepEqual(wired, plain);
  const layout = await picture(page, '#layout-canvas');
  await page.selectOption('#shading', 'angle');
  assert.ok(await page.isVisible('#legend'));
  assert.notDeepEqual(await picture(page, '#mesh-canvas'), wired);
  assert.notDeepEqual(await picture(page, '#layout-canvas'), layout);
});

test('the layout is panned, zoomed and fitted again', async (t) => {
  const page = await openPage(t, { mode: 'flatten', deviceScaleFactor: 1 });
  const fitted = await picture(page, '#layout-canvas');
  const box = await page.locator('#layout-canvas').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -400);
  assert.notDeepEqual(await picture(page, '#layout-canvas'), fitted);
  await page.mouse.dblclick(x, y);
  assert.deepEqual(await picture(page, '#layout-canvas'), fitted);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 30);
  await page.mouse.up();
  assert.notDeepEqual(await picture(page, '#layout-canvas'), fitted);
  await page.click('#fit');
  assert.deepEqual(await picture(page, '#layout-canvas'), fitted);
});
