// A texture in many small islands, baked into a layout of few charts: every colour is where it was.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { randomNumbers } from './disks.mjs';
import { elementsOf, trianglesOf } from './glb.mjs';
import { colourAt, manyIslands } from './many-islands.mjs';
import { runAbflat } from './run-abflat.mjs';
import { tempFolder } from './temp-folder.mjs';
import { samplerOf } from './textured.mjs';

const COLOUR = 'pbrMetallicRoughness.baseColorTexture';

/** Differences to the colour that a point must have, at random points of random triangles. */
function differences(bytes, count) {
  const { sample, gltf, json, count: triangles } = samplerOf(bytes);
  const [primitive] = json.meshes[0].primitives;
  const positions = elementsOf(gltf, primitive.attributes.POSITION);
  const corners = trianglesOf(gltf, primitive);
  const random = randomNumbers(11);
  return Array.from({ length: count }, () => {
    const t = Math.floor(random() * triangles);
    const parts = [random(), random(), random()];
    const sum = parts[0] + parts[1] + parts[2];
    const weights = parts.map((part) => part / sum);
    const at = [0, 1, 2].map((d) =>
      corners[t].reduce((total, v, k) => total + weights[k] * positions[v][d], 0),
    );
    const expected = colourAt(at);
    const is = sample(COLOUR, t, weights);
    return Math.max(...expected.map((value, d) => Math.abs(value - is[d])));
  });
}

/** Bakes such a ball from so many islands at least to so many charts at most. */
export function testRebaking({ ball, leastIslands, mostCharts, resolution }) {
  test(`a texture in ${leastIslands} islands is baked into fewer than ${mostCharts} charts`, async (t) => {
    const at = tempFolder(t);
    const { bytes, islands } = manyIslands(ball);
    assert.ok(islands >= leastIslands);
    writeFileSync(at('in.glb'), bytes);
    const args = ['unwrap', 'in.glb', '-o', 'out.glb', '--bake', '--report', 'r.json'];
    const { code, stderr } = await runAbflat(
      [...args, '--resolution', `${resolution}`, '--bake-resolution', `${resolution}`],
      { cwd: at() },
    );
    assert.deepEqual([code, stderr], [0, '']);
    const { charts, baking, timings, peakMemory } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    t.diagnostic(
      `${charts.length} charts, ${timings.total.toFixed(1)} s of which baking ${baking.seconds.toFixed(1)} s, ${JSON.stringify(peakMemory)}`,
    );
    assert.ok(charts.length < mostCharts);
    const off = differences(readFileSync(at('out.glb')), 20_000).sort((a, b) => a - b);
    const mean = off.reduce((sum, x) => sum + x, 0) / off.length;
    t.diagnostic(`off by ${mean.toFixed(5)} on average, ${off.at(-1).toFixed(4)} at most`);
    assert.ok(mean < 1.5 / 255, `${mean}`);
    assert.ok(off.at(-1) < 6 / 255, `${off.at(-1)}`);
  });
}
