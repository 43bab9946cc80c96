// Charts that are put on each other share texels on purpose: that is no fault, and packing keeps it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { judgeStacks } from '../support/stacks.mjs';
import { objText, together } from '../support/surfaces.mjs';
import { atlas } from './layout.mjs';
import { loadModule } from './modules.mjs';
import { exportAs, exportMesh, metrics, openPage, settled, textOf } from './page.mjs';

/** A square that is a chart as it is, and one that lacks a corner. */
const SQUARE = {
  positions: [0, 1, 2, 3, 4, 5, 6, 7, 8].map((i) => [i % 3, Math.floor(i / 3), 0]),
  faces: [0, 1, 3, 4].map((i) => [i, i + 1, i + 4, i + 3]),
};
const CORNER = { positions: SQUARE.positions, faces: SQUARE.faces.slice(0, 3) };
const MESH = objText(
  together([
    [SQUARE, [0, 0, 0]],
    [SQUARE, [3, 0, 0]],
    [SQUARE, [6, 0, 0]],
    [CORNER, [0, 5, 0]],
  ]),
);
const FACES = 4;

const SMALL = { viewport: { width: 900, height: 560 } };

async function arrange(page, value) {
  await page.click('#selection-arrange');
  await page.click(`#arrange-menu [data-value="${value}"]`);
  await page.waitForFunction(
    () => /tacked/.test(document.querySelector('#run-text').textContent) && !document.body.ariaBusy,
  );
}

const cornersOf = ({ uv }, chart) =>
  new Set(
    uv
      .slice(FACES * chart, FACES * (chart + 1))
      .flatMap((face) => face.map((corner) => corner.map((x) => x.toFixed(6)).join(' '))),
  );

/** Of its bounding box: where charts are equally large, one that is put there is in the tile, too. */
function middleOfChart({ uv }, chart) {
  const corners = uv.slice(FACES * chart, FACES * (chart + 1)).flat();
  return [0, 1].map((d) => {
    const along = corners.map((corner) => corner[d]);
    return (Math.min(...along) + Math.max(...along)) / 2;
  });
}

function areStacked(shown) {
  const [first, ...others] = [0, 1, 2].map((chart) => [...cornersOf(shown, chart)].sort());
  for (const each of others) assert.deepEqual(each, first);
}

async function packAgain(page) {
  if (await page.isHidden('#details')) await page.click('#details-toggle');
  await page.click('#tab-charts');
  await page.click('#pack-again');
  await settled(page);
}

const isValid = async (page) => {
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.equal(await textOf(page, '#reason'), '3 islands stacked, no other overlaps');
  assert.ok(await page.isHidden('#marks'));
};

const utilization = async (page) => parseFloat((await metrics(page))['Space used']);

test('stacked islands are valid, stay stacked when all is packed again, and are exported so', async (t) => {
  const page = await openPage(t, { ...SMALL, mode: 'unwrap', open: ['mesh.obj', MESH] });
  const apart = await utilization(page);
  await page.focus('#layout-canvas');
  await page.keyboard.press('a');
  await arrange(page, 'stacked');
  assert.match(
    await textOf(page, '#run-text'),
    /^Stacked 3 islands; 1 has another shape, checked in [^,]*$/,
  );
  await isValid(page);
  areStacked(await atlas(page));
  const unpacked = await utilization(page);
  assert.ok(unpacked < apart, 'texels that are shared count once');
  await packAgain(page);
  await isValid(page);
  areStacked(await atlas(page));
  const marks = page.locator('#charts .stack-mark');
  const others = (chart) => [0, 1, 2].filter((other) => other !== chart).join(' and ');
  assert.deepEqual(
    await marks.evaluateAll((all) =>
      all.map((mark) => [Number(mark.closest('tr').dataset.chart), mark.title]),
    ),
    [0, 1, 2].map((chart) => [chart, `Stacked with islands ${others(chart)}`]),
  );
  assert.ok((await utilization(page)) > 1.3 * unpacked, 'the room is used');
  // Other options pack anew as well.
  await page.selectOption('#resolution', '512');
  await settled(page);
  await isValid(page);
  const shown = await atlas(page);
  areStacked(shown);
  // In another format a note would say if the layout were not valid any more.
  await exportAs(page, 'glb');
  assert.doesNotMatch(await textOf(page, '#run-text'), /flip|overlap/);

  // A chart that is cut has another shape. The others stay, and it is said which do not.
  const slit = { name: 'slit.txt', mimeType: 'text/plain', buffer: Buffer.from('1 4\n') };
  await page.setInputFiles('#seams-file', slit);
  await page.waitForFunction(() => document.querySelector('#seams-state').textContent);
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /; 1 island no longer stacked$/);
  await packAgain(page);
  assert.equal(await textOf(page, '#reason'), '2 islands stacked, no other overlaps');
  assert.doesNotMatch(await textOf(page, '#run-text'), /stacked/, 'said once');
  for (let i = 0; i < 2; i++) await page.click('#undo');
  await settled(page);
  await isValid(page);

  // A chart that comes to lie on a stack by accident is a fault.
  const [to, from] = [0, 3].map((chart) => middleOfChart(shown, chart));
  await page.locator('#charts tbody tr').last().click();
  for (const d of [0, 1]) {
    await page.focus('#layout-canvas');
    await page.keyboard.press('g');
    await page.keyboard.press('xy'[d]);
    await page.keyboard.type((to[d] - from[d]).toFixed(4));
    await page.keyboard.press('Enter');
    await settled(page);
  }
  assert.equal(await textOf(page, '#badge'), 'Not valid');
  assert.match(await textOf(page, '#reason'), /^\d islands overlap$/);
});

