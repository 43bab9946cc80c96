// --pins: vertices at fixed uv.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { chartsOf, complaints, parseObj } from '../support/atlas.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { grid } from '../support/small-meshes.mjs';
import * as surfaces from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

/** The uv of every corner of an OBJ, grouped by vertex: a set of "u v". */
function uvOfVertices(text) {
  const { texcoords, faces } = parseObj(text);
  const out = new Map();
  for (const face of faces)
    for (const [vertex, texcoord] of face) {
      if (!out.has(vertex)) out.set(vertex, new Set());
      out.get(vertex).add(texcoords[texcoord].join(' '));
    }
  return out;
}

async function run(at, command, input, pins, ...options) {
  writeFileSync(at('pins'), pins);
  const args = [command, input, '-o', 'out.obj', '--pins', 'pins', '--report', 'r.json'];
  const ended = await runAbflat([...args, ...options], { cwd: at() });
  if (ended.code > 1) return ended;
  const text = readFileSync(at('out.obj'), 'utf8');
  return { ...ended, text, report: JSON.parse(readFileSync(at('r.json'), 'utf8')) };
}

test('pinned vertices are exactly where they are pinned', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(6));
  const pins = '# corners\n0 0.1 0.2\n\n6 0.7 0.3 # right\n48 0.8 0.9\n42 0.05 0.85 61\n';
  const { code, stderr, text, report } = await run(at, 'flatten', 'in.obj', pins);
  assert.equal(code, 0, stderr);
  const uv = uvOfVertices(text);
  for (const [vertex, place] of [
    [0, '0.1 0.2'],
    [6, '0.7 0.3'],
    [48, '0.8 0.9'],
    [42, '0.05 0.85'],
  ])
    assert.deepEqual([...uv.get(vertex)], [place]);
  assert.equal(report.charts[0].pins.count, 4);
  assert.ok(report.charts[0].pins.deviation > 0.01);
});

test('pins may come from standard input', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(2));
  const args = ['flatten', 'in.obj', '-o', 'out.obj', '--pins', '-'];
  const ended = await runAbflat(args, { cwd: at(), input: '0 -1 -1\n8 3 4\n' });
  assert.equal(ended.code, 0, ended.stderr);
  const uv = uvOfVertices(readFileSync(at('out.obj'), 'utf8'));
  assert.deepEqual([...uv.get(0), ...uv.get(8)], ['-1 -1', '3 4']);
});

test('pins that fold the layout: written, exit code 1, and a sentence', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(4));
  const { code, stderr, text, report } = await run(
    at,
    'flatten',
    'in.obj',
    '0 0 0\n4 0 1\n20 1 0\n24 1 1\n',
  );
  assert.equal(code, 1);
  assert.match(stderr, /written, but is not valid: the pins fold the layout: .*\. Move the pins/);
  assert.equal(report.valid, false);
  assert.deepEqual([...uvOfVertices(text).get(20)], ['1 0']);
});

for (const [pins, sentence, expected] of [
  ['0 0\n', /pins:1: expected a vertex number, u, v/, 3],
  ['0 0 0\n1.5 2\n', /pins:2: expected/, 3],
  ['0 0 0\n1 2 3 4 5\n', /pins:2: expected/, 3],
  ['-1 0 0\n', /pins:1: expected/, 3],
  ['0 0 nan\n', /pins:1: expected/, 3],
  ['0 0 1e999\n', /pins:1: expected/, 3],
  ['0 0 0\n', /in\.obj: vertex 0 is the only pinned vertex/, 2],
  ['0 0 0\n99 1 1\n', /in\.obj: vertex 99 is pinned, but the mesh has 9 vertices/, 2],
  ['0 0 0\n0 1 1\n', /in\.obj: vertex 0 is pinned twice/, 2],
  ['0 0 0\n4 1 1\n8 0 0\n', /in\.obj: vertices 0 and 8 are pinned to the same uv/, 2],
])
  test(`pins ${JSON.stringify(pins)}: exit code ${expected}`, async (t) => {
    const at = tempFolder(t);
    writeFileSync(at('in.obj'), grid(2));
    const { code, stderr } = await run(at, 'flatten', 'in.obj', pins);
    assert.equal(code, expected);
    assert.match(stderr, sentence);
    assert.match(stderr, /^abflat: [^\n]+\n$/);
  });

