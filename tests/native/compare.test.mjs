// The compare command: the same mesh by several methods.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { judge, sharedMesh, withoutShared } from '../support/shared.mjs';
import { grid, TETRAHEDRON } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const TOO_SLOW = isInstrumented && 'takes half a minute with sanitizers';

const METHODS = [
  'abflatAuto',
  'abflatConvex',
  'abflatFree',
  'abflatBalanced',
  'symmetricDirichlet',
  'mips',
  'tutte',
  'meanValue',
  'harmonic',
  'lscm',
];
const MEASURES = ['angularDistortion', 'lengthDistortion', 'areaDistortion', 'symmetricDirichlet'];

async function compared(file, options) {
  const run = await runAbflat(['compare', file, '--json', '-'], options);
  assert.deepEqual([run.code, run.stderr], [0, '']);
  return JSON.parse(run.stdout);
}

test('the table has aligned columns, a row for each method and marks the best', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(6));
  const run = await runAbflat(['compare', 'in.obj'], { cwd: at() });
  assert.deepEqual([run.code, run.stderr], [0, '']);
  const [title, , head, ...rest] = run.stdout.split('\n');
  assert.equal(title, 'in.obj: 72 triangles, 49 vertices, 24 on the boundary');
  const rows = rest.slice(0, METHODS.length);
  assert.equal(rest[METHODS.length], '');
  const { methods } = await compared('in.obj', { cwd: at() });
  for (const [i, row] of rows.entries()) {
    assert.ok(row.startsWith(methods[i].title));
    for (const column of ['seconds', 'flipped', 'crossings']) {
      const end = head.indexOf(column) + column.length;
      assert.match(row[end - 1], /\d/, `${column} of ${row}`);
      assert.equal(row[end], ' ');
    }
    assert.match(row, / yes$/);
  }
  const starsAt = head.indexOf('angular') + 'angular'.length;
  const least = Math.min(...methods.map((m) => m.angularDistortion));
  const best = methods.findIndex((m) => m.angularDistortion === least);
  assert.equal(rows[best][starsAt], '*');
  assert.ok(rows.some((row) => row[starsAt] === ' '));
});

test('JSON: all measures of all methods, each within its bounds', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(6));
  const run = await runAbflat(['compare', 'in.obj', '--json', 'out.json'], { cwd: at() });
  assert.deepEqual([run.code, run.stdout, run.stderr], [0, '', '']);
  const { input, methods } = JSON.parse(readFileSync(at('out.json'), 'utf8'));
  assert.equal(input.path, 'in.obj');
  assert.equal(input.disk.ok, true);
  assert.deepEqual(
    methods.map((m) => m.method),
    METHODS,
  );
  for (const m of methods) {
    for (const key of MEASURES) assert.ok(m[key] >= 0, `${m.method} ${key}`);
    assert.ok(m.areaRatio.min > 0 && m.areaRatio.min <= 1 && m.areaRatio.max >= 1);
    assert.ok(m.quasiConformal.mean >= 1 && m.quasiConformal.max >= m.quasiConformal.mean);
    assert.ok(m.symmetricDirichlet >= 1);
    assert.deepEqual([m.flippedTriangles, m.boundaryCrossings], [0, 0]);
    assert.deepEqual([m.valid, m.problem], [true, '']);
  }
});

test('standard input, and the same numbers again', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(5));
  const fromFile = await compared('in.obj', { cwd: at() });
  const fromStream = await compared('-', { cwd: at(), input: grid(5) });
  const numbers = ({ methods }) => methods.map((m) => ({ ...m, seconds: 0 }));
  assert.deepEqual(numbers(fromStream), numbers(fromFile));
});

