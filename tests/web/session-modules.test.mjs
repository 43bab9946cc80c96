// One mesh and one run at a time, without a page: what is read, what is run, what is abandoned.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadModule as load } from './modules.mjs';

/** Stands for every mesh that is read. */
const TRIANGLE = {
  positions: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0),
  indices: Uint32Array.of(0, 1, 2),
};

/** An abflat whose runs end when the test says so. */
function fakeAbflat() {
  const calls = [];
  const call = (kind, detail, { signal, onProgress } = {}) =>
    new Promise((resolve, reject) => {
      signal?.addEventListener('abort', () => reject(new DOMException('aborted', 'AbortError')));
      calls.push({ kind, ...detail, signal, onProgress, resolve, reject });
    });
  return {
    calls,
    sample: (name, options) => call('sample', { name }, options),
    load: (file, options) => call('load', { name: file.name }, options),
    inspect: async () => ({ disk: { ok: true, code: 'Ok', message: '' } }),
    flatten: (_, { t, delaunay, ...options }) => call('flatten', { t, delaunay }, options),
    unwrap: (_, { signal, onProgress, ...options }) =>
      call('unwrap', options, { signal, onProgress }),
  };
}

const at = (t) => ({ mode: 'flatten', t, delaunay: false });
const textOf = (settings) => String(settings ? settings.t : null);

async function startSession(t) {
  t.mock.timers.enable({ apis: ['setTimeout'] });
  const { Session } = await load('session/session');
  const abflat = fakeAbflat();
  const log = [];
  let wish;
  const session = new Session(
    async () => abflat,
    {
      started: (source, settings) => log.push(`started ${source.name} ${textOf(settings)}`),
      progress: ({ fraction }) => log.push(`progress ${fraction}`),
      opened: ({ source }) => log.push(`opened ${source.name}`),
      laidOut: ({ mode, source, settings }) =>
        log.push(`${mode} ${source.name} ${textOf(settings)}`),
      cancelled: () => log.push('cancelled'),
      failed: (source, settings, error) =>
        log.push(`failed ${source.name} ${textOf(settings)} ${error.message}`),
    },
    () => wish,
    { mesh: async () => ({}), outcome: async () => ({}) },
  );
  /** Opens a mesh, or lays the open one out again, with other settings. */
  const open = (source, settings) => {
    wish = settings;
    session.open(source);
  };
  const ask = (settings) => {
    wish = settings;
    session.refresh();
  };
  const rest = async () => {
    for (let i = 0; i < 30; i++) await Promise.resolve();
  };
  /** The head, opened and read, with its layout in progress. */
  const openHead = async () => {
    open(HEAD, at(1));
    await rest();
    abflat.calls[0].resolve(TRIANGLE);
    await rest();
  };
  /** The head laid out, and the ball being read. */
  const openBall = async () => {
    await openHead();
    abflat.calls[1].resolve({});
    await rest();
    open(BALL, at(1));
    await rest();
  };
  return { session, open, openHead, openBall, ask, calls: abflat.calls, log, rest };
}

const HEAD = { kind: 'sample', name: 'head' };
const BALL = { kind: 'sample', name: 'ball' };

test('session: another condition is another wish, at the same t', async (t) => {
  const { openHead, ask, calls, rest } = await startSession(t);
  await openHead();
  ask({ mode: 'flatten', t: 1, delaunay: true });
  calls[1].resolve({});
  await rest();
  assert.deepEqual(
    calls.slice(1).map(({ t, delaunay }) => [t, delaunay]),
    [
      [1, false],
      [1, true],
    ],
  );
});

test('session: what runs aside gives way to a run', async (t) => {
  const { openHead, session, ask, calls, rest } = await startSession(t);
  const aside = session.aside(
    (abflat, input, signal) => abflat.flatten(input, { t: 9, signal }),
    new AbortController().signal,
  );
  await openHead();
  calls[1].resolve({});
  await rest();
  assert.equal(calls[2].t, 9);
  ask(at(1.5));
  await rest();
  assert.equal(calls[2].signal.aborted, true);
  assert.equal(calls[3].t, 1.5);
  assert.equal(calls.length, 4, 'it waits');
  calls[3].resolve({});
  await rest();
  assert.equal(calls[4].t, 9);
  calls[4].resolve('done');
  assert.equal(await aside, 'done');
});

test('session: reads, then flattens', async (t) => {
  const { openHead, calls, log, rest } = await startSession(t);
  await openHead();
  calls[1].onProgress({ fraction: 0.5 });
  calls[1].resolve({});
  await rest();
  assert.deepEqual(log, [
    'started head null',
    'opened head',
    'started head 1',
    'progress 0.5',
    'flatten head 1',
  ]);
});

