// The history without a page: which changes are steps, what is kept of their results.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadModule as load } from './modules.mjs';

const atlas = (some = {}) => ({ mode: 'unwrap', maxStretch: 1.02, padding: 2, ...some });

/** Steps with a clock that stands still unless it is set. */
async function stepsFor(t) {
  const { Steps } = await load('session/steps');
  const clock = { now: 0 };
  const shown = t.mock.fn();
  const steps = new Steps(shown, () => clock.now);
  steps.begin('Open', atlas());
  return { steps, clock, shown };
}

const result = (settings, bytes = 8) => ({ settings, result: { uv: new Uint8Array(bytes) } });
const texts = (steps) => steps.all.map(({ text }) => text);

test('undo and redo go through the steps, and a change drops those that were undone', async (t) => {
  const { steps, shown } = await stepsFor(t);
  assert.ok(!steps.canUndo && !steps.canRedo);
  const before = shown.mock.callCount();
  steps.change(atlas({ padding: 4 }));
  assert.equal(shown.mock.callCount(), before + 1);
  steps.change(atlas({ padding: 4, resolution: 512 }));
  steps.change(atlas({ padding: 4, resolution: 512 }), 'Repacked');
  assert.deepEqual(texts(steps), ['Open', 'Padding 4', 'Resolution 512\u202fpx', 'Repacked']);
  assert.equal(steps.go(3), null, 'it is there already');
  assert.equal(steps.go(7), null, 'there is no such step');
  assert.equal(steps.go(1).settings.padding, 4);
  assert.ok(steps.canUndo && steps.canRedo);
  steps.change(atlas({ padding: 4, udim: true }));
  assert.deepEqual(texts(steps), ['Open', 'Padding 4', 'UDIM tiles']);
  assert.ok(!steps.canRedo);
  steps.begin('Open another', atlas());
  assert.deepEqual(texts(steps), ['Open another']);
});

test('the last result of some settings is found, unless it was undone', async (t) => {
  const { steps } = await stepsFor(t);
  const [first, later] = [result(atlas()), result(atlas())];
  assert.equal(steps.resultOf(atlas()), null, 'there is none yet');
  steps.settle(first);
  steps.change({ mode: 'flatten', t: 1 });
  assert.equal(steps.resultOf(atlas()), first);
  assert.equal(steps.resultOf(atlas({ padding: 4 })), null);
  steps.change(atlas());
  steps.settle(later);
  assert.equal(steps.resultOf(atlas()), later);
  steps.go(1);
  assert.equal(steps.resultOf(atlas()), first);
});

test('what comes from a slider in quick succession is one step', async (t) => {
  const { steps, clock } = await stepsFor(t);
  const drag = (maxStretch) => steps.change(atlas({ maxStretch }));
  drag(1.03);
  clock.now += 200;
  drag(1.04);
  assert.deepEqual(texts(steps), ['Open', 'Max stretch 1.04']);
  // Slowly, but with no result in between.
  clock.now += 5000;
  drag(1.05);
  assert.deepEqual(texts(steps), ['Open', 'Max stretch 1.05']);
  steps.settle(result(atlas({ maxStretch: 1.05 })));
  clock.now += 5000;
  drag(1.06);
  assert.deepEqual(texts(steps), ['Open', 'Max stretch 1.05', 'Max stretch 1.06']);
  // Another slider, and what is no slider.
  steps.change(atlas({ maxStretch: 1.06, balance: 0.5 }));
  steps.change(atlas({ maxStretch: 1.06, balance: 0.5, seams: 'none' }));
  steps.change(atlas({ maxStretch: 1.06, balance: 0.5, seams: 'uv' }));
  assert.deepEqual(texts(steps).slice(3), ['Balance 0.5', 'Seams: none', 'Seams: uv']);
  // After undo, a new drag does not change the step that it starts from.
  steps.go(2);
  steps.change(atlas({ maxStretch: 1.08 }));
  assert.deepEqual(texts(steps).slice(1), [
    'Max stretch 1.05',
    'Max stretch 1.06',
    'Max stretch 1.08',
  ]);
});