test('a chart of an atlas stays where its pins are', async (t) => {
  const at = tempFolder(t);
  const surface = surfaces.sphere();
  writeFileSync(at('in.obj'), surfaces.objText(surface));
  // Two distant corners of one chart, identified by the faces they belong to.
  const free = await runAbflat(['unwrap', 'in.obj', '-o', 'free.obj'], { cwd: at() });
  assert.equal(free.code, 0, free.stderr);
  const { faces, texcoords } = parseObj(readFileSync(at('free.obj'), 'utf8'));
  const { ofFace } = chartsOf({ faces });
  const [vertex, texcoord] = faces[0][0];
  const distance = (i) =>
    Math.hypot(texcoords[i][0] - texcoords[texcoord][0], texcoords[i][1] - texcoords[texcoord][1]);
  let far = [0, vertex, texcoord];
  for (const [f, face] of faces.entries())
    for (const corner of face)
      if (ofFace[f] === ofFace[0] && distance(corner[1]) > distance(far[2])) far = [f, ...corner];
  const pins = `${vertex} 0.4 0.45 0\n${far[1]} 0.55 0.5 ${far[0]}\n`;
  const { code, stderr, text, report } = await run(at, 'unwrap', 'in.obj', pins);
  assert.equal(code, 0, stderr);
  assert.deepEqual(complaints(text), []);
  const placed = uvOfVertices(text);
  assert.ok(placed.get(vertex).has('0.4 0.45'));
  assert.ok(placed.get(far[1]).has('0.55 0.5'));
  assert.equal(report.charts.filter((chart) => chart.pins?.count === 2).length, 1);
  const outside = await run(at, 'unwrap', 'in.obj', pins.replace('0.55 0.5', '0.55 1.5'));
  assert.equal(outside.code, 2);
  assert.match(outside.stderr, /outside the unit square/);
});

test('straight sides are lines, and the report counts them', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(6));
  writeFileSync(at('straight'), '0 6\n48 42 # the side above\n');
  const args = ['flatten', 'in.obj', '-o', 'out.obj', '--straight', 'straight'];
  const ended = await runAbflat([...args, '--report', 'r.json'], { cwd: at() });
  assert.equal(ended.code, 0, ended.stderr);
  const { straight, constraintResidual } = JSON.parse(readFileSync(at('r.json'), 'utf8')).charts[0];
  assert.deepEqual([straight.runs, straight.vertices, straight.released], [2, 10, 0]);
  assert.ok(straight.deviation < 1e-8 && constraintResidual < 1e-9);
  const uv = uvOfVertices(readFileSync(at('out.obj'), 'utf8'));
  for (const side of [
    [0, 1, 2, 3, 4, 5, 6],
    [42, 43, 44, 45, 46, 47, 48],
  ]) {
    const points = side.map((v) => [...uv.get(v)][0].split(' ').map(Number));
    const [first, last] = [points[0], points[6]];
    const [x, y] = [last[0] - first[0], last[1] - first[1]];
    for (const [u, v] of points)
      assert.ok(Math.abs(x * (v - first[1]) - y * (u - first[0])) < 1e-8 * (x * x + y * y));
  }
});

for (const [runs, sentence, expected] of [
  ['0\n', /straight:1: expected two boundary vertices/, 3],
  ['0 4\n', /in\.obj: vertex 4 ends a straight run, but is not on the boundary/, 2],
  ['0 0\n', /in\.obj: a straight run begins and ends at vertex 0/, 2],
  ['0 3\n', /in\.obj: the straight runs leave fewer than three boundary vertices/, 4],
])
  test(`straight runs ${JSON.stringify(runs)}: exit code ${expected}`, async (t) => {
    const at = tempFolder(t);
    writeFileSync(at('in.obj'), grid(2));
    writeFileSync(at('straight'), runs);
    const args = ['flatten', 'in.obj', '-o', 'out.obj', '--straight', 'straight'];
    const { code, stderr } = await runAbflat(args, { cwd: at() });
    assert.equal(code, expected);
    assert.match(stderr, sentence);
  });
