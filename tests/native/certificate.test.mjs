// What is written is what was checked: files of every format, judged exactly and independently of
// the program.

import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { generatedDisk, randomNumbers, toObj } from '../support/disks.mjs';
import { judge, judgeFile, overlap, turn } from '../support/exact-atlas.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import {
  boxArray,
  defects,
  isosurface,
  knot,
  objText,
  plate,
  together,
  torus,
  triangleSoup,
  unwelded,
  withTinyTriangles,
} from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const FORMATS = ['obj', 'ply', 'glb'];

const scaled = (mesh, by) => ({
  ...mesh,
  positions: mesh.positions.map((p) => p.map((x) => x * by)),
});

/** Polygons with a raised middle; every face has its own vertices. */
function tents(seed) {
  const random = randomNumbers(seed);
  const turned = random();
  const place = (x, y, z) => [
    x * Math.cos(turned) - y * Math.sin(turned),
    x * Math.sin(turned) + y * Math.cos(turned),
    z,
  ];
  const [positions, faces] = [[], []];
  const add = (...points) => {
    faces.push(points.map((_, k) => positions.length + k));
    positions.push(...points);
  };
  for (let i = 0; i < 3; i++)
    for (let j = 0; j < 3; j++) {
      const [a, b, c, d] = [
        [i, j],
        [i + 1, j],
        [i + 1, j + 1],
        [i, j + 1],
      ].map(([x, y]) => place(x, y, 0));
      if ((i + j + seed) % 2) add(a, b, c, d);
      else {
        const m = place(i + 0.5, j + 0.5, random());
        add(a, b, c, m);
        add(c, d, a, m);
      }
    }
  return { positions, faces };
}

const MESHES = {
  'a torus': torus(24, 12),
  'a knot': isInstrumented ? knot(36, 6) : knot(60, 8),
  'polygons with a lifted middle': tents(2),
  'polygons, turned otherwise': tents(7),
  'boxes without common vertices': unwelded(boxArray(2)),
  'a plate with holes': plate(6),
  'loose triangles': triangleSoup(200, 3),
  'triangles far below the others': withTinyTriangles(torus(16, 8), 1e-9),
  'an isosurface': isosurface(isInstrumented ? 6 : 8),
  'parts of very different sizes': together([
    [torus(12, 8), [0, 0, 0]],
    [scaled(torus(8, 6), 1e-7), [3, 0, 0]],
    [triangleSoup(20, 5), [0, 9, 0]],
  ]),
  'a mesh near the smallest numbers': scaled(torus(12, 8), 1e-200),
  'a mesh near the largest numbers': scaled(torus(12, 8), 1e200),
};

for (const [name, mesh] of Object.entries(MESHES))
  test(`${name}: every format holds a valid atlas`, async (t) => {
    const at = tempFolder(t);
    writeFileSync(at('in.obj'), objText(mesh));
    const holds = (x) => Number.isFinite(Math.fround(x));
    for (const format of FORMATS) {
      const { code, stderr } = await runAbflat(['unwrap', 'in.obj', '-o', `out.${format}`], {
        cwd: at(),
      });
      if (format === 'glb' && !mesh.positions.flat().every(holds)) {
        assert.equal(code, 5);
        assert.match(stderr, /vertex \d+ has a coordinate above 3.4e38/);
        continue;
      }
      assert.equal(code, 0, format);
      // Parts that are tiny beside the others lose their shape in a glTF, which is said.
      assert.match(
        stderr,
        format === 'glb' ? /^(abflat: in\.obj: single precision, .+\n)?$/ : /^$/,
      );
      const judged = judgeFile(at(`out.${format}`));
      assert.ok(judged.isValid, `${format}: ${JSON.stringify(judged)}`);
      assert.ok(judged.triangles >= mesh.faces.length);
    }
  });

test('defects of every kind: what is said to be valid is', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), objText(defects()));
  for (const format of FORMATS) {
    const { code, stderr } = await runAbflat(['unwrap', 'in.obj', '-o', `out.${format}`], {
      cwd: at(),
    });
    assert.deepEqual([code, stderr], [0, ''], format);
    const { flipped, overlaps, outside } = judgeFile(at(`out.${format}`));
    assert.deepEqual([flipped, overlaps, outside], [[], [], []], format);
  }
});

test('many tiles of random disks: each chart is within one, and alone there', async (t) => {
  const at = tempFolder(t);
  const disks = [1, 2, 3, 4, 5].map((n) => [generatedDisk(n, 300), [4 * n, 0, 0]]);
  writeFileSync(at('in.obj'), toObj(together(disks)));
  for (const format of FORMATS) {
    const args = ['unwrap', 'in.obj', '-o', `out.${format}`, '--udim'];
    const { code, stderr } = await runAbflat(
      [...args, '--texel-density', '60', '--resolution', '128'],
      { cwd: at() },
    );
    if (code === 4) continue; // a chart that fits no tile
    assert.deepEqual([code, stderr], [0, '']);
    const judged = judgeFile(at(`out.${format}`), { tiles: [10, 900] });
    assert.ok(judged.isValid, `${format}: ${JSON.stringify(judged)}`);
  }
});

test('the judge finds what is wrong', () => {
  const s = [
    [0, 0],
    [0.5, 0],
    [0, 0.5],
  ];
  const moved = (x, y) => s.map((p) => [p[0] + x, p[1] + y]);
  assert.ok(judge([s, moved(0.5, 0)]).isValid);
  assert.deepEqual(judge([s, moved(0.2, 0.2), moved(0.5, 0.5)]).overlaps, [[0, 1]]);
  assert.deepEqual(judge([s.toReversed()]).flipped, [0]);
  assert.deepEqual(judge([moved(0.6, 0)]).outside, [0]);
  assert.deepEqual(judge([[s[0], s[1], [0.25, 0]]]).flat, [0]);
  // By the least that doubles can represent.
  const below = 0.5 - 2 ** -54;
  assert.equal(turn([0, 0], [1, 1], [0.5, 0.5]), 0);
  assert.equal(turn([0, 0], [1, 1], [below, 0.5]), 1);
  assert.equal(turn([1e-200, 0], [0, 1e-200], [0, 0]), 1);
  assert.ok(!overlap(s, moved(0.5, 0)) && overlap(s, moved(below, 0)));
});
