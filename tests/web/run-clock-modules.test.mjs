// How much of its time a run has taken, from the work that abflat reports.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadModule } from './modules.mjs';

const { RunClock, usualSearch } = await loadModule('controls/run-clock');

/** What a clock says of a run of so many seconds: work as abflat reports it, at shares of the time. */
function follow(search, seconds, reports) {
  let now = 0;
  const clock = new RunClock(search, () => now);
  const said = reports.map(([time, work]) => {
    now = 1000 * seconds * time;
    return { time, ...clock.at(work) };
  });
  return { said, clock };
}

/** The first seams take a fifth of the time, others nearly all the rest. */
const SEARCHED = [
  [0.01, 0.05],
  [0.05, 0.25],
  [0.1, 0.4],
  [0.15, 0.5],
  [0.19, 0.76],
  ...[0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9].map((time) => [time, 0.76]),
  [0.95, 0.88],
  [0.99, 0.97],
];

/** The first seams take longer. */
const LONG = [
  [0.02, 0.05],
  [0.1, 0.2],
  [0.2, 0.4],
  [0.3, 0.5],
  [0.4, 0.76],
  ...[0.5, 0.6, 0.7, 0.8, 0.9].map((time) => [time, 0.76]),
  [0.95, 0.88],
  [0.99, 0.97],
];

test('a bar shows the time of a run, and what is left, though the work stands still', () => {
  const { said } = follow(usualSearch(6000), 40, SEARCHED);
  for (const { time, passed, left } of said) {
    assert.ok(Math.abs(passed - time) < 0.15, `${passed} at ${time}`);
    if (time >= 0.19) assert.ok(Math.abs(left - 40 * (1 - time)) <= 8, `${left} s at ${time}`);
  }
  for (let i = 1; i < said.length; ++i) assert.ok(said[i].passed >= said[i - 1].passed);
});

test('the next run on a mesh knows how long this one took', () => {
  const { said, clock } = follow(usualSearch(50_000), 30, LONG);
  assert.ok(
    said.slice(0, -2).every(({ left }) => left === null),
    'nobody knows yet',
  );
  assert.ok(clock.search.isSure);
  for (const { time, passed } of follow(clock.search, 30, LONG).said)
    assert.ok(Math.abs(passed - time) < 0.2, `${passed} at ${time}`);
});

test('nothing is said of the end at the beginning, nor once it should have come', () => {
  const late = [
    [0.01, 0.05],
    [0.05, 0.76],
    [0.6, 0.76],
  ];
  const { said } = follow(usualSearch(6000), 60, late);
  assert.equal(said[0].left, null);
  assert.ok(said[1].left > 0);
  assert.equal(said[2].left, null);
  const even = follow(null, 10, [
    [0.1, 0.1],
    [0.5, 0.5],
  ]).said;
  assert.deepEqual(
    even.map(({ passed, left }) => [passed, left]),
    [
      [0.1, null],
      [0.5, 5],
    ],
  );
});
