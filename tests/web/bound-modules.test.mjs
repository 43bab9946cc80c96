// Bounds of single vertices, without a page: painted, erased, kept, named.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadModule } from './modules.mjs';

const { differences, withBound, withoutBound } = await loadModule('mesh/vertex-bounds');
const { changeBetween } = await loadModule('session/change');
const { sameSettings } = await loadModule('model/settings');
const { askedOf, settingsAskedFor } = await loadModule('visit/visit-record');
const { foundChart } = await loadModule('model/found-chart');
const { textOf } = await loadModule('visit/settings-text');

const DISK = { mode: 'flatten', t: 'auto', balance: 0, delaunay: false };

test('painting gives vertices one bound each, erasing takes it away', () => {
  const first = withBound([], [5, 2, 5], 1);
  assert.deepEqual(first, [
    { vertex: 2, t: 1 },
    { vertex: 5, t: 1 },
  ]);
  const second = withBound(first, [5, 3], 1.5);
  assert.deepEqual(second, [
    { vertex: 2, t: 1 },
    { vertex: 3, t: 1.5 },
    { vertex: 5, t: 1.5 },
  ]);
  assert.equal(differences(first, second), 2);
  assert.equal(differences(second, second), 0);
  assert.equal(differences(first, []), 2);
  assert.deepEqual(withoutBound(second, [3, 5, 9]), [{ vertex: 2, t: 1 }]);
  assert.deepEqual(first.length, 2, 'nothing is changed in place');
});

test('settings with other bounds are others, and the history names them', () => {
  const bounds = withBound([], [1, 2], 1);
  assert.ok(!sameSettings(DISK, { ...DISK, bounds }));
  assert.ok(sameSettings({ ...DISK, bounds }, { ...DISK, bounds }));
  assert.ok(sameSettings(DISK, { ...DISK, bounds: undefined }));
  assert.equal(changeBetween(DISK, { ...DISK, bounds }).text, 'Bounds of 2 vertices');
  assert.equal(changeBetween({ ...DISK, bounds }, DISK).text, 'No painted bounds');
});

test('a visit keeps bounds, a link does not', () => {
  const bounds = withBound([], [1, 2], 1);
  const settings = { ...DISK, bounds };
  const asked = askedOf({ mode: 'flatten', settings }, {});
  assert.deepEqual(settingsAskedFor(asked), settings);
  assert.equal(textOf(settings), textOf(DISK));
  assert.deepEqual(settingsAskedFor(askedOf({ mode: 'flatten', settings: DISK }, {})), DISK);
});

test('bounds that were asked for are not among those that were found', () => {
  const result = { report: { charts: [{ t: 2, bounds: withBound([], [1, 2, 3], 1) }] } };
  const settings = { ...DISK, bounds: withBound([], [2], 1) };
  const found = foundChart({ settings, result });
  assert.deepEqual(
    found.bounds.map(({ vertex }) => vertex),
    [1, 3],
  );
  assert.equal(found.t, 2);
});
