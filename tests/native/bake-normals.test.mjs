// Normal maps in a new layout.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { atRandomPoints, run, turnedPlane } from '../support/baking.mjs';
import { madePng } from '../support/made-png.mjs';
import { samplerOf, texturedGlb } from '../support/textured.mjs';

test('the bumps of a normal map turn with it', async (t) => {
  const degrees = 37;
  const tilted = madePng(64, 64, () => [178, 128, 245]); // to the right of the old image
  const materials = [{ normalTexture: { index: 0, scale: 0.5 } }];
  const plane = turnedPlane(degrees, { tangents: Array(4).fill([1, 0, 0, 1]) });
  const before = texturedGlb([plane], { materials, textures: [{ source: 0 }], images: [tilted] });
  const { bytes, report } = await run(t, before, 'bake');
  assert.match(report.notes.join(), /the tangents of 1 primitive were those of the old layout/);
  const { sample, json } = samplerOf(bytes);
  assert.deepEqual(json.materials, [{ normalTexture: { index: 0, texCoord: 1 } }]);
  assert.equal('TANGENT' in json.meshes[0].primitives[0].attributes, false);
  const n = [(0.5 * (2 * 178)) / 255 - 0.5, 0.5 * ((2 * 128) / 255 - 1), (2 * 245) / 255 - 1];
  const length = Math.hypot(...n);
  const angle = (degrees * Math.PI) / 180;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  // v of the image grows downwards, green points up.
  const turned = [c * n[0] + s * n[1], -s * n[0] + c * n[1], n[2]].map((x) => x / length);
  atRandomPoints(2, (triangle, weights) => {
    const now = sample('normalTexture', triangle, weights).map((x) => 2 * x - 1);
    now.forEach((x, d) => {
      assert.ok(Math.abs(x - turned[d]) < 0.012, `${now} is not ${turned}`);
    });
  });
});
