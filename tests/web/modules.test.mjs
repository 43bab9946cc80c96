// The page's modules that need no page.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadModule as load } from './modules.mjs';

/** A square of two triangles, tilted. */
const SQUARE = {
  positions: Float64Array.of(0, 0, 0, 2, 0, 1, 2, 2, 1, 0, 2, 0),
  indices: Uint32Array.of(0, 1, 2, 0, 2, 3),
};

test('boundary edges are those with one triangle, in its direction', async () => {
  const { boundaryEdges } = await load('mesh');
  const edges = [...boundaryEdges(SQUARE.indices)];
  const pairs = edges.flatMap((v, i) => (i % 2 === 0 ? [`${v}-${edges[i + 1]}`] : []));
  assert.deepEqual(pairs.sort(), ['0-1', '1-2', '2-3', '3-0']);
});

test('a plane faces along its normal, a closed surface nowhere', async () => {
  const { facing } = await load('mesh');
  const plane = facing(SQUARE);
  const length = Math.hypot(1, 2);
  [-1 / length, 0, 2 / length].forEach((x, d) => {
    assert.ok(Math.abs(plane.direction[d] - x) < 1e-12);
  });
  assert.ok(Math.abs(plane.clarity - 1) < 1e-12);
  const closed = facing({
    positions: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1),
    indices: Uint32Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3),
  });
  assert.ok(closed.clarity < 1e-12);
});

test('angle errors are 0 for a similar layout and follow their definition else', async () => {
  const { angleErrors } = await load('angle-error');
  const positions = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0);
  const indices = Uint32Array.of(0, 1, 2);
  const same = Float64Array.of(3, 3, 3, 5, 1, 3);
  assert.ok(angleErrors({ positions, indices, uv: same })[0] < 1e-6);
  const equilateral = Float64Array.of(0, 0, 1, 0, 0.5, Math.sqrt(3) / 2);
  // 90, 45, 45 degrees become 60 each: -1/3, 1/3, 1/3.
  assert.ok(Math.abs(angleErrors({ positions, indices, uv: equilateral })[0] - 1 / 3) < 1e-6);
});

test('checker cells do not depend on the unit of the layout or of the mesh', async () => {
  const { checkerCells } = await load('checker');
  const uv = Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1);
  const cells = checkerCells({ ...SQUARE, uv });
  const larger = checkerCells({ ...SQUARE, uv: uv.map((x) => 1000 * x - 7) });
  const smaller = checkerCells({ ...SQUARE, positions: SQUARE.positions.map((x) => x / 50), uv });
  cells.forEach((x, i) => {
    assert.ok(Math.abs(x - larger[i]) < 1e-3);
    assert.ok(Math.abs(x - smaller[i]) < 1e-3);
  });
});

test('crossings are found where they are, and only there', async () => {
  const { crossings } = await load('crossings');
  const bowTie = Float64Array.of(0, 0, 2, 2, 2, 0, 0, 2);
  const loop = Uint32Array.of(0, 1, 1, 2, 2, 3, 3, 0);
  assert.deepEqual([...crossings(bowTie, loop, 10)], [1, 1]);
  const square = Float64Array.of(0, 0, 2, 0, 2, 2, 0, 2);
  assert.equal(crossings(square, loop, 10).length, 0);
});

test('numbers keep three digits and a bounded length', async () => {
  const { measure, brief, duration, bound } = await load('format');
  assert.equal(measure(0.0025234), '0.00252');
  assert.equal(measure(1.6777), '1.68');
  assert.equal(measure(12345.6), '12346');
  assert.equal(measure(0.00001234), '1.23e-5');
  assert.equal(measure(Number.NaN), 'not finite');
  assert.equal(duration(0.0361), '36\u202fms');
  assert.equal(duration(1.256), '1.26\u202fs');
  assert.equal(bound(0.968), '0.968');
  for (let x = 1e-9; x < 1e12; x *= 3.7) {
    assert.ok(measure(x).length <= 9, measure(x));
    assert.ok(brief(x).length <= 7, brief(x));
    assert.ok(Math.abs(Number(brief(x)) - x) <= 0.06 * x, brief(x));
  }
});

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
    unwrap: (_, { maxStretch, obj, ...options }) => call('unwrap', { maxStretch, obj }, options),
  };
}

const at = (t) => ({ mode: 'flatten', t, delaunay: false });
const textOf = (settings) => String(settings ? settings.t : null);

