// How many charts there are depends on the shape of a mesh, not on the numbers of its vertices and
// faces, nor on how it lies. ABFLAT_NUMBERING_RUNS=20 makes more of each kind.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { PARTS } from '../support/made-parts.mjs';
import { Random, surfaceText } from '../support/random-surfaces.mjs';
import { RIGHT_ANGLED, shuffled } from '../support/right-angles.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { sphere, torus, tube } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const RUNS = Number(process.env.ABFLAT_NUMBERING_RUNS ?? (isInstrumented ? 1 : 3));

/** Every vertex moved at random. */
function shaken(random, surface, most) {
  const move = (x) => x + random.between(-most, most);
  return { ...surface, positions: surface.positions.map((p) => p.map(move)) };
}

const ROUND = {
  balls: (random) => shaken(random, sphere(3 + random.below(8)), random.pick([0, 0.01, 0.05])),
  tori: (random) => shaken(random, torus(10 + random.below(20), 6 + random.below(8)), 0.01),
  tubes: (random) => tube(random.between(1, 9), (v) => 1 + 0.3 * Math.sin(5 * v)),
};

/** The same mesh, with its vertices and faces in another order. */
function renumbered(random, { positions, faces }) {
  const order = shuffled(random, [...positions.keys()]);
  const place = new Map(order.map((old, now) => [old, now]));
  const moved = faces.map((face) => face.map((v) => place.get(v)));
  return { positions: order.map((old) => positions[old]), faces: shuffled(random, moved) };
}

/** The same mesh, turned by any angles. */
function turned(random, { positions, faces }) {
  const turns = [0, 1, 2].map((axis) => ({ axis, angle: random.between(0, 7) }));
  const turn = (p, { axis, angle }) => {
    const out = [...p];
    const [i, k] = [(axis + 1) % 3, (axis + 2) % 3];
    out[i] = p[i] * Math.cos(angle) - p[k] * Math.sin(angle);
    out[k] = p[i] * Math.sin(angle) + p[k] * Math.cos(angle);
    return out;
  };
  return { positions: positions.map((p) => turns.reduce(turn, p)), faces };
}

async function unwrapped(at, mesh) {
  writeFileSync(at('in.obj'), surfaceText(mesh));
  const args = ['unwrap', 'in.obj', '-o', 'out.obj', '--report', 'r.json', '-q'];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.equal(code, 0, stderr);
  const { charts, seams } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  return { charts: charts.length, seam: seams.relativeLength };
}

/** Meshes with clearly more or fewer charts when they are turned, of all that were. */
const others = [];
let turnedMeshes = 0;

for (const [kind, make] of Object.entries({ ...RIGHT_ANGLED, ...PARTS, ...ROUND }))
  test(`${kind} get the same charts, however they are numbered`, async (t) => {
    const at = tempFolder(t);
    for (let seed = 0; seed < RUNS; seed++) {
      const random = new Random(seed);
      const mesh = make(random);
      const own = await unwrapped(at, mesh);
      const other = await unwrapped(at, renumbered(random, mesh));
      assert.equal(other.charts, own.charts, `seed ${seed}, renumbered`);
      assert.ok(Math.abs(other.seam - own.seam) < 1e-9 + 1e-6 * own.seam, `seed ${seed}`);
      const { charts } = await unwrapped(at, turned(random, mesh));
      // A turned mesh differs by rounding, which shows where places have the same surroundings.
      if (Math.abs(charts - own.charts) > Math.max(1, 0.2 * own.charts))
        others.push(`${kind} of seed ${seed}: ${own.charts} charts, turned ${charts}`);
      turnedMeshes++;
    }
  });

const TOO_FEW = isInstrumented && 'sanitizers leave time for few meshes';
test('meshes rarely get many more or fewer charts when they are turned', { skip: TOO_FEW }, () => {
  assert.ok(turnedMeshes > 0);
  assert.ok(others.length <= 0.03 * turnedMeshes, others.join('\n'));
});