test('a method without a valid layout is a row that says why', { skip: TOO_SLOW }, async (t) => {
  const at = tempFolder(t);
  await runAbflat(['sample', 'alpha-band', '-o', 'in.obj'], { cwd: at() });
  const { methods } = await compared('in.obj', { cwd: at() });
  const of = (key) => methods.find((m) => m.method === key);
  for (const key of ['abflatFree', 'lscm']) {
    assert.equal(of(key).valid, false);
    assert.ok(of(key).boundaryCrossings > 0);
    assert.match(of(key).problem, /^the boundary crosses itself at \d+ places/);
  }
  assert.equal(of('abflatAuto').valid, true);
  const table = await runAbflat(['compare', 'in.obj'], { cwd: at() });
  assert.equal(table.code, 0);
  assert.match(table.stdout, /^LSCM.* no$/m);
  assert.match(table.stdout, /^LSCM, free: the boundary crosses itself/m);
});

test('wrong meshes and targets have their exit codes, and leave no file', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(3));
  writeFileSync(at('bad.obj'), 'v 0 0\nf 1 2 3\n');
  writeFileSync(at('closed.off'), TETRAHEDRON);
  const run = (...args) => runAbflat(['compare', ...args], { cwd: at() });
  const code = async (...args) => (await run(...args)).code;
  assert.equal(await code(), 2);
  assert.equal(await code('in.obj', '--csv', 'x'), 2);
  assert.equal(await code('in.obj', '--json', ''), 2);
  const own = await run('in.obj', '--json', './in.obj');
  assert.deepEqual([own.code, own.stdout], [2, '']);
  assert.match(own.stderr, /--json: would replace the input/);
  assert.equal(readFileSync(at('in.obj'), 'utf8'), grid(3));
  assert.equal(await code('missing.obj', '--json', 'out.json'), 3);
  assert.equal(await code('bad.obj', '--json', 'out.json'), 3);
  const closed = await run('closed.off', '--json', 'out.json');
  assert.equal(closed.code, 4);
  assert.match(closed.stderr, /^abflat: closed\.off: closed surface/);
  assert.equal(existsSync(at('out.json')), false);
  assert.equal(await code('in.obj', '--json', 'no/such/folder.json'), 5);
});

/** Relative, because the judge sums in another order. */
const close = (a, b) => Math.abs(a - b) <= 1e-6 * Math.max(Math.abs(a), Math.abs(b), 1e-6);

for (const file of ['nefertiti.off', 'hemisphere.obj', 'cow-cut.off'])
  test(`${file}: the judge measures the same`, { skip: withoutShared || TOO_SLOW }, async (t) => {
    const at = tempFolder(t);
    const { methods } = await compared(sharedMesh(file));
    for (const [i, bound] of ['auto', '1', '2'].entries()) {
      const args = ['flatten', sharedMesh(file), '-o', at('out.obj'), '--t', bound, '--quiet'];
      assert.ok((await runAbflat(args)).code <= 1);
      const found = judge(sharedMesh(file), at('out.obj'), 2);
      for (const key of ['angularDistortion', 'lengthDistortion', 'symmetricDirichlet'])
        assert.ok(close(found[key], methods[i][key]), `${bound} ${key}`);
      assert.ok(close(found.quasiConformal.mean, methods[i].quasiConformal.mean));
      assert.equal(found.flipped, methods[i].flippedTriangles);
      assert.equal(found.boundaryCrossings, methods[i].boundaryCrossings);
    }
  });

for (const file of ['nefertiti.off', 'hemisphere.obj', 'cow-cut.off', 'face.obj', 'camel-cut.obj'])
  test(`${file}: abflat keeps angles best`, { skip: withoutShared || TOO_SLOW }, async () => {
    const { methods } = await compared(sharedMesh(file));
    const [auto, , free] = methods;
    assert.equal(auto.valid, true);
    for (const m of methods)
      if (m.valid) assert.ok(auto.angularDistortion <= m.angularDistortion * (1 + 1e-9), m.method);
    for (const m of methods) assert.ok(free.angularDistortion <= m.angularDistortion * (1 + 1e-9));
    for (const key of ['tutte', 'meanValue'])
      assert.equal(methods.find((m) => m.method === key).valid, true);
  });
