// --seams hard: cuts every edge where the shading of the file breaks, and no other.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import {
  drum,
  glbBytes,
  objWithGroups,
  objWithNormals,
  plyText,
  split,
} from '../support/drums.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { binaryStl } from '../support/stl.mjs';
import { objText } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const DRUM = drum();
const keyOf = (a, b) => `${Math.min(a, b)} ${Math.max(a, b)}`;
const RIMS = new Set(DRUM.edges.map(([a, b]) => keyOf(a, b)));

/** The cut edges by their places, and the report. `source` has the place of each vertex. */
async function cut(at, input, seams, { source, args = [] } = {}) {
  const run = ['unwrap', input, '-o', 'out.obj', '--report', 'r.json', '--write-seams', 'cut.txt'];
  const { code, stderr } = await runAbflat([...run, '--seams', seams, ...args], { cwd: at() });
  if (code !== 0) return { code, stderr };
  const rows = readFileSync(at('cut.txt'), 'utf8').trim().split('\n');
  const pairs = rows
    .filter((row) => row && !row.startsWith('#'))
    .map((row) => row.split(' ').map((v) => source?.[v] ?? Number(v)));
  return {
    code,
    stderr,
    edges: new Set(pairs.map(([a, b]) => keyOf(a, b))),
    report: JSON.parse(readFileSync(at('r.json'), 'utf8')),
  };
}

/** All rims are cut, and besides them one path along the side, which opens the tube. */
function assertRims({ code, stderr, edges, report }, name) {
  assert.equal(code, 0, stderr);
  assert.equal(report.valid, true, name);
  for (const rim of RIMS) assert.ok(edges.has(rim), `${name}: ${rim} is cut`);
  assert.equal(edges.size, RIMS.size + 3, `${name}: three edges open the side`);
  assert.equal(report.charts.length, 3, name);
}

test('hard cuts the rims of a drum, whatever the format', async (t) => {
  const at = tempFolder(t);
  const { source } = split(DRUM);
  for (const [name, content, options] of [
    ['normals.obj', objWithNormals(DRUM)],
    ['off.obj', objWithGroups(DRUM)],
    ['groups.obj', objWithGroups(DRUM, ['1', '2', '3'])],
    ['split.ply', plyText(DRUM), { source }],
    ['split.glb', glbBytes(DRUM), { source }],
    ['moved.glb', glbBytes(DRUM, { scale: [1, 3, 0.5], rotation: [0, 0.6, 0, 0.8] }), { source }],
    ['mirrored.glb', glbBytes(DRUM, { scale: [1, -2, 1] }), { source }],
  ]) {
    writeFileSync(at(name), content);
    assertRims(await cut(at, name, 'hard', options), name);
  }
});

test('normals count before smoothing groups, and both are inspected', async (t) => {
  const at = tempFolder(t);
  const inspect = async (text) => {
    writeFileSync(at('in.obj'), text);
    const { stdout } = await runAbflat(['inspect', 'in.obj', '--json'], { cwd: at() });
    const { normals, smoothingGroups } = JSON.parse(stdout);
    return [normals, smoothingGroups];
  };
  const normals = objWithNormals(DRUM);
  const count = normals.match(/^vn /gm).length;
  assert.deepEqual(await inspect(normals), [count, 0]);
  assert.deepEqual(await inspect(normals.replace(/^f /m, 's 1\nf ')), [count, 0]);
  assertRims(await cut(at, 'in.obj', 'hard'), 'one group, but hard normals');
  assert.deepEqual(await inspect(objWithGroups(DRUM)), [0, 2]);
  assert.deepEqual(await inspect(objText(DRUM)), [0, 0]);
});