/** The second square has uv, where the vertices of a square are numbered from 10. */
const PAINTED = MESH.split('\n')
  .map((line) => {
    const vertices = /^f /.test(line) ? line.split(' ').slice(1).map(Number) : [];
    const isPainted = vertices.length > 0 && vertices.every((v) => v >= 10 && v < 19);
    return isPainted ? `f ${vertices.map((v) => `${v}/${v - 9}`).join(' ')}` : line;
  })
  .concat(SQUARE.positions.map(([x, y]) => `vt ${0.1 + 0.15 * x} ${0.5 + 0.15 * y}`))
  .join('\n');

test('islands are stacked on one that keeps the uv of the file, which stays when all is packed again', async (t) => {
  const page = await openPage(t, { ...SMALL, mode: 'unwrap', open: ['painted.obj', PAINTED] });
  await page.click('#more-toggle');
  await page.click('#more-keep-uv');
  await settled(page);
  await page.click('#more-toggle');
  const before = await atlas(page);
  await page.keyboard.press('a');
  await arrange(page, 'stacked');
  for (const pack of [() => undefined, () => packAgain(page)]) {
    await pack();
    const after = await atlas(page);
    areStacked(after);
    assert.deepEqual(
      after.uv.slice(FACES, 2 * FACES).map((face) => face.map((at) => at.map(Math.fround))),
      before.uv.slice(FACES, 2 * FACES).map((face) => face.map((at) => at.map(Math.fround))),
    );
    await isValid(page);
  }
  // A stack whose charts are to have their own uv again is given up.
  await page.click('#more-toggle');
  await page.click('#more-keep-uv');
  await settled(page);
  assert.match(await textOf(page, '#run-text'), /; 3 islands no longer stacked$/);
});

test('islands of different shapes are not stacked, and that is said', async (t) => {
  const page = await openPage(t, {
    ...SMALL,
    mode: 'unwrap',
    open: [
      'two.obj',
      objText(
        together([
          [SQUARE, [0, 0, 0]],
          [CORNER, [0, 5, 0]],
        ]),
      ),
    ],
  });
  const before = await atlas(page);
  await page.keyboard.press('a');
  await arrange(page, 'stacked');
  assert.equal(
    await textOf(page, '#run-text'),
    'Nothing was stacked: no two of these islands have the same shape',
  );
  assert.equal(await textOf(page, '#badge'), 'Valid');
  assert.deepEqual((await atlas(page)).uv, before.uv);
  assert.ok(await page.isDisabled('#undo'));
});

/** A quad unlike its mirror image, copies of it, mirror images, and a square. */
const QUAD = [
  [0, 0, 0],
  [3, 0, 0],
  [2, 1, 0],
  [0, 2, 0],
];
const MIRROR_IMAGE = { positions: QUAD.map(([x, y]) => [-x, y, 0]), faces: [[3, 2, 1, 0]] };
const BOTH_SIDES = objText(
  together([
    [{ positions: QUAD, faces: [[0, 1, 2, 3]] }, [0, 0, 0]],
    [MIRROR_IMAGE, [9, 0, 0]],
    [{ positions: QUAD, faces: [[1, 2, 3, 0]] }, [12, 0, 0]],
    [MIRROR_IMAGE, [20, 0, 0]],
    [SQUARE, [0, 9, 0]],
  ]),
);

