// Vertices that fall apart into several, a hair apart, with slivers between: exporters of deformed
// meshes write them. Nobody can see the slivers, so the layout is that of the mesh without them.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { judge, readAtlas } from '../support/exact-atlas.mjs';
import { Random } from '../support/random-surfaces.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { isosurface, objText, sheet } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const RUNS = isInstrumented ? 2 : 8;

const distance = (p, q) => Math.hypot(...p.map((x, d) => x - q[d]));

/** The faces around a vertex, counter-clockwise, if they go all around it. */
function facesAround(faces, v) {
  const next = new Map();
  const first = new Map();
  for (const face of faces) {
    const k = face.indexOf(v);
    if (k < 0) continue;
    next.set(face[(k + 1) % 3], face);
    first.set(face, face[(k + 2) % 3]);
  }
  const out = [...next.values()].slice(0, 1);
  while (out.length < next.size) {
    const face = next.get(first.get(out.at(-1)));
    if (!face || out.includes(face)) return [];
    out.push(face);
  }
  return next.has(first.get(out.at(-1))) ? out : [];
}

/** Gives some vertices a copy for each face but one, moved by up to `by` of the shortest edge. */
function fallApart(random, { positions, faces }, by) {
  const out = { positions: positions.map((p) => [...p]), faces: faces.map((f) => [...f]) };
  const count = faces.length;
  for (let left = 4; left > 0; left--) {
    const v = random.below(positions.length);
    const around = facesAround(out.faces.slice(0, count), v);
    if (around.length < 3) continue;
    const lengths = around.flat().map((w) => distance(out.positions[v], out.positions[w]));
    const most = by * Math.min(...lengths.filter((x) => x > 1e-3));
    const copies = around.map((_, i) =>
      i === 0
        ? v
        : out.positions.push(positions[v].map((x) => x + most * random.between(-0.5, 0.5))) - 1,
    );
    for (const [i, face] of around.entries()) {
      const k = face.indexOf(v);
      const shared = face[(k + 2) % 3];
      face[k] = copies[i];
      out.faces.push([copies[i], shared, copies[(i + 1) % copies.length]]);
    }
  }
  return out;
}

const meshes = {
  sheet: (seed) => {
    const random = new Random(seed);
    return sheet(8, 6, (u, v) => [8 * u, 6 * v, random.between(-0.5, 0.5)]);
  },
  closed: (seed) => isosurface(6, seed),
};

for (const [name, make] of Object.entries(meshes))
  for (let seed = 0; seed < RUNS; seed++)
    test(`${name} ${seed} with tiny edges`, async (t) => {
      const at = tempFolder(t);
      const random = new Random(seed);
      const whole = make(seed);
      const apart = fallApart(random, whole, 10 ** random.between(-12, -7));
      writeFileSync(at('whole.obj'), objText(whole));
      writeFileSync(at('apart.obj'), objText(apart));
      const charts = async (input, output) => {
        const args = ['unwrap', input, '-o', output, '--report', 'r.json'];
        const { code, stderr } = await runAbflat(args, { cwd: at() });
        assert.equal(code, 0, stderr);
        const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
        assert.ok(report.valid);
        return report.charts.length;
      };
      const wanted = await charts('whole.obj', 'whole-out.obj');
      for (const output of ['out.obj', 'out.glb']) {
        assert.equal(await charts('apart.obj', output), wanted, output);
        const { faces, lowestRow } = readAtlas(at(output));
        assert.ok(faces.flat().every(({ uv }) => uv?.every(Number.isFinite)));
        const uv = faces.slice(0, whole.faces.length).map((face) => face.map((c) => c.uv));
        const { isValid, ...judged } = judge(uv, { lowestRow });
        assert.ok(isValid, `${output}: ${JSON.stringify(judged)}`);
      }
    });
