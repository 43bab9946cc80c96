// Which charts are selected and hidden.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadModule as load } from './modules.mjs';

async function made() {
  const { ChartSelection } = await load('selection/chart-selection');
  let changes = 0;
  const selection = new ChartSelection(() => {
    changes += 1;
  });
  const sets = () => [[...selection.selected], [...selection.hidden]];
  return { selection, sets, changes: () => changes };
}

test('a pick replaces the selection, or changes it by one chart', async () => {
  const { selection, sets } = await made();
  selection.pick(3, false);
  selection.pick(5, true);
  assert.deepEqual(sets(), [[3, 5], []]);
  selection.pick(3, true);
  assert.deepEqual(sets(), [[5], []]);
  selection.pick(1, false);
  assert.deepEqual(sets(), [[1], []]);
  selection.pick(null, true);
  assert.deepEqual(sets(), [[1], []], 'beside the charts nothing is added');
  selection.pick(null, false);
  assert.deepEqual(sets(), [[], []]);
});

test('hidden charts are not selected, and all means those that are shown', async () => {
  const { selection, sets } = await made();
  selection.pick(0, false);
  selection.pick(2, true);
  selection.hide();
  assert.deepEqual(sets(), [[], [0, 2]]);
  selection.pickAll(4);
  assert.deepEqual(sets(), [
    [1, 3],
    [0, 2],
  ]);
  selection.isolate(4);
  assert.deepEqual(sets(), [
    [1, 3],
    [0, 2],
  ]);
  selection.showAll();
  assert.deepEqual(sets(), [[1, 3], []]);
  selection.pickNone();
  selection.isolate(4);
  assert.deepEqual(sets(), [[], []], 'nothing selected: nothing to isolate');
});

test('the same chart under the pointer is no change', async () => {
  const { selection, changes } = await made();
  selection.hover(4);
  selection.hover(4);
  assert.equal(changes(), 1);
  selection.clear();
  assert.equal(selection.hovered, null);
});

test('edges are those of the charts that are wanted', async () => {
  const { edgesOfCharts } = await load('view/edges-of-charts');
  const ends = Float32Array.from({ length: 18 }, (_, i) => i);
  const found = edgesOfCharts(ends, Uint32Array.of(7, 2, 7), (chart) => chart === 7);
  assert.deepEqual([...found], [0, 1, 2, 3, 4, 5, 12, 13, 14, 15, 16, 17]);
});
