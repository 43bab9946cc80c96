// How much of its time a run has taken, from the work that abflat reports.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadModule } from './modules.mjs';

const { RunClock } = await loadModule('controls/run-clock');

/** What a clock says of a run of so many seconds: work as abflat reports it, at shares of the time. */
function follow(expected, seconds, reports) {
  let now = 0;
  const clock = new RunClock(expected, () => now);
  const said = reports.map(([time, work]) => {
    now = 1000 * seconds * time;
    return { time, ...clock.at(work) };
  });
  now = 1000 * seconds;
  return { said, pace: clock.pace() };
}

/** The work goes on slowly at first, and stands still for a while. */
const UNEVEN = [
  [0.1, 0.02],
  [0.3, 0.1],
  [0.5, 0.6],
  [0.7, 0.6],
  [0.8, 0.7],
  [0.95, 0.99],
];

test('a bar shows the work of a first run, and what is left', () => {
  const { said } = follow(undefined, 10, [
    [0.1, 0.1],
    [0.3, 0.25],
    [0.4, 0.2],
    [0.8, 0.8],
  ]);
  assert.deepEqual(
    said.map(({ passed, left }) => [passed, left]),
    [
      [0.1, null],
      [0.25, 9],
      [0.25, 10],
      [0.8, 2],
    ],
  );
});

test('the next run knows how this one went', () => {
  const { pace } = follow(undefined, 30, UNEVEN);
  assert.equal(pace(0), 0);
  assert.equal(pace(1), 1);
  for (const { time, passed, left } of follow(pace, 60, UNEVEN).said) {
    if (time !== 0.7) assert.ok(Math.abs(passed - time) < 1e-9, `${passed} at ${time}`);
    if (time > 0.1) assert.ok(Math.abs(left - 60 * (1 - time)) <= 26, `${left} s at ${time}`);
  }
});

test('nothing is learnt from a run that did not come to its end', () => {
  assert.equal(follow(undefined, 10, UNEVEN.slice(0, 4)).pace, null);
  assert.equal(follow(undefined, 10, []).pace, null);
});
