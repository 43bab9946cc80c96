// Jobs of several suites run in parallel.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { runPool } from '../../scripts/lib/pool.mjs';

/** Suites whose jobs end on demand; `running` has the names of those that have begun. */
function played(shape) {
  const running = new Map();
  const job = (name) => ({
    name,
    run: () => new Promise((resolve) => running.set(name, () => resolve({ output: name }))),
  });
  const suites = Object.entries(shape).map(([title, names]) => ({ title, jobs: names.map(job) }));
  const end = async (name) => {
    running.get(name)();
    running.delete(name);
    await new Promise(setImmediate);
  };
  return { suites, running, end };
}

test('never more jobs than slots, and the next suite fills what the last one leaves', async () => {
  const { suites, running, end } = played({ a: ['1', '2', '3'], b: ['4', '5'] });
  const shown = [];
  const all = runPool(suites, 2, ({ title, parts }) =>
    shown.push([title, parts.map(({ output }) => output)]),
  );
  assert.deepEqual([...running.keys()], ['1', '2']);
  await end('2');
  assert.deepEqual([...running.keys()], ['1', '3']);
  await end('3');
  assert.deepEqual([...running.keys()], ['1', '4']);
  assert.deepEqual(shown, [], 'a suite is shown in one piece');
  await end('4');
  await end('5');
  assert.deepEqual(shown, [['b', ['4', '5']]]);
  await end('1');
  await all;
  assert.deepEqual(shown.at(-1), ['a', ['1', '2', '3']], 'in the order of its jobs');
});

test('what waits most of the time runs beside the others, and in their place at the end', async () => {
  const { suites, running, end } = played({ busy: ['1', '2', '3'], page: ['a', 'b', 'c', 'd'] });
  suites[1].waits = true;
  const shown = [];
  const show = ({ title }) => shown.push(title);
  const all = runPool(suites, 2, show);
  assert.deepEqual([...running.keys()], ['1', '2', 'a']);
  await end('a');
  assert.deepEqual([...running.keys()], ['1', '2', 'b']);
  await end('1');
  await end('2');
  assert.deepEqual([...running.keys()], ['b', '3', 'c']);
  for (const name of ['b', '3', 'c', 'd']) await end(name);
  await all;
  assert.deepEqual(shown, ['busy', 'page']);

  const alone = played({ page: ['a', 'b', 'c'] });
  alone.suites[0].waits = true;
  const rest = runPool(alone.suites, 2, show);
  assert.deepEqual([...alone.running.keys()], ['a', 'b']);
  for (const name of ['a', 'b', 'c']) await alone.end(name);
  await rest;
});

test('the records are in the order of the suites, whichever ended first', async () => {
  const { suites, end } = played({ slow: ['1'], fast: ['2'] });
  const shown = [];
  const all = runPool(suites, 2, ({ title }) => shown.push(title));
  await end('2');
  await end('1');
  assert.deepEqual(
    (await all).map(({ title }) => title),
    ['slow', 'fast'],
  );
  assert.deepEqual(shown, ['fast', 'slow']);
});

test('what repeats others comes last, and is skipped and named once it is late', async () => {
  const { suites, running, end } = played({
    again: ['1', '2'],
    busy: ['3', '4'],
    page: ['a', 'b'],
  });
  suites[0].repeats = true;
  suites[2].waits = true;
  let isLate = false;
  const all = runPool(
    suites,
    1,
    () => undefined,
    () => isLate,
  );
  assert.deepEqual([...running.keys()], ['3', 'a']);
  await end('3');
  await end('a');
  assert.deepEqual([...running.keys()], ['4', 'b']);
  await end('b');
  await end('4');
  assert.deepEqual([...running.keys()], ['1']);
  isLate = true;
  await end('1');
  const [again] = await all;
  assert.deepEqual(
    again.parts.map(({ skipped }) => skipped),
    [undefined, 1],
  );
  assert.match(again.parts[1].output, /^2: skipped for lack of time/);
});