test('session: a quick run is shown before the next starts; a slow one is aborted for the latest wish', async (t) => {
  const { openHead, ask, calls, log, rest } = await startSession(t);
  await openHead();
  ask(at(1.1));
  ask(at(1.2));
  calls[1].resolve({});
  await rest();
  assert.equal(calls.length, 3);
  assert.equal(calls[2].t, 1.2);
  ask(at(1.3));
  ask(at(1.4));
  assert.equal(calls[2].signal.aborted, false);
  t.mock.timers.tick(10_000);
  await rest();
  assert.equal(calls[2].signal.aborted, true);
  assert.equal(calls[3].t, 1.4);
  calls[3].resolve({});
  await rest();
  assert.deepEqual(log.slice(2), [
    'started head 1',
    'flatten head 1',
    'started head 1.2',
    'started head 1.4',
    'flatten head 1.4',
  ]);
});

test('session: cancelling drops the run and the wish; nothing comes late', async (t) => {
  const { openHead, session, ask, calls, log, rest } = await startSession(t);
  await openHead();
  ask(at(1.5));
  session.cancel();
  calls[1].onProgress({ fraction: 0.9 });
  t.mock.timers.tick(10_000);
  await rest();
  assert.equal(calls.length, 2);
  assert.equal(log.at(-1), 'cancelled');
  session.cancel();
  assert.equal(log.filter((line) => line === 'cancelled').length, 1);
  ask(at(1.5));
  await rest();
  calls[2].resolve({});
  await rest();
  assert.equal(log.at(-1), 'flatten head 1.5');
});

test('session: a mesh opened later wins over one that is still read', async (t) => {
  const { open, calls, log, rest } = await startSession(t);
  open(HEAD, at(1));
  open(BALL, at(1));
  await rest();
  assert.equal(calls[0].signal.aborted, true);
  calls[1].resolve(TRIANGLE);
  await rest();
  calls[2].resolve({});
  await rest();
  assert.deepEqual(log, [
    'started head null',
    'started ball null',
    'opened ball',
    'started ball 1',
    'flatten ball 1',
  ]);
});

test('session: what cannot be read leaves the mesh before, which can be flattened again', async (t) => {
  const { openBall, ask, calls, log, rest } = await startSession(t);
  await openBall();
  calls[2].reject(new Error('no ball'));
  await rest();
  assert.equal(log.at(-1), 'failed ball null no ball');
  ask(at(2));
  await rest();
  calls[3].resolve({});
  await rest();
  assert.equal(log.at(-1), 'flatten head 2');
});

test('session: what is asked for while a mesh is read is for that mesh, however long it takes', async (t) => {
  const { openBall, ask, calls, log, rest } = await startSession(t);
  await openBall();
  ask(at(1.2));
  t.mock.timers.tick(10_000);
  await rest();
  assert.equal(calls[2].signal.aborted, false, 'it is still read');
  assert.equal(calls.length, 3, 'the mesh before is left alone');
  calls[2].resolve(TRIANGLE);
  await rest();
  assert.equal(calls[3].t, 1.2);
  t.mock.timers.tick(10_000);
  await rest();
  calls[3].resolve({});
  await rest();
  assert.equal(calls.length, 4, 'once');
  assert.deepEqual(log.slice(-4), [
    'started ball null',
    'opened ball',
    'started ball 1.2',
    'flatten ball 1.2',
  ]);
});

test('session: where reading fails nothing runs by itself, so that the reason stays in view', async (t) => {
  const { openBall, ask, calls, log, rest } = await startSession(t);
  await openBall();
  ask(at(1.2));
  calls[2].reject(new Error('no ball'));
  t.mock.timers.tick(10_000);
  await rest();
  assert.equal(calls.length, 3);
  assert.equal(log.at(-1), 'failed ball null no ball');
  ask(at(1.2));
  await rest();
  calls[3].resolve({});
  await rest();
  assert.equal(log.at(-1), 'flatten head 1.2');
});

test('session: a wish for a run does not end the reading that replaces the run', async (t) => {
  const { openHead, open, ask, calls, log, rest } = await startSession(t);
  await openHead();
  ask(at(1.2));
  open(BALL, at(1.2));
  await rest();
  t.mock.timers.tick(10_000);
  await rest();
  assert.equal(calls[1].signal.aborted, true);
  assert.equal(calls[2].signal.aborted, false);
  calls[2].resolve(TRIANGLE);
  await rest();
  calls[3].resolve({});
  await rest();
  assert.equal(log.at(-1), 'flatten ball 1.2');
});

