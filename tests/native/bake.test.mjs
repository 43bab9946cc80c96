// Old textures in a new layout: colours stay where they were.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  atRandomPoints,
  COLOUR,
  difference,
  NEAR,
  oneMaterial,
  run,
  SIDE,
  tiling,
  unwrapped,
  waves,
} from '../support/baking.mjs';
import { samplerOf, texturedCube, texturedGlb } from '../support/textured.mjs';

test('a cube has the same colours everywhere when it is unwrapped anew', async (t) => {
  const before = texturedGlb([texturedCube()], oneMaterial());
  const { bytes, report } = await unwrapped(t, before, '--bake-resolution', `${SIDE}`);
  assert.ok(difference(before, bytes, COLOUR, { isColour: true }) < NEAR);
  assert.deepEqual(
    report.baking.maps.map(({ map, resolution, format }) => [map, resolution, format]),
    [['baseColor', SIDE, 'png']],
  );
  const { json } = samplerOf(bytes);
  assert.deepEqual([json.images.length, json.textures.length, json.materials.length], [1, 1, 1]);
  assert.equal(json.materials[0].name, 'wood');
  assert.equal('TEXCOORD_1' in json.meshes[0].primitives[0].attributes, false);
});

test('a layout that is packed again has the colours it had', async (t) => {
  const before = texturedGlb([texturedCube()], oneMaterial());
  const { bytes, report } = await run(t, before, 'pack', '--bake', '--bake-resolution', `${SIDE}`);
  assert.ok(difference(before, bytes, COLOUR, { isColour: true }) < NEAR);
  assert.equal(report.baking.maps[0].resolution, SIDE);
});

test('a layout that stays has the pixels it had', async (t) => {
  const cube = texturedCube();
  // Not mirrored, as --keep wants it.
  cube.uv = cube.uv.map(([u, v]) => [u, 1 - v]);
  const before = texturedGlb([{ ...cube, uv1: cube.uv }], {
    ...oneMaterial(),
    images: [waves(256)],
  });
  for (const [command, ...options] of [
    ['bake', '--bake-resolution', '256'],
    ['unwrap', '--bake', '--keep', 'uv', '--resolution', '256', '--bake-resolution', '256'],
  ]) {
    const { bytes } = await run(t, before, command, ...options);
    const { sample } = samplerOf(bytes);
    const old = samplerOf(before);
    atRandomPoints(old.count, (triangle, weights) => {
      const [was, is] = [old, { sample }].map((each) => each.sample(COLOUR, triangle, weights));
      is.forEach((value, d) => {
        assert.ok(Math.abs(value - was[d]) <= 1.01 / 255, `${value} is not ${was[d]}`);
      });
    });
  }
});

test('transforms and wrap modes are part of the old layout', async (t) => {
  const transform = { offset: [0.3, -0.4], rotation: 0.7, scale: [2.5, 1.5] };
  for (const [wrapS, wrapT] of [
    [10497, 33648],
    [33648, 33071],
  ]) {
    const before = texturedGlb([texturedCube()], {
      ...oneMaterial({}, { extensions: { KHR_texture_transform: transform } }),
      textures: [{ source: 0, sampler: 0 }],
      samplers: [{ wrapS, wrapT }],
      extensionsUsed: ['KHR_texture_transform'],
      // Alike at opposite edges, so that a small error is no large one.
      images: [tiling(64)],
    });
    const { bytes } = await unwrapped(t, before, '--bake-resolution', `${SIDE}`);
    assert.ok(difference(before, bytes, COLOUR, { isColour: true }) < NEAR);
    const { json } = samplerOf(bytes);
    assert.deepEqual([json.extensionsUsed, json.samplers], [undefined, undefined]);
  }
});

test('without textures, colours become images if they differ', async (t) => {
  const colours = [
    [1, 0, 0, 1],
    [0, 0, 1, 1],
  ];
  const parts = [0, 1].map((material) => {
    const cube = texturedCube(material);
    cube.positions = cube.positions.map(([x, y, z]) => [x + 5 * material, y, z]);
    return cube;
  });
  const json = {
    materials: colours.map((baseColorFactor) => ({ pbrMetallicRoughness: { baseColorFactor } })),
  };
  const { bytes, report } = await unwrapped(t, texturedGlb(parts, json), '--resolution', '256');
  assert.deepEqual(
    report.baking.maps.map(({ map, resolution }) => [map, resolution]),
    [['baseColor', 256]],
  );
  const { sample } = samplerOf(bytes);
  atRandomPoints(24, (triangle, weights) => {
    const expected = triangle < 12 ? [1, 0, 0] : [0, 0, 1];
    sample(COLOUR, triangle, weights).forEach((x, d) => {
      assert.ok(Math.abs(x - expected[d]) < 0.01);
    });
  });
  const plain = await unwrapped(t, texturedGlb([texturedCube(0)], json));
  assert.deepEqual(plain.report.baking.maps, []);
  assert.match(
    plain.report.notes.join(),
    /nothing was baked: no material of the mesh has a texture/,
  );
});

test('images can be JPEG or WebP', async (t) => {
  const before = texturedGlb([texturedCube()], oneMaterial());
  for (const [format, magic] of [
    ['jpeg', 'ffd8ff'],
    ['webp', '52494646'],
  ]) {
    const { bytes, report } = await unwrapped(t, before, '--image-format', format);
    const { json, gltf } = samplerOf(bytes);
    const [image] = json.images;
    assert.equal(image.mimeType, `image/${format}`);
    const { byteOffset, byteLength } = json.bufferViews[image.bufferView];
    assert.equal(report.baking.maps[0].bytes, byteLength);
    const data = gltf.buffer.subarray(byteOffset, byteOffset + byteLength);
    assert.ok(data.toString('hex').startsWith(magic));
    const required = format === 'webp' ? ['EXT_texture_webp'] : undefined;
    assert.deepEqual([json.extensionsUsed, json.extensionsRequired], [required, required]);
    // And read again.
    const again = await unwrapped(t, bytes, '--bake-resolution', '512');
    assert.ok(difference(before, again.bytes, COLOUR, { isColour: true }) < 0.12);
  }
});
