// Runs of commands that bake, and comparisons of their textures before and after.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { randomNumbers } from './disks.mjs';
import { errorsIn } from './gltf-errors.mjs';
import { madePng } from './made-png.mjs';
import { isInstrumented, runAbflat } from './run-abflat.mjs';
import { tempFolder } from './temp-folder.mjs';
import { oneTexture, samplerOf } from './textured.mjs';

export const COLOUR = 'pbrMetallicRoughness.baseColorTexture';
export const ROUGH = 'pbrMetallicRoughness.metallicRoughnessTexture';

/** Side of new images that are compared with old ones, and how near they come there. */
export const SIDE = isInstrumented ? 512 : 1024;
export const NEAR = isInstrumented ? 0.05 : 0.02;

/** A smooth picture. */
export const waves = (width, height = width, phase = 0) =>
  madePng(width, height, (x, y) =>
    [0, 1, 2].map((d) =>
      Math.round(
        128 +
          100 * Math.sin((9 * x) / width + 2 * d + phase) * Math.cos((7 * y) / height + d + phase),
      ),
    ),
  );

/** A picture that is alike at opposite edges. */
export const tiling = (size) =>
  madePng(size, size, (x, y) =>
    [0, 1, 2].map((d) =>
      Math.round(
        128 +
          90 *
            Math.sin(0.5 + (2 * Math.PI * (x + 0.5)) / size + d) *
            Math.cos((2 * Math.PI * (y + 0.5)) / size + d),
      ),
    ),
  );

export const oneMaterial = (...more) => oneTexture(waves(384, 256), ...more);

/** Runs a command on the bytes of a GLB. Returns the bytes of the result and the report. */
export async function run(t, bytes, command, ...options) {
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), bytes);
  const args = [command, 'in.glb', '-o', 'out.glb', '--report', 'r.json', ...options];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.deepEqual([code, stderr], [0, '']);
  assert.deepEqual(await errorsIn(at('out.glb'), at), []);
  return {
    bytes: readFileSync(at('out.glb')),
    report: JSON.parse(readFileSync(at('r.json'), 'utf8')),
  };
}

export const unwrapped = (t, bytes, ...options) => run(t, bytes, 'unwrap', '--bake', ...options);

export async function refused(t, bytes, ...args) {
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), bytes);
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  return [code, stderr.split('\n')[0]];
}

/**
 * Calls `compare(triangle, weights)` for random points of the mesh; none is where a texel belongs to
 * two triangles, which may have been apart in the old layout.
 */
export function atRandomPoints(count, compare) {
  const random = randomNumbers(5);
  for (let i = 0; i < 12 * count; i++) {
    const parts = [0, 1, 2].map(() => 0.06 + random());
    const sum = parts[0] + parts[1] + parts[2];
    compare(
      i % count,
      parts.map((part) => part / sum),
    );
  }
}

/** The largest difference of a map before and after, which `factor` multiplies before. */
export function difference(
  before,
  after,
  path,
  { factor = () => [1, 1, 1, 1], isColour = false } = {},
) {
  const [was, is] = [samplerOf(before), samplerOf(after)];
  assert.equal(is.count, was.count);
  let most = 0;
  atRandomPoints(was.count, (t, weights) => {
    const old = was.sample(path, t, weights, isColour) ?? [1, 1, 1, 1];
    const now = is.sample(path, t, weights, isColour);
    now.slice(0, 3).forEach((value, d) => {
      most = Math.max(most, Math.abs(value - old[d] * factor(t)[d]));
    });
  });
  return most;
}

/** A square in the plane z = 0, with an old layout, and a new one that is turned. */
export function turnedPlane(degrees, more = {}) {
  const corners = [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ];
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  return {
    positions: corners.map(([x, y]) => [x, 1 - y, 0]),
    normals: corners.map(() => [0, 0, 1]),
    uv: corners,
    uv1: corners.map(([x, y]) => [
      0.5 + 0.6 * (c * (x - 0.5) - s * (y - 0.5)),
      0.5 + 0.6 * (s * (x - 0.5) + c * (y - 0.5)),
    ]),
    triangles: [
      [0, 2, 1],
      [0, 3, 2],
    ],
    material: 0,
    ...more,
  };
}