test('session: cancelling while a mesh is read leaves the one before, and no wish', async (t) => {
  const { openBall, ask, session, calls, log, rest } = await startSession(t);
  await openBall();
  ask(at(1.2));
  session.cancel();
  t.mock.timers.tick(10_000);
  await rest();
  assert.equal(calls[2].signal.aborted, true);
  assert.equal(calls.length, 3);
  assert.equal(log.at(-1), 'cancelled');
  ask(at(1.3));
  await rest();
  calls[3].resolve({});
  await rest();
  assert.equal(log.at(-1), 'flatten head 1.3');
});

test('session: an atlas is asked for with its own options, in the format of the file', async (t) => {
  const { openHead, ask, calls, log, rest } = await startSession(t);
  await openHead();
  calls[1].resolve({});
  await rest();
  ask({ mode: 'unwrap', maxStretch: 1.1, resolution: 512, padding: 2 });
  await rest();
  const { kind, maxStretch, obj } = calls[2];
  assert.deepEqual([kind, maxStretch, obj], ['unwrap', 1.1, true]);
  calls[2].resolve({ report: { charts: [] } });
  await rest();
  assert.match(log.at(-1), /^unwrap head/);
});

test('session: charts that are packed again are cut nowhere else, and may move', async (t) => {
  const { openHead, ask, calls, rest } = await startSession(t);
  await openHead();
  calls[1].resolve({});
  await rest();
  const usual = { mode: 'unwrap', seams: 'auto', maxStretch: 1.1 };
  ask(usual);
  await rest();
  const report = { charts: [{ stackedOn: -1 }], valid: true, options: { stack: 'none' } };
  const result = { report, seams: Uint32Array.of(3, 4) };
  calls[2].resolve(result);
  await rest();
  const placed = { ...result, repacks: true };
  const lock = { kept: { layout: result, charts: Uint32Array.of(0) } };
  for (const [wish, expected] of [
    [{ placed }, { known: placed, seams: 'none', seamEdges: result.seams, keepsPlaces: false }],
    // Another option lays out anew.
    [{ maxStretch: 1.2 }, { known: result, seams: 'auto', keepsPlaces: false }],
    [
      { ...lock, placed: { ...placed } },
      { known: result, fixedCharts: lock.kept.charts, seams: 'none', keepsPlaces: false },
    ],
    // What was moved stays.
    [{ placed: { ...result } }, { seams: 'none', seamEdges: result.seams, keepsPlaces: true }],
  ]) {
    ask({ ...usual, ...wish });
    await rest();
    for (const [name, value] of Object.entries(expected))
      assert.deepEqual(calls.at(-1)[name], value, name);
    calls.at(-1).resolve(result);
    await rest();
  }
});

test('session: when abflat cannot start, that is what a mesh fails with', async () => {
  const { Session } = await load('session/session');
  const failures = [];
  const session = new Session(() => Promise.reject(new Error('no module')), {
    started: () => undefined,
    failed: (source, settings, error) => failures.push([source.name, settings, error.message]),
  });
  await session.open(HEAD);
  assert.deepEqual(failures, [['head', null, 'no module']]);
});

test('background work gives way to a run, starts over, and ends for good when it is stopped', async () => {
  const { Background } = await load('base/background');
  const background = new Background();
  const attempts = [];
  const work = (signal) =>
    new Promise((resolve, reject) => {
      attempts.push({ signal, resolve });
      signal.addEventListener('abort', () => reject(new DOMException('aborted', 'AbortError')));
    });
  const stop = new AbortController();
  const rest = async () => {
    for (let i = 0; i < 30; i++) await Promise.resolve();
  };
  background.pause();
  const first = background.run(work, stop.signal);
  await rest();
  assert.equal(attempts.length, 0, 'it waits for the run');
  background.resume();
  await rest();
  assert.equal(attempts.length, 1);
  background.pause();
  await rest();
  assert.ok(attempts[0].signal.aborted);
  background.pause();
  background.resume();
  await rest();
  assert.equal(attempts.length, 2);
  attempts[1].resolve('done');
  assert.equal(await first, 'done');

  const second = background.run(work, stop.signal);
  await rest();
  stop.abort();
  await assert.rejects(second, { name: 'AbortError' });
  assert.equal(attempts.length, 3);
  await assert.rejects(
    background.run(() => Promise.reject(new Error('broken')), new AbortController().signal),
    /broken/,
  );
});