test('a result belongs to the step whose settings it has, and only so many are kept', async (t) => {
  const { steps } = await stepsFor(t);
  const big = 2 ** 26;
  steps.settle(result(atlas(), big));
  for (let padding = 3; padding < 11; ++padding) {
    const settings = atlas({ padding, seams: String(padding) });
    steps.change(settings, `Padding ${padding}`);
    steps.settle(result(atlas(), big));
    assert.equal(steps.all.at(-1).outcome, null, 'a late result of other settings');
    steps.settle(result(settings, big));
  }
  const kept = () => steps.all.flatMap(({ outcome }, i) => (outcome ? [i] : []));
  assert.deepEqual(kept(), [5, 6, 7, 8], 'the nearest');
  steps.go(0);
  steps.settle(result(atlas(), 8 * big));
  assert.deepEqual(kept(), [0], 'the current one always');
});

test('what undo and redo lead to is kept even if it is large, and what is shared costs nothing', async (t) => {
  const { steps } = await stepsFor(t);
  const large = 2.5 * 2 ** 26;
  const shared = new Uint8Array(large);
  const same = (settings) => ({ settings, result: { uv: shared } });
  steps.settle(same(atlas()));
  for (let padding = 3; padding < 6; ++padding) {
    steps.change(atlas({ padding }), `Padding ${padding}`);
    steps.settle(padding === 3 ? same(atlas({ padding })) : result(atlas({ padding }), large));
  }
  const kept = () => steps.all.flatMap(({ outcome }, i) => (outcome ? [i] : []));
  assert.deepEqual(kept(), [2, 3], 'a third one is too much');
  steps.go(1);
  steps.settle(same(atlas({ padding: 3 })));
  assert.deepEqual(kept(), [1, 2]);
  steps.go(0);
  steps.settle(same(atlas()));
  assert.deepEqual(kept(), [0, 1]);
});

test('changes are named by what differs', async () => {
  const { changeBetween } = await load('session/change');
  const named = (some) => changeBetween(atlas(), atlas(some)).text;
  assert.equal(named({ seams: 'auto,sharp=60' }), 'Seams: auto, sharp=60');
  assert.equal(named({ seamEdges: Uint32Array.of(0, 1, 1, 2) }), 'Seams of 2 edges');
  assert.equal(named({ fixedFaces: 'uv' }), 'Keep UVs of the file');
  assert.equal(named({ rotate: 'none' }), 'Rotation none');
  assert.equal(named({ texelDensity: 3 }), 'Texel density 3');
  assert.equal(named({ fillHoles: 'never' }), 'Fill holes never');
  assert.equal(named({}), 'Repacked');
  const disk = { mode: 'flatten', t: 1, balance: 0, delaunay: false };
  assert.equal(changeBetween(atlas(), disk).text, 'Flatten');
  assert.equal(changeBetween(disk, { ...disk, t: 'auto' }).text, 'Boundary t auto');
  assert.equal(changeBetween(disk, { ...disk, delaunay: true }).text, 'Delaunay');
});

test('only seams have changed if all else is the same', async () => {
  const { isMadeByHand, sameButSeams, sameSettings } = await load('model/settings');
  const edges = Uint32Array.of(0, 1);
  assert.ok(sameButSeams(atlas({ seams: 'auto' }), atlas({ seams: 'none', seamEdges: edges })));
  assert.ok(!sameButSeams(atlas(), atlas({ padding: 3, seamEdges: edges })));
  assert.ok(sameSettings(atlas({ seamEdges: undefined }), atlas()));
  assert.ok(sameSettings(atlas({ kept: {} }), atlas()), 'locks are no reason to lay out again');
  assert.ok(!sameSettings(atlas({ placed: {} }), atlas({ placed: {} })));
  assert.ok(isMadeByHand(atlas({ placed: {} })));
  assert.ok(!isMadeByHand(atlas({ placed: { repacks: true } })), 'packing is not by hand');
});