async function stackEqual(page, how) {
  if (await page.isHidden('#more')) await page.click('#more-toggle');
  await page.selectOption('#more-stack', how);
  await settled(page);
}

async function moveBy(page, distance) {
  await page.focus('#layout-canvas');
  await page.keyboard.press('g');
  await page.keyboard.press('x');
  await page.keyboard.type(distance);
  await page.keyboard.press('Enter');
  await settled(page);
}

test('equal islands are stacked by an option, mirror images too, and stay so whatever is done next', async (t) => {
  const page = await openPage(t, { ...SMALL, mode: 'unwrap', open: ['both.obj', BOTH_SIDES] });
  const isStacked = async (charts) => {
    assert.equal(await textOf(page, '#badge'), 'Valid');
    assert.equal(await textOf(page, '#reason'), `${charts} islands stacked, no other overlaps`);
    assert.ok(await page.isHidden('#marks'));
  };
  assert.equal(await textOf(page, '#reason'), 'No flipped triangles, no overlaps');
  const apart = await utilization(page);
  await stackEqual(page, 'identical');
  await isStacked(4);
  await stackEqual(page, 'mirrored');
  await isStacked(4);
  assert.equal(await textOf(page, '#more-state'), 'stack equal islands mirrored');
  assert.ok((await utilization(page)) > 0.8 * apart, 'the room is used');
  const { path } = await exportMesh(page);
  const judged = judgeStacks(path);
  assert.deepEqual([judged.isValid, judged.charts, judged.places], [true, 3, 1]);
  assert.equal(judged.mirrored, 2);
  await exportAs(page, 'glb');
  assert.doesNotMatch(await textOf(page, '#run-text'), /flip|overlap/);
  await page.click('#more-toggle');
  await packAgain(page);
  await isStacked(4);
  // Moving the square leaves the stack alone.
  await page.click('#charts tr[data-chart="4"]');
  await moveBy(page, '0.001');
  await isStacked(4);
  // Without the chart below it, a mirror image is turned over.
  await page.click('#charts tr[data-chart="3"]');
  await moveBy(page, '-0.1');
  assert.match(await textOf(page, '#reason'), /flipped/);
  for (let i = 0; i < 2; i++) await page.click('#undo');
  await settled(page);
  await isStacked(4);
  // Every chart of a stack stays with a locked one.
  await page.locator('#charts .lock').nth(1).click();
  await packAgain(page);
  await isStacked(4);
  await stackEqual(page, 'none');
  assert.equal(await textOf(page, '#reason'), 'No flipped triangles, no overlaps');
});

test('the layout shows each place once, and what is selected or lies on hidden islands', async () => {
  const { NO_STATES, unseen } = await loadModule('view/chart-flags');
  const stacked = {
    on: new Map([
      [2, 0],
      [3, 0],
      [4, 1],
    ]),
    mirrored: new Set([3]),
  };
  const seen = (states) => [...unseen({ ...NO_STATES, stacked, ...states })].sort();
  assert.deepEqual(seen({}), [2, 3, 4]);
  assert.deepEqual(seen({ selected: new Set([3]) }), [2, 4]);
  assert.deepEqual(seen({ hidden: new Set([0]) }), [0, 4]);
  assert.equal(unseen(NO_STATES), NO_STATES.hidden);
});

test('stacks are read from a report, and islands stay with all that lie on them', async () => {
  const { stacksIn, withStacks } = await loadModule('model/stacks');
  const charts = [-1, -1, 0, 1, 0].map((stackedOn) => ({ stackedOn }));
  const stacks = stacksIn({ charts });
  assert.deepEqual(stacks, [
    [0, 2, 4],
    [1, 3],
  ]);
  assert.equal(stacksIn({ charts: charts.slice(0, 2) }), undefined);
  assert.deepEqual([...withStacks(Uint32Array.of(3, 5), stacks)].sort(), [1, 3, 5]);
  assert.deepEqual([...withStacks(Uint32Array.of(3), undefined)], [3]);
});
