// Moving charts without a page: motions, gestures, and what arrangements ask for.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { randomNumbers } from '../support/disks.mjs';
import { loadModule as load } from './modules.mjs';

const QUARTER = Math.PI / 2;
const isNear = (a, b, what) => assert.ok(Math.abs(a - b) < 1e-9, `${what ?? ''} ${a} is ${b}`);
const areNear = (a, b) => {
  for (const [i, x] of a.entries()) isNear(x, b[i]);
};

test('an atlas of any size fits one tile as it is, but smaller', async () => {
  const { inOneTile } = await load('mesh/in-one-tile');
  const within = Float64Array.of(0, 0.25, 1, 0.5);
  assert.deepEqual(inOneTile(within), within);
  assert.deepEqual([...inOneTile(Float64Array.of(0.5, 0, 1, 2))], [0.25, 0, 0.5, 1]);
  assert.deepEqual([...inOneTile(Float64Array.of(-0.5, 1, 2, 0.5))], [0.125, 0.25, 0.75, 0.125]);
});

test('motions keep their middle, follow each other, and are the same in the plane of the view', async () => {
  const { after, inPlane, moved, shifted, turned } = await load('arrange/motion');
  const next = randomNumbers(5);
  for (let i = 0; i < 50; ++i) {
    const point = [next(), next()];
    const middle = [next(), next()];
    const turn = turned(middle, 7 * next(), 0.5 + next());
    const shift = shifted(next(), next());
    areNear(moved(turn, middle), middle);
    areNear(moved(after(turn, shift), point), moved(shift, moved(turn, point)));
    areNear(moved(after(shift, turn), point), moved(turn, moved(shift, point)));
    const unit = 0.5 + next();
    const center = [next(), next()];
    const inUv = ([x, y]) => [center[0] + unit * x, center[1] + unit * y];
    areNear(inUv(moved(inPlane(turn, center, unit), point)), moved(turn, inUv(point)));
  }
  // Right angles are exact: a square stays one.
  assert.deepEqual(moved(turned([0, 0], QUARTER), [1, 0]), [0, 1]);
  assert.deepEqual(moved(turned([0, 0], -3 * QUARTER), [0.25, 0]), [0, 0.25]);
});

/** A gesture in an atlas of 100 texels. */
const gesture = (some) => ({
  ...{ kind: 'move', middle: [0.5, 0.5], from: [0.6, 0.5], to: [0.6, 0.5] },
  ...{ axis: null, nudge: [0, 0], typed: '', snaps: false, texel: 0.01, step: 0.04 },
  ...some,
});

test('a gesture follows the pointer, an axis, steps, arrows and numbers', async () => {
  const { motionOf, textOf } = await load('arrange/gesture');
  const shift = (some) => {
    const { x, y } = motionOf(gesture({ to: [0.65, 0.43], ...some }));
    return [x, y];
  };
  areNear(shift({}), [0.05, -0.07]);
  areNear(shift({ axis: 1 }), [0, -0.07]);
  areNear(shift({ snaps: true }), [0.04, -0.08]);
  areNear(shift({ nudge: [3, -1] }), [0.08, -0.08]);
  areNear(shift({ typed: '0.25' }), [0.25, 0]);
  areNear(shift({ typed: '-1', axis: 1 }), [0, -1]);
  areNear(shift({ typed: '-' }), [0.05, -0.07]);
  assert.equal(textOf(gesture({ to: [0.65, 0.43] })), 'Move u 0.05, v −0.07 (5, −7 texels)');
  assert.equal(textOf(gesture({ to: [0.65, 0.43], axis: 0 })), 'Move u 0.05 (5 texels)');

  const turn = (some) => {
    const { a, b } = motionOf(gesture({ kind: 'turn', ...some }));
    return (Math.atan2(b, a) * 180) / Math.PI;
  };
  isNear(turn({ to: [0.5, 0.7] }), 90);
  isNear(turn({ to: [0.7, 0.52], snaps: true }), 5);
  isNear(turn({ typed: '-30' }), -30);
  isNear(turn({ nudge: [0, 2] }), 2, 'up is counterclockwise');
  isNear(turn({ nudge: [2, 0] }), -2, 'right is clockwise');
  assert.equal(textOf(gesture({ kind: 'turn', typed: '45' })), 'Rotate 45°');

  const scale = (some) => motionOf(gesture({ kind: 'scale', ...some })).a;
  isNear(scale({ to: [0.5, 0.7] }), 2);
  isNear(scale({ to: [0.717, 0.5], snaps: true }), 2.2);
  isNear(scale({ typed: '0.5' }), 0.5);
  isNear(scale({ typed: '-1' }), 1, 'nothing is folded');
  assert.ok(scale({ to: [0.5, 0.5] }) > 0);
  isNear(scale({ from: [0.5, 0.5] }), 1);
});