test('normals that differ by rounding, or not at all, are no hard edge', async (t) => {
  const at = tempFolder(t);
  const turned = (degrees) => {
    const a = (degrees * Math.PI) / 180;
    return `v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 7\nvn 0 ${Math.sin(a)} ${Math.cos(a)}\n`;
  };
  for (const [degrees, corners, isCut] of [
    [0, [2, 2, 2], false],
    [0.9, [2, 2, 2], false],
    [1.1, [2, 2, 2], true],
    // Different at one end only, and beside the edge.
    [30, [2, 1, 1], true],
    [30, [1, 2, 1], true],
    [30, [1, 1, 2], false],
  ]) {
    const [a, c, d] = corners;
    writeFileSync(at('in.obj'), `${turned(degrees)}f 1//1 2//1 3//1\nf 1//${a} 3//${c} 4//${d}\n`);
    const { edges } = await cut(at, 'in.obj', 'hard');
    assert.deepEqual([...edges], isCut ? ['0 2'] : [], `${degrees} ${corners}`);
  }
});

test('faces without normals or groups are flat', async (t) => {
  const at = tempFolder(t);
  // A roof of two flat quads, each of two triangles; one triangle has normals.
  const roof = 'v 0 0 0\nv 1 0 1\nv 2 0 0\nv 0 2 0\nv 1 2 1\nv 2 2 0\nvn -1 0 1\n';
  const cuts = async (text) => {
    writeFileSync(at('in.obj'), roof + text);
    return [...(await cut(at, 'in.obj', 'hard')).edges].sort();
  };
  const faces = ['1 2 5', '1 5 4', '2 3 6', '2 6 5'];
  const plain = faces.map((face) => `f ${face}\n`);
  assert.deepEqual(await cuts(`f 1//1 2//1 5//1\n${plain.slice(1).join('')}`), ['1 4']);
  assert.deepEqual(await cuts(`s off\n${plain.join('')}`), ['1 4']);
  assert.deepEqual(await cuts(`s 4\n${plain.join('')}`), []);
  assert.deepEqual(await cuts(`${plain[0]}s 1\n${plain.slice(1).join('')}`), ['0 4', '1 4']);
});

test('hard combines with sharp and auto', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), objWithGroups(DRUM));
  const smooth = objWithGroups(DRUM, ['1', '1', '1']);
  const both = await cut(at, 'in.obj', 'hard,sharp=10');
  // The side bends by 15 degrees at each of its lines.
  assert.equal(both.edges.size, RIMS.size + 24 * 3);
  assert.equal(both.report.charts.length, 2 + 24);
  const auto = await cut(at, 'in.obj', 'auto,hard');
  for (const rim of RIMS) assert.ok(auto.edges.has(rim));
  assert.ok(auto.report.symmetricDirichlet < 1.02);
  writeFileSync(at('in.obj'), smooth);
  const none = await cut(at, 'in.obj', 'none');
  assert.deepEqual((await cut(at, 'in.obj', 'hard')).edges, none.edges);
});

test('orient turns the normals of corners with their faces', async (t) => {
  const at = tempFolder(t);
  const turned = objWithNormals(DRUM).replace(/^f (\S+) (\S+) (\S+)$/gm, (line, a, b, c) =>
    line.length % 3 === 0 ? `f ${a} ${c} ${b}` : line,
  );
  assert.notEqual(turned, objWithNormals(DRUM));
  writeFileSync(at('in.obj'), turned);
  const found = await cut(at, 'in.obj', 'hard', { args: ['--orient'] });
  assert.ok(found.report.repair.turnedFaces.length > 0);
  assertRims(found, 'turned');
});

test('a file that does not say which edges are hard', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), objText(DRUM));
  const { positions, faces } = DRUM;
  writeFileSync(at('in.stl'), binaryStl(faces.map((face) => face.map((v) => positions[v]))));
  for (const name of ['in.obj', 'in.stl'])
    for (const seams of ['hard', 'auto,hard']) {
      const { code, stderr } = await cut(at, name, seams);
      assert.equal(code, 2);
      assert.match(stderr, /^abflat: in\.(obj|stl): the mesh has neither normals .*Use sharp=30/);
    }
});