async function startSession(t) {
  t.mock.timers.enable({ apis: ['setTimeout'] });
  const { Session } = await load('session');
  const abflat = fakeAbflat();
  const log = [];
  let wish;
  const session = new Session(
    Promise.resolve(abflat),
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
  return { session, open, ask, calls: abflat.calls, log, rest };
}

const HEAD = { kind: 'sample', name: 'head' };
const BALL = { kind: 'sample', name: 'ball' };

test('session: another condition is another wish, at the same t', async (t) => {
  const { open, ask, calls, rest } = await startSession(t);
  open(HEAD, at(1));
  await rest();
  calls[0].resolve(SQUARE);
  await rest();
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
  const { session, open, ask, calls, rest } = await startSession(t);
  const aside = session.aside(
    (abflat, input, signal) => abflat.flatten(input, { t: 9, signal }),
    new AbortController().signal,
  );
  open(HEAD, at(1));
  await rest();
  calls[0].resolve(SQUARE);
  await rest();
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
  const { open, calls, log, rest } = await startSession(t);
  open(HEAD, at(1));
  await rest();
  calls[0].resolve(SQUARE);
  await rest();
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
  const { open, ask, calls, log, rest } = await startSession(t);
  open(HEAD, at(1));
  await rest();
  calls[0].resolve(SQUARE);
  await rest();
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
  const { session, open, ask, calls, log, rest } = await startSession(t);
  open(HEAD, at(1));
  await rest();
  calls[0].resolve(SQUARE);
  await rest();
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
  calls[1].resolve(SQUARE);
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
  const { open, ask, calls, log, rest } = await startSession(t);
  open(HEAD, at(1));
  await rest();
  calls[0].resolve(SQUARE);
  await rest();
  calls[1].resolve({});
  await rest();
  open(BALL, at(1));
  await rest();
  calls[2].reject(new Error('no ball'));
  await rest();
  assert.equal(log.at(-1), 'failed ball null no ball');
  ask(at(2));
  await rest();
  calls[3].resolve({});
  await rest();
  assert.equal(log.at(-1), 'flatten head 2');
});

test('session: an atlas is asked for with its own options, in the format of the file', async (t) => {
  const { open, ask, calls, log, rest } = await startSession(t);
  open(HEAD, at(1));
  await rest();
  calls[0].resolve(SQUARE);
  await rest();
  calls[1].resolve({});
  await rest();
  ask({ mode: 'unwrap', maxStretch: 1.1, resolution: 512, padding: 2 });
  await rest();
  const { kind, maxStretch, obj } = calls[2];
  assert.deepEqual([kind, maxStretch, obj], ['unwrap', 1.1, true]);
  calls[2].resolve({});
  await rest();
  assert.match(log.at(-1), /^unwrap head/);
});

test('charts that meet differ in colour, a chart is of one colour', async () => {
  const { chartColors } = await load('chart-colors');
  const { weld } = await load('weld');
  // A strip of 40 triangles in pieces, each pair a chart.
  const positions = Float64Array.from(
    Array.from({ length: 40 }, (_, f) => [f, f + 1, f + 2].flatMap((i) => [i, i % 2, 0])).flat(),
  );
  const indices = Uint32Array.from({ length: 120 }, (_, c) => c);
  const charts = Uint32Array.from({ length: 40 }, (_, f) => f >> 1);
  const places = weld(positions, 3);
  assert.equal(new Set(places).size, 42);
  const colors = chartColors(indices, charts, places);
  for (let f = 0; f < 40; f += 2) {
    assert.equal(colors[f], colors[f + 1]);
    if (f > 0) assert.notEqual(colors[f], colors[f - 1]);
  }
  assert.deepEqual(chartColors(indices, charts, places), colors);
});

test('session: when abflat cannot start, that is what a mesh fails with', async () => {
  const { Session } = await load('session');
  const failures = [];
  const session = new Session(Promise.reject(new Error('no module')), {
    started: () => undefined,
    failed: (source, settings, error) => failures.push([source.name, settings, error.message]),
  });
  await session.open(HEAD);
  assert.deepEqual(failures, [['head', null, 'no module']]);
});

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

test('background work gives way to a run, starts over, and ends for good when it is stopped', async () => {
  const { Background } = await load('background');
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

test('notes: why a layout is not valid, what was done, which vertices are tightened', async () => {
  const { notes } = await load('notes');
  assert.deepEqual(notes({ problem: '', fallbacks: [], bounds: [], delaunay: null }), []);
  const chart = {
    problem: 'the boundary crosses itself',
    fallbacks: ['the active set stalled; interior point'],
    delaunay: null,
    bounds: [
      { vertex: 3, t: 1.25 },
      { vertex: 9, t: 1.125 },
    ],
  };
  assert.deepEqual(notes(chart), [
    'The boundary crosses itself.',
    'The active set stalled; interior point.',
    '2 boundary vertices are tightened, down to t\u00a0=\u00a01.125.',
  ]);
});