test('keys that a gesture takes', async () => {
  const { withKey } = await load('arrange/gesture');
  const after = (...keys) =>
    keys.reduce((each, key) => withKey(each, key, false) ?? each, gesture());
  assert.equal(after('1', '.', '5', 'Backspace', '2').typed, '1.2');
  assert.equal(after('x').axis, 0);
  assert.equal(after('x', 'y').axis, 1);
  assert.equal(after('Y', 'y').axis, null, 'again frees it');
  assert.deepEqual(after('ArrowLeft', 'ArrowUp', 'ArrowUp').nudge, [-1, 2]);
  assert.deepEqual(withKey(gesture(), 'ArrowRight', true).nudge, [10, 0]);
  assert.equal(withKey(gesture(), 'q', false), null);
  assert.equal(withKey(gesture({ kind: 'scale' }), 'x', false), null, 'scaling keeps angles');
});

test('steps are whole texels that can be seen', async () => {
  const { stepOf } = await load('arrange/gesture');
  const texel = 1 / 1024;
  isNear(stepOf(texel, 100_000), texel);
  isNear(stepOf(texel, 8 * 1024), texel);
  isNear(stepOf(texel, 500) / texel, 32);
  assert.ok(stepOf(texel, 500) * 500 >= 8);
});

/** An atlas of polygons, each a chart that is a fan of triangles around its first corner. */
function atlas(polygons) {
  const uv = [];
  const indices = [];
  const chartOfTriangle = [];
  polygons.forEach((points, chart) => {
    const first = uv.length / 2;
    uv.push(...points.flat());
    for (let i = 1; i + 1 < points.length; ++i) {
      indices.push(first, first + i, first + i + 1);
      chartOfTriangle.push(chart);
    }
  });
  return {
    uv: Float64Array.from(uv),
    indices: Uint32Array.from(indices),
    chartOfTriangle: Uint32Array.from(chartOfTriangle),
  };
}

const KITE = [
  [0, 0],
  [0.3, 0.05],
  [0.2, 0.2],
  [0.02, 0.1],
];
const SQUARE = [
  [0, 0],
  [0.2, 0],
  [0.2, 0.2],
  [0, 0.2],
];
const charts = (...numbers) => Uint32Array.from(numbers);

test('only the charts that are moved change, and they are in single precision', async () => {
  const { movedUv } = await load('arrange/move-charts');
  const { moved, turned } = await load('arrange/motion');
  const arrays = atlas([KITE, SQUARE, KITE]);
  const motion = turned([0.1, 0.3], 0.3, 1.1);
  const uv = movedUv(arrays, { charts: charts(1), motions: [motion] });
  for (let v = 0; v < 12; ++v) {
    const before = [arrays.uv[2 * v], arrays.uv[2 * v + 1]];
    const expected = v >= 4 && v < 8 ? moved(motion, before).map(Math.fround) : before;
    assert.deepEqual([uv[2 * v], uv[2 * v + 1]], expected);
  }
});

test('straightening makes the smallest box upright, by the least turn', async () => {
  const { moved, turned } = await load('arrange/motion');
  const { straightened } = await load('arrange/straighten');
  const next = randomNumbers(9);
  const strip = Array.from({ length: 24 }, () => [0.8 * next(), 0.1 * next()]);
  strip.push([0, 0], [0.8, 0], [0.8, 0.1], [0, 0.1]);
  for (const degrees of [0, 10, 44, 46, 100, -20]) {
    const turn = turned([0.3, 0.4], (degrees * Math.PI) / 180);
    const arrays = atlas([SQUARE, strip.map((point) => moved(turn, point))]);
    const { motions } = straightened(arrays, charts(1));
    const angle = (Math.atan2(motions[0].b, motions[0].a) * 180) / Math.PI;
    isNear(angle, -(((((degrees + 45) % 90) + 90) % 90) - 45), `turned by ${degrees}:`);
  }
});

