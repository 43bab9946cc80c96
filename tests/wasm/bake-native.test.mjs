// The command line program and the package bake the same pixels.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { io } from '../support/gltf.mjs';
import { encodedPng } from '../support/made-png.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { texturedCube, texturedGlb } from '../support/textured.mjs';
import { decodePng, imageOf, waves } from './support/bake.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

const fileOf = ({ data, width, height }) => encodedPng(width, height, data);

/** A cube with its old texcoords, and others that are turned, scaled and mirrored. */
function cubeOfTwoSets() {
  const cube = texturedCube();
  const uv1 = cube.uv.map(([u, v]) => [0.9 - 0.7 * v, 0.1 + 0.8 * u]);
  // As a file holds them.
  const stored = (rows) => rows.map((row) => row.map(Math.fround));
  return { ...cube, uv: stored(cube.uv), uv1: stored(uv1), normals: stored(cube.normals) };
}

/** For bake, which measures v from the bottom. */
const upwards = (rows) => new Float64Array(rows.flatMap(([u, v]) => [u, 1 - v]));

function meshOf(cube) {
  return {
    positions: new Float64Array(cube.positions.flat()),
    indices: new Uint32Array(cube.triangles.flat()),
    texcoords: upwards(cube.uv),
    normals: new Float64Array(cube.normals.flat()),
    ...(cube.tangents && { tangents: new Float64Array(cube.tangents.flat()) }),
  };
}

/** The only image that the program makes of a file. */
async function bakedByProgram(t, glb, ...options) {
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), glb);
  const { code, stderr } = await runAbflat(['bake', 'in.glb', '-o', 'out.glb', ...options], {
    cwd: at(),
  });
  assert.deepEqual([code, stderr], [0, '']);
  const document = await io.readBinary(readFileSync(at('out.glb')));
  const textures = document.getRoot().listTextures();
  assert.equal(textures.length, 1);
  return decodePng({ bytes: textures[0].getImage() });
}

const WRAPS = { 10497: 'repeat', 33648: 'mirror', 33071: 'clamp' };
const TRANSFORM = { offset: [0.3, -0.4], rotation: 0.7, scale: [2.5, 1.5] };

for (const [what, { side, image, wraps, alphaMode }] of Object.entries({
  'colours that are transformed': {
    side: '256',
    image: waves(192, 128),
    wraps: [33648, 33071],
  },
  'colours with alpha': {
    side: '128',
    image: imageOf(96, 64, (x, y) => [2 * x, 3 * y, 90, x % 9 > 2 ? 255 : 0]),
    wraps: [10497, 33648],
    alphaMode: 'BLEND',
  },
  'colours at a side of its own choice': { side: 'auto', image: waves(400), wraps: [10497, 10497] },
}))
  test(`${what}: the same pixels`, async (t) => {
    const cube = cubeOfTwoSets();
    const glb = texturedGlb([cube], {
      materials: [
        {
          pbrMetallicRoughness: {
            baseColorFactor: [0.5, 1, 0.25, 1],
            baseColorTexture: { index: 0, extensions: { KHR_texture_transform: TRANSFORM } },
          },
          ...(alphaMode && { alphaMode }),
        },
      ],
      textures: [{ source: 0, sampler: 0 }],
      samplers: [{ wrapS: wraps[0], wrapT: wraps[1] }],
      extensionsUsed: ['KHR_texture_transform'],
      images: [fileOf(image)],
    });
    const native = await bakedByProgram(t, glb, '--bake-resolution', side, '--padding', '5');
    const source = {
      image,
      wrapU: WRAPS[wraps[0]],
      wrapV: WRAPS[wraps[1]],
      ...TRANSFORM,
      factor: [0.5, 1, 0.25, 1],
      opaque: alphaMode === undefined,
    };
    const made = await abflat.bake(meshOf(cube), { uv: upwards(cube.uv1) }, source, {
      bakeResolution: side === 'auto' ? side : Number(side),
      padding: 5,
    });
    assert.deepEqual([made.width, made.height], [native.width, native.height]);
    assert.ok(Buffer.from(made.data).equals(Buffer.from(native.data)), 'all bytes');
  });

for (const [what, more] of Object.entries({
  'computed tangents': {},
  'tangents of the file': { tangents: Array(24).fill([1, 0, 0, -1]) },
  'no normals': { normals: undefined },
}))
  test(`a normal map with ${what}: the same pixels`, async (t) => {
    const cube = { ...cubeOfTwoSets(), ...more };
    const image = imageOf(96, 64, (x, y) => [
      128 + Math.round(60 * Math.sin(x / 5)),
      128 + Math.round(60 * Math.cos(y / 7)),
      230,
    ]);
    const glb = texturedGlb([cube], {
      materials: [{ normalTexture: { index: 0, scale: 0.75 } }],
      textures: [{ source: 0 }],
      images: [fileOf(image)],
    });
    const native = await bakedByProgram(t, glb, '--bake-resolution', '128');
    const { normals, ...bare } = meshOf({ ...cube, normals: cube.normals ?? [] });
    const mesh = cube.normals ? { ...bare, normals } : bare;
    const source = { image, factor: [0.75, 0.75, 1, 1] };
    const made = await abflat.bake(mesh, { uv: upwards(cube.uv1) }, source, {
      kind: 'normal',
      bakeResolution: 128,
    });
    assert.ok(Buffer.from(made.data).equals(Buffer.from(native.data)), 'all bytes');
  });
