// The texel density of charts relative to each other.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { objText, sphere, together, torus } from '../support/surfaces.mjs';
import { bytesOf } from './support/meshes.mjs';
import { arraysOf, assertFails, CUBE } from './support/unwrapping.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat?.terminate());

const SPHERE_AND_TORUS = together([
  [sphere(4), [0, 0, 0]],
  [torus(16, 8), [5, 0, 0]],
]);

const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** Per chart, the root of its area in the atlas over that on the mesh, in texels per unit. */
function densitiesOf({ uv, indices, vertexMap, chartOfTriangle, report }) {
  const positions = [...vertexMap].flatMap((v) => SPHERE_AND_TORUS.positions[v]);
  const flat = report.charts.map(() => 0);
  const solid = report.charts.map(() => 0);
  const area = (values, size, f) => {
    const [o, a, b] = [0, 1, 2].map((k) =>
      [0, 1, 2].map((d) => (d < size ? values[size * indices[3 * f + k] + d] : 0)),
    );
    const minus = (p) => p.map((x, d) => x - o[d]);
    return Math.hypot(...cross(minus(a), minus(b)));
  };
  for (const [f, chart] of chartOfTriangle.entries()) {
    flat[chart] += area(uv, 2, f);
    solid[chart] += area(positions, 3, f);
  }
  return flat.map((sum, i) => report.atlas.resolution * Math.sqrt(sum / solid[i]));
}

test('faceDensities: charts are larger and smaller as their faces ask, of arrays and of files', async () => {
  const file = { bytes: bytesOf(objText(SPHERE_AND_TORUS)), name: 'two.obj' };
  // In the file, the faces of the sphere have four corners.
  for (const [input, faces, ofSphere] of [
    [arraysOf(SPHERE_AND_TORUS), 448, 192],
    [file, 352, 96],
  ]) {
    const faceDensities = Float32Array.from({ length: faces }, (_, f) => (f < ofSphere ? 2 : 0.5));
    const result = await abflat.unwrap(input, { faceDensities });
    assert.equal(result.report.valid, true);
    const { texelDensity } = result.report.atlas;
    for (const [i, density] of densitiesOf(result).entries()) {
      const f = result.chartOfTriangle.indexOf(i);
      const wanted = (f < 192 ? 2 : 0.5) * texelDensity;
      assert.ok(Math.abs(density / wanted - 1) < 1e-3, `chart ${i}: ${density}, not ${wanted}`);
    }
    assert.equal(faceDensities.length, faces, 'what was passed stays');
  }
});

test('faceDensities: what is wrong is said', async () => {
  const mesh = arraysOf(CUBE);
  const faces = mesh.indices.length / 3;
  const one = new Float64Array(faces).fill(1);
  for (const [faceDensities, pattern] of [
    [[1, 1], /must be a Float32Array or Float64Array, not Array/],
    [2, /must be a Float32Array or Float64Array, not Number/],
    [one.slice(1), new RegExp(`there are ${faces - 1} face densities for ${faces} faces`)],
    [one.with(2, 0), /the density of face 2 must be from 0.001 to 1000/],
    [one.with(2, Number.NaN), /the density of face 2 must be/],
  ])
    await assertFails(abflat, abflat.unwrap(mesh, { faceDensities }), 'InvalidOption', pattern);
  const { report } = await abflat.unwrap(mesh, { faceDensities: one });
  assert.equal(report.valid, true);
});
