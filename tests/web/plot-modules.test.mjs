// The parts of the page's charts that need no page.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadModule as load } from './modules.mjs';

test('axes: a linear one begins at 0 and covers its values, a logarithmic one has whole powers of ten', async () => {
  const { linearScale, logScale, power } = await load('plot/scale');
  for (const most of [0, 0.00035, 1, 7.3, 486]) {
    const { at, ticks } = linearScale(most, 4);
    assert.equal(at(0), 0);
    assert.ok(at(most) <= 1 + 1e-12);
    assert.ok(ticks.length >= 2 && ticks.length <= 6, `${ticks.length} ticks up to ${most}`);
    assert.ok(Math.abs(at(ticks.at(-1).value) - 1) < 1e-12);
  }
  const { at, ticks } = logScale([0, 3e-9, 0.2], 5);
  assert.ok(at(3e-9) > 0 && at(0.2) < 1);
  assert.equal(at(0), 0, 'what has no logarithm lies on the lower end');
  assert.ok(ticks.length <= 6);
  for (const { value } of ticks) assert.ok(at(value) > -1e-12 && at(value) < 1 + 1e-12);
  assert.equal(power(-12), '10⁻¹²');
});

test('the areas of a chart’s columns are disjoint, cover it and hold their values', async () => {
  const { columnAreas } = await load('plot/draw');
  const frame = { x: (x) => 100 * x, y: (y) => 200 - y };
  const columns = [
    { x: 1, y: 50 },
    { x: 1.2, y: 20 },
    { x: 2, y: 10 },
    { x: 2, y: 90 },
  ];
  const areas = columnAreas(columns, frame, 220);
  const holds = ({ x, y, width, height }, px, py) =>
    px >= x && px <= x + width && py >= y && py <= y + height;
  columns.forEach((column, i) => {
    const holders = areas.filter((area) => holds(area, frame.x(column.x), frame.y(column.y)));
    assert.deepEqual(holders, [areas[i]]);
  });
  const total = areas.reduce((sum, { width, height }) => sum + width * height, 0);
  const [left, right] = [areas[0].x, areas[3].x + areas[3].width];
  assert.ok(Math.abs(total - 220 * (right - left)) < 1e-9);
});
