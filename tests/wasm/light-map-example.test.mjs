// examples/light-map: a scene, its light map, and a file that is lit by it.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { assertValidFile } from '../support/gltf.mjs';
import { parsePng } from '../support/png.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { ROOT } from './support/paths.mjs';

const io = new NodeIO().registerExtensions(ALL_EXTENSIONS);
/** What a small run of the example writes. */
async function written(t) {
  const at = tempFolder(t);
  const script = join(ROOT, 'examples/light-map/light-map.mjs');
  const { status, stdout, stderr } = spawnSync(process.execPath, [script, at(), '128', '24'], {
    encoding: 'utf8',
  });
  assert.equal(status, 0, stderr);
  assert.match(stdout, /^12 meshes, \d+\.\d texels per unit$/m);
  return {
    document: await io.read(at('scene.glb')),
    png: parsePng(readFileSync(at('light-map.png'))),
  };
}

/** The light where a mesh has a vertex at a place in its own space, near the middle of its faces. */
function lightAt({ document, png }, name, [x, y, z]) {
  const mesh = document
    .getRoot()
    .listMeshes()
    .find((each) => each.getName() === name);
  const [primitive] = mesh.listPrimitives();
  const [positions, uv] = ['POSITION', 'TEXCOORD_1'].map((set) => primitive.getAttribute(set));
  const corners = [...primitive.getIndices().getArray()];
  for (let c = 0; c < corners.length; c += 3) {
    const [a, b, d] = corners.slice(c, c + 3).map((v) => positions.getElement(v, []));
    const weights = weightsAt([x, y, z], a, b, d);
    if (!weights) continue;
    const [u, v] = [0, 1].map((k) =>
      corners
        .slice(c, c + 3)
        .reduce((sum, vertex, i) => sum + weights[i] * uv.getElement(vertex, [])[k], 0),
    );
    return png.at(Math.floor(u * png.width), Math.floor(v * png.height));
  }
  assert.fail(`${name} has nothing there`);
}

const minus = (p, q) => p.map((value, d) => value - q[d]);
const dot = (p, q) => p.reduce((sum, value, d) => sum + value * q[d], 0);

/** Undefined if the point is not in the triangle. */
function weightsAt(point, a, b, c) {
  const [u, v, w] = [minus(b, a), minus(c, a), minus(point, a)];
  const [uu, uv, vv] = [dot(u, u), dot(u, v), dot(v, v)];
  const determinant = uu * vv - uv * uv;
  const s = (dot(w, u) * vv - dot(w, v) * uv) / determinant;
  const t = (dot(w, v) * uu - dot(w, u) * uv) / determinant;
  const off = minus(
    w,
    u.map((value, d) => s * value + t * v[d]),
  );
  const isIn = s >= -1e-6 && t >= -1e-6 && s + t <= 1 + 1e-6 && dot(off, off) < 1e-6;
  return isIn ? [1 - s - t, s, t] : undefined;
}

test('what the sun reaches is bright, and what things stand on is dark', async (t) => {
  const lit = await written(t);
  await assertValidFile(lit.document);
  assert.equal(lit.document.getRoot().listTextures().length, 1);
  assert.equal(lit.document.getRoot().listMeshes().length, 12);
  for (const [bright, dark] of [
    // The floor is a plane that lies: its y is -z of the world.
    [lightAt(lit, 'floor', [3.5, -3.5, 0]), lightAt(lit, 'floor', [-1.5, 2, 0])],
    [lightAt(lit, 'box 2', [0, 0.5, 0]), lightAt(lit, 'box 2', [0, -0.5, 0])],
  ])
    for (let c = 0; c < 3; ++c) assert.ok(bright[c] > 3 * dark[c], `${bright} and ${dark}`);
});