test('charts of one shape are stacked, wherever they are and however turned', async () => {
  const { movedUv } = await load('arrange/move-charts');
  const { moved, shifted, turned } = await load('arrange/motion');
  const { stacked } = await load('arrange/stack');
  const turn = turned([0.5, 0.5], 2);
  const grown = turned([0.2, 0.9], 1, 1.3);
  const mirrored = KITE.map(([x, y]) => [-x, y]).reverse();
  const rotated = (points, by) => [...points.slice(by), ...points.slice(0, by)];
  const arrays = atlas([
    KITE,
    SQUARE,
    rotated(KITE, 2).map((point) => moved(turn, point)),
    mirrored,
    KITE.map((point) => moved(grown, point)),
    SQUARE.map((point) => moved(shifted(0.4, 0.4), point)),
  ]);
  const result = stacked(arrays, charts(0, 1, 2, 3, 4, 5), charts());
  assert.deepEqual([...result.charts], [2, 4, 5], 'a mirror image is another shape');
  const uv = movedUv(arrays, result);
  const pointsOf = (chart) =>
    Array.from({ length: 4 }, (_, i) => [uv[8 * chart + 2 * i], uv[8 * chart + 2 * i + 1]]);
  const areSame = (chart, points) => {
    for (const [x, y] of points)
      assert.ok(
        pointsOf(chart).some(([u, v]) => Math.hypot(u - x, v - y) < 1e-6),
        `chart ${chart} has a corner at ${x}, ${y}`,
      );
  };
  areSame(2, KITE);
  areSame(4, KITE);
  assert.deepEqual(
    pointsOf(5),
    SQUARE.map((point) => point.map(Math.fround)),
    'a square keeps its corners',
  );
  // On a chart that stays.
  const fixed = stacked(arrays, charts(0), charts(4));
  assert.deepEqual([...fixed.charts], [0]);
  for (const point of KITE) areNear(moved(fixed.motions[0], point), moved(grown, point));
});

test('stacks are charts with the same outline, bit by bit, and each can be checked apart', async () => {
  const { movedUv } = await load('arrange/move-charts');
  const { stacked } = await load('arrange/stack');
  const { apart, stacksOf } = await load('arrange/stacks');
  const { moved, turned } = await load('arrange/motion');
  const turn = turned([0.5, 0.5], 2);
  const arrays = atlas([KITE, SQUARE, KITE.map((point) => moved(turn, point)), SQUARE, KITE]);
  arrays.uv.set(arrays.uv.map(Math.fround));
  assert.deepEqual(stacksOf(arrays).stacks, [
    [0, 4],
    [1, 3],
  ]);
  const found = stacked(arrays, charts(0, 2, 4), charts());
  assert.equal(found.below, 1);
  const uv = movedUv(arrays, found);
  const together = { ...arrays, uv };
  const { stacks, repeated } = stacksOf(together);
  assert.deepEqual(stacks, [
    [0, 2, 4],
    [1, 3],
  ]);
  const areaOf = (points) =>
    points.reduce((sum, [x1, y1], i) => {
      const [x2, y2] = points[(i + 1) % points.length];
      return sum + (x1 * y2 - x2 * y1) / 2;
    }, 0);
  assert.ok(Math.abs(repeated - 2 * areaOf(KITE) - areaOf(SQUARE)) < 1e-6);
  const above = apart(together, stacks, 3);
  uv.forEach((x, i) => {
    const layer = [0, 0, 1, 1, 2][Math.floor(i / 8)];
    assert.equal(above[i], i % 2 === 0 ? x : x + 3 * layer);
  });
  // What merely overlaps is no stack, and what cannot be moved exactly is not.
  uv[16] += 1e-7;
  assert.deepEqual(stacksOf(together).stacks, [
    [0, 4],
    [1, 3],
  ]);
  uv[33] = 1e-30;
  assert.equal(apart(together, [[0, 4]], 1), null);
});

