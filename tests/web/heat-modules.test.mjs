// What the heat maps show: distortion of each triangle, its place on the colour ramp, and how it is spread.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { objText, torus } from '../support/surfaces.mjs';
import { loadModule as load } from './modules.mjs';

const RIGHT = {
  positions: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0),
  indices: Uint32Array.of(0, 1, 2),
};

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

/** Of the vertices of a layout, xyz each. */
const positionsOf = ({ positions, vertexMap }, mesh) =>
  positions ??
  Float64Array.from(
    { length: 3 * vertexMap.length },
    (_, i) => mesh.positions[3 * vertexMap[Math.floor(i / 3)] + (i % 3)],
  );

const close = (a, b, tolerance = 1e-5) => assert.ok(Math.abs(a - b) <= tolerance, `${a}, not ${b}`);

test('a similar layout has no distortion, and others have what their definitions say', async () => {
  const { distortionsOf } = await load('mesh/distortion');
  const same = distortionsOf({ ...RIGHT, uv: Float64Array.of(3, 3, 3, 5, 1, 3) });
  close(same.angle[0], 0, 1e-6);
  close(same.area[0], 1);
  close(same.stretch[0], 1);
  // 90, 45, 45 degrees become 60 each: -1/3, 1/3, 1/3.
  const equilateral = Float64Array.of(0, 0, 1, 0, 0.5, Math.sqrt(3) / 2);
  close(distortionsOf({ ...RIGHT, uv: equilateral }).angle[0], 1 / 3);
  // Twice as wide: at equal area the singular values are the root of 2 and its inverse.
  const wide = distortionsOf({ ...RIGHT, uv: Float64Array.of(0, 0, 2, 0, 0, 1) });
  close(wide.stretch[0], (2 + 1 / 2 + 1 / 2 + 2) / 4);
});

test('areas compare with the whole layout, stretch with the own chart', async () => {
  const { distortionsOf } = await load('mesh/distortion');
  const mesh = {
    positions: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0),
    indices: Uint32Array.of(0, 1, 2, 3, 4, 5),
    uv: Float64Array.of(0, 0, 1, 0, 0, 1, 5, 0, 7, 0, 5, 2),
  };
  const apart = distortionsOf(mesh, Uint32Array.of(0, 1));
  assert.deepEqual([...apart.stretch].map(Math.fround), [1, 1]);
  close(apart.area[0], 2 / 5);
  close(apart.area[1], 8 / 5);
  assert.ok(distortionsOf(mesh).stretch[0] > 1.1, 'as one chart they differ');
});

test('triangles without area, in 3D or in uv, are no trouble', async () => {
  const { distortionsOf } = await load('mesh/distortion');
  const { heatOf } = await load('drawing/heat');
  const flat = Float64Array.of(0, 0, 0, 1, 0, 0, 2, 0, 0);
  const uv = Float64Array.of(0, 0, 1, 0, 0, 1);
  const none = distortionsOf({ indices: RIGHT.indices, positions: flat, uv });
  assert.deepEqual([none.angle[0], none.area[0], none.stretch[0]], [0, 1, 1]);
  const lost = heatOf({ ...RIGHT, uv: Float64Array.of(0, 0, 1, 0, 2, 0) });
  assert.ok(lost.places.every(Number.isFinite));
  const empty = heatOf({
    positions: new Float64Array(),
    indices: new Uint32Array(),
    uv: new Float64Array(),
  });
  assert.equal(empty.places.length, 0);
});

test('means over the triangles are the numbers of the report', async () => {
  const { distortionsOf } = await load('mesh/distortion');
  const { triangleAreas } = await load('mesh/mesh');
  const file = { bytes: new TextEncoder().encode(objText(torus(24, 12))), name: 'torus.obj' };
  for (const [kind, mesh] of [
    ['flatten', await abflat.sample('head', { detail: 1 })],
    ['unwrap', await abflat.load(file)],
  ]) {
    const result = await abflat[kind](mesh);
    const { report, uv, indices, chartOfTriangle } = result;
    const own = positionsOf(result, mesh);
    const found = distortionsOf({ positions: own, indices, uv }, chartOfTriangle);
    const areas = triangleAreas(own, 3, indices);
    const mean = (values) => {
      const total = areas.reduce((sum, area) => sum + area, 0);
      return values.reduce((sum, value, f) => sum + value * areas[f], 0) / total;
    };
    const [chart] = report.charts;
    const stretch = kind === 'flatten' ? chart.symmetricDirichlet : report.symmetricDirichlet;
    close(mean(found.stretch), stretch, 1e-4);
    if (kind === 'flatten') {
      const squares = found.angle.reduce((sum, error) => sum + error * error, 0);
      close(squares / found.angle.length, chart.angularDistortion, 1e-6);
      const most = Math.max(...found.area);
      close(most, chart.areaDistortion.max, 1e-3);
    }
  }
});

test('places on the ramp go to and fro, and beyond its ends', async () => {
  const { MEASURES, SCALES } = await load('model/measures');
  for (const measure of MEASURES) {
    const { place, value } = SCALES[measure];
    for (const at of [-0.5, 0, 0.3, 1, 1.7]) close(place(value(at)), at, 1e-12);
  }
  close(SCALES.area.place(1), 0.5);
  close(SCALES.angle.place(0), 0);
  close(SCALES.stretch.place(1), 0);
});

test('texels per unit are those of the resolution, and relative where there is none', async () => {
  const { heatOf } = await load('drawing/heat');
  const { MEASURES, SCALES } = await load('model/measures');
  // Two units along each edge become one of uv, and the half of that.
  const mesh = {
    positions: Float64Array.of(0, 0, 0, 2, 0, 0, 0, 2, 0, 5, 0, 0, 7, 0, 0, 5, 2, 0),
    indices: Uint32Array.of(0, 1, 2, 3, 4, 5),
    uv: Float64Array.of(0, 0, 1, 0, 0, 1, 5, 0, 5.5, 0, 5, 0.5),
  };
  const { places, spreads } = heatOf(mesh, Uint32Array.of(0, 1), undefined, 1000);
  const { mean } = spreads.texels;
  const { text, value } = SCALES.texels;
  const at = (f) => text(value(places[MEASURES.length * f + MEASURES.indexOf('texels')]), mean);
  assert.deepEqual([at(0), at(1)], ['500', '250']);
  assert.equal(heatOf(mesh).spreads.texels.mean, 0);
  assert.equal(text(2, 0), '\u00d72.00');
});

test('shares of the bars add up to the surface, and the worst hundredth is one', async () => {
  const { heatOf } = await load('drawing/heat');
  const { MEASURES, distanceFromBest } = await load('model/measures');
  const { triangleAreas } = await load('mesh/mesh');
  const mesh = await abflat.sample('head', { detail: 2 });
  const result = await abflat.flatten(mesh);
  const { uv, indices } = result;
  const positions = positionsOf(result, mesh);
  const { places, spreads } = heatOf({ positions, indices, uv });
  const areas = triangleAreas(positions, 3, indices);
  const total = areas.reduce((sum, area) => sum + area, 0);
  MEASURES.forEach((measure, k) => {
    const { shares, worst } = spreads[measure];
    close(
      shares.reduce((sum, share) => sum + share, 0),
      1,
      1e-9,
    );
    const share =
      areas.reduce(
        (sum, area, f) =>
          sum + (distanceFromBest(measure, places[MEASURES.length * f + k]) >= worst ? area : 0),
        0,
      ) / total;
    assert.ok(share >= 0.01 && share < 0.02, `${measure}: ${share}`);
  });
});