test('stacks follow their lowest chart when it is packed elsewhere, unless a chart was cut', async () => {
  const { movedUv } = await load('arrange/move-charts');
  const { restacked, stacksOf } = await load('arrange/stacks');
  const { turned } = await load('arrange/motion');
  const before = atlas([KITE, SQUARE, KITE]);
  before.uv.set(before.uv.map(Math.fround));
  const motions = [turned([0.3, 0.8], 1.3, 0.7), turned([0.1, 0.1], 0.2, 0.05)];
  const now = { ...before, uv: movedUv(before, { charts: charts(0, 2), motions }) };
  const uv = restacked(before, now, [[0, 2]]);
  assert.deepEqual(stacksOf({ ...now, uv }).stacks, [[0, 2]]);
  assert.deepEqual(uv.subarray(0, 16), now.uv.subarray(0, 16), 'others stay');
  const cut = { ...now, chartOfTriangle: Uint32Array.of(0, 0, 1, 1, 2, 3) };
  assert.equal(restacked(before, cut, [[0, 2]]), null);
});

test('even density gives charts as many texels per surface as the others have', async () => {
  const { evened } = await load('arrange/density');
  const arrays = atlas([SQUARE, SQUARE, SQUARE]);
  const positions = [...Array(3).keys()].flatMap((chart) =>
    SQUARE.flatMap(([x, y]) => [x * (chart === 1 ? 2 : 1), y * (chart === 1 ? 2 : 1), chart]),
  );
  const { charts: found, motions } = evened({ ...arrays, positions }, charts(1));
  assert.deepEqual([...found], [1]);
  isNear(motions[0].a, 2, 'twice as large on the surface');
  // With all charts, those of the whole atlas: 3 squares of texels on 6 of surface.
  const all = evened({ ...arrays, positions }, charts(0, 1, 2));
  isNear(all.motions[0].a, Math.SQRT1_2);
  isNear(all.motions[1].a, Math.SQRT2);
  // A chart without area keeps its size.
  const flat = { ...arrays, positions: positions.map(() => 0) };
  isNear(evened(flat, charts(1)).motions[0].a, 1);
});

test('a chart is scaled to a density relative to the others, and keeps it', async () => {
  const { atDensity, keptDensities } = await load('arrange/density');
  const { movedUv } = await load('arrange/move-charts');
  const arrays = atlas([SQUARE, SQUARE, SQUARE, SQUARE]);
  const positions = [0, 1, 2, 3].flatMap((chart) => SQUARE.flatMap(([x, y]) => [x, y, chart]));
  const before = { ...arrays, positions };
  const set = (from, chart, density, asked) => {
    const { uv } = from;
    const now = movedUv(from, atDensity(from, charts(chart), density, asked));
    return [{ ...from, uv: now }, keptDensities({ ...from, uv }, now, asked)];
  };
  assert.equal(keptDensities(before, before.uv, undefined), undefined);
  const [once, asked] = set(before, 1, 2);
  const perChart = (asked) => [0, 2, 4, 6].map((f) => asked[f]);
  areNear(perChart(asked).map(Math.fround), [1, 2, 1, 1]);
  assert.equal(keptDensities(once, once.uv, asked), asked, 'nothing has been scaled');
  // Set twice, it is the same; and the rest can be most of the surface.
  const [twice, same] = set(once, 1, 2, asked);
  assert.equal(same, asked);
  const [third, more] = set(twice, 2, 0.5, same);
  assert.deepEqual(perChart(more), [1, 2, 0.5, 1]);
  const [, fewer] = set(third, 1, 1, more);
  assert.deepEqual(perChart(fewer), [1, 1, 0.5, 1]);
  // Faces of several triangles, and triangles without a chart.
  const faces = Uint32Array.of(0, 0, 1, 1, 2, 2, 3, 3);
  assert.deepEqual([...set({ ...before, faces }, 1, 2)[1]], [1, 2, 1, 1]);
  const chartOfTriangle = Uint32Array.of(0, 0, 1, 1, 2, 2, 0xffffffff, 0xffffffff);
  assert.deepEqual(perChart(set({ ...before, chartOfTriangle }, 1, 2)[1]), [1, 2, 1, 1]);
});

test('where each tile has a density of its own, charts are compared with those in their tile', async () => {
  const { atDensity, evened, keptDensities } = await load('arrange/density');
  const { movedUv } = await load('arrange/move-charts');
  const arrays = atlas([SQUARE, SQUARE, SQUARE, SQUARE]);
  const positions = [0, 1, 2, 3].flatMap((chart) => SQUARE.flatMap(([x, y]) => [x, y, chart]));
  // The last two charts are in the second tile, three times as large.
  const scale = { motions: [2, 3].map(() => ({ a: 3, b: 0, x: 1, y: 0 })), charts: charts(2, 3) };
  const small = { ...arrays, uv: arrays.uv.map((x) => 0.1 * (x % 3)) };
  const before = { ...small, positions, uv: movedUv(small, scale), isByTile: true };
  for (const chart of [0, 2]) {
    isNear(atDensity(before, charts(chart), 2).motions[0].a, 2);
    isNear(evened(before, charts(chart)).motions[0].a, 1);
    const now = movedUv(before, atDensity(before, charts(chart), 0.5));
    const asked = keptDensities(before, now, undefined);
    areNear([asked[2 * chart]], [0.5]);
    assert.equal(asked.filter((density) => density !== 1).length, 2);
  }
});

test('charts keep their colours as long as they have the same triangles', async () => {
  const { KeptColors } = await load('workshop/kept-colors');
  const kept = new KeptColors();
  assert.equal(kept.of(charts(0, 1), 2), undefined);
  const colors = Float32Array.of(3, 5);
  kept.keep(charts(0, 1, 1), colors);
  const of = (...numbers) => [...kept.of(charts(...numbers), Math.max(...numbers) + 1)];
  assert.deepEqual(of(0, 1, 1), [3, 5]);
  assert.deepEqual(of(1, 0, 0), [5, 3], 'whatever their numbers are');
  assert.deepEqual(of(0, 0, 1), [-1, -1], 'none has the triangles of an earlier one');
  assert.deepEqual(of(0, 1, 2), [3, -1, -1], 'one was cut');
  assert.deepEqual(of(0, 0, 0), [-1], 'they were joined');
  assert.equal(kept.of(charts(0, 1), 2), undefined, 'of another mesh');
});

test('a check that ends after the next move does not take that back', async () => {
  const { Placement } = await load('tools/placement');
  const wanted = [];
  const placement = new Placement(
    { outcome: async () => ({}), keptDensities: async () => undefined },
    { placeCharts: () => undefined, showFlat: () => undefined, moveCharts: () => undefined },
    {
      placing: () => undefined,
      placed: ({ result }) => wanted.push(result),
      notPlaced: (error) => assert.fail(error),
    },
  );
  const first = { settings: {}, result: { uv: [0] } };
  const move = (by) => placement.place(async ({ result }) => ({ uv: [result.uv[0] + by] }), '');
  const checked = (placed) => ({ settings: { placed }, result: { uv: placed.uv } });
  placement.show(first);
  await move(1);
  await move(10);
  placement.show(checked(wanted[0]), wanted[1]);
  await move(100);
  assert.deepEqual(wanted[2].uv, [111]);
  const last = checked(wanted[2]);
  placement.show(last, wanted[2]);
  assert.equal(placement.current, last);
  // The user goes back.
  const back = checked(wanted[0]);
  placement.show(back, wanted[0]);
  assert.equal(placement.current, back);
  await move(1000);
  assert.deepEqual(wanted[3].uv, [1001]);
});

test('moves that do not wait for each other all count, and those of another atlas do not', async () => {
  const { Placement } = await load('tools/placement');
  const wanted = [];
  const refused = [];
  const placement = new Placement(
    { outcome: async () => ({}), keptDensities: async () => undefined },
    { placeCharts: () => undefined, showFlat: () => undefined, moveCharts: () => undefined },
    {
      placing: () => undefined,
      placed: ({ result }) => wanted.push(result),
      notPlaced: (error) => refused.push(error),
    },
  );
  const move = (by) => placement.place(async ({ result }) => ({ uv: [result.uv[0] + by] }), '');
  placement.show({ settings: {}, result: { uv: [0] } });
  await Promise.all([move(1), move(10), move(100)]);
  assert.deepEqual(
    wanted.map(({ uv }) => uv[0]),
    [1, 11, 111],
  );
  const late = move(1000);
  placement.show({ settings: {}, result: { uv: [5] } });
  await late;
  assert.deepEqual(refused, [null]);
  assert.equal(wanted.length, 3);
});
