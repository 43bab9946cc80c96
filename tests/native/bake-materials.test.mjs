// What becomes of materials and of the rest of a file whose textures are baked.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { cubeAt } from '../support/baked-cubes.mjs';
import {
  atRandomPoints,
  COLOUR,
  difference,
  NEAR,
  oneMaterial,
  ROUGH,
  run,
  SIDE,
  unwrapped,
  waves,
} from '../support/baking.mjs';
import { elementsOf, GlbMaker, glbOf } from '../support/glb.mjs';
import { madePng } from '../support/made-png.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { samplerOf, texturedCube, texturedGlb } from '../support/textured.mjs';

/** A colour at each corner of the cube's sides. */
const coloured = (cube, colour) => ({ ...cube, colors: cube.positions.map(colour) });

test('colours of vertices become part of the image, with and without a texture', async (t) => {
  const colour = ([x, y, z]) => [(2 + x) / 4, (3 - y) / 4, 0.5 + 0.2 * z];
  const cubes = [coloured(cubeAt(0, 0), colour), cubeAt(1, 5)];
  const wood = oneMaterial();
  const plain = { pbrMetallicRoughness: { baseColorFactor: [0.5, 0.5, 1, 1] } };
  for (const json of [
    { ...wood, materials: [...wood.materials, plain] },
    { materials: [{}, plain] },
  ]) {
    const before = texturedGlb(cubes, json);
    const { bytes, report } = await unwrapped(t, before, '--bake-resolution', `${SIDE}`);
    assert.deepEqual(
      report.baking.maps.map(({ map }) => map),
      ['baseColor'],
    );
    const [was, is] = [samplerOf(before), samplerOf(bytes)];
    for (const { attributes } of is.json.meshes[0].primitives)
      assert.equal(attributes.COLOR_0, undefined);
    atRandomPoints(was.count, (triangle, weights) => {
      const factor =
        triangle < 12
          ? [0, 1, 2].map((d) =>
              cubes[0].triangles[triangle].reduce(
                (sum, v, k) => sum + weights[k] * cubes[0].colors[v][d],
                0,
              ),
            )
          : [0.5, 0.5, 1];
      const old = was.sample(COLOUR, triangle, weights, true) ?? [1, 1, 1];
      is.sample(COLOUR, triangle, weights, true)
        .slice(0, 3)
        .forEach((x, d) => {
          assert.ok(Math.abs(x - old[d] * factor[d]) < NEAR, `${x} is not ${old[d] * factor[d]}`);
        });
    });
  }
});

test('materials with textures and factors of their own share an atlas', async (t) => {
  const other = texturedCube(1);
  other.positions = other.positions.map(([x, y, z]) => [x + 5, y, z]);
  const before = texturedGlb([texturedCube(0), other], {
    materials: [
      {
        name: 'metal',
        pbrMetallicRoughness: {
          baseColorTexture: { index: 0 },
          baseColorFactor: [0.5, 1, 0.25, 1],
          metallicFactor: 0.8,
          roughnessFactor: 0.25,
          metallicRoughnessTexture: { index: 1 },
        },
        occlusionTexture: { index: 1, strength: 0.5 },
        emissiveFactor: [0, 0.5, 0],
      },
      { name: 'plain', pbrMetallicRoughness: { baseColorFactor: [0.2, 0.4, 0.8, 1] } },
    ],
    textures: [{ source: 0 }, { source: 1 }],
    images: [waves(384, 256), waves(192, 128, 1)],
  });
  const { bytes, report } = await unwrapped(t, before, '--bake-resolution', `${SIDE}`);
  const first = (t) => t < 12;
  assert.ok(
    difference(before, bytes, COLOUR, {
      isColour: true,
      factor: (t) => (first(t) ? [0.5, 1, 0.25] : [0.2, 0.4, 0.8]),
    }) < NEAR,
  );
  const [was, is] = [samplerOf(before), samplerOf(bytes)];
  atRandomPoints(was.count, (t, weights) => {
    const [occlusion, rough, metal] = is.sample(ROUGH, t, weights);
    const old = first(t) ? was.sample(ROUGH, t, weights) : [1, 1, 1];
    const expected = first(t) ? [0.5 + 0.5 * old[0], 0.25 * old[1], 0.8 * old[2]] : [1, 1, 1];
    [occlusion, rough, metal].forEach((x, d) => {
      assert.ok(Math.abs(x - expected[d]) < NEAR, `${[x, d]} is not ${expected}`);
    });
    const glow = is.sample('emissiveTexture', t, weights, true);
    assert.ok(Math.abs(glow[1] - (first(t) ? 0.5 : 0)) < 0.01);
  });
  assert.deepEqual(is.json.materials, [
    {
      name: 'metal',
      pbrMetallicRoughness: {
        baseColorTexture: { index: 0 },
        metallicRoughnessTexture: { index: 1 },
      },
      occlusionTexture: { index: 1 },
      emissiveFactor: [1, 1, 1],
      emissiveTexture: { index: 2 },
    },
  ]);
  assert.deepEqual(
    report.baking.maps.map(({ map }) => map),
    ['baseColor', 'metallicRoughness', 'emissive'],
  );
  assert.deepEqual([report.baking.materials, report.baking.images], [2, 2]);
});

test('materials with images of their own, all in one square, are packed apart', async (t) => {
  const other = texturedCube(1);
  other.positions = other.positions.map(([x, y, z]) => [x + 5, y, z]);
  const before = texturedGlb([texturedCube(0), other], {
    materials: [0, 1].map((index) => ({
      pbrMetallicRoughness: { baseColorTexture: { index } },
    })),
    textures: [{ source: 0 }, { source: 1 }],
    images: [waves(384, 256), waves(384, 256, 1)],
  });
  const { bytes, report } = await run(t, before, 'pack', '--bake', '--bake-resolution', `${SIDE}`);
  assert.equal(report.stacked.islands, 0);
  assert.ok(difference(before, bytes, COLOUR, { isColour: true }) < NEAR);
});

test('light above 1 and occlusion alone are kept', async (t) => {
  const strong = { KHR_materials_emissive_strength: { emissiveStrength: 5 } };
  const cubes = [0, 1].map((material) => {
    const cube = texturedCube(material);
    cube.positions = cube.positions.map(([x, y, z]) => [x + 5 * material, y, z]);
    return cube;
  });
  const before = texturedGlb(cubes, {
    materials: [
      { emissiveTexture: { index: 0 }, emissiveFactor: [1, 0.5, 1], extensions: strong },
      { occlusionTexture: { index: 0, strength: 0.25 } },
    ],
    textures: [{ source: 0 }],
    images: [waves(192, 128)],
    extensionsUsed: Object.keys(strong),
  });
  const { bytes } = await unwrapped(t, before, '--bake-resolution', '512');
  const [was, is] = [samplerOf(before), samplerOf(bytes)];
  assert.equal(is.json.materials.length, 1);
  assert.deepEqual(is.json.materials[0].extensions, strong);
  assert.deepEqual(is.json.extensionsUsed, Object.keys(strong));
  atRandomPoints(24, (t, weights) => {
    const glow = is.sample('emissiveTexture', t, weights, true);
    const shade = is.sample('occlusionTexture', t, weights);
    const old = was.sample(t < 12 ? 'emissiveTexture' : 'occlusionTexture', t, weights, t < 12);
    const expected = t < 12 ? [old[0], 0.5 * old[1], old[2]] : [0, 0, 0];
    glow.forEach((x, d) => {
      assert.ok(Math.abs(x - expected[d]) < NEAR, `${glow} is not ${expected}`);
    });
    assert.ok(Math.abs(shade[0] - (t < 12 ? 1 : 0.75 + 0.25 * old[0])) < 0.02);
  });
});

test('materials that differ in more than images hold stay apart', async (t) => {
  const parts = [0, 1, 2].map((material) => {
    const cube = texturedCube(material);
    cube.positions = cube.positions.map(([x, y, z]) => [x + 5 * material, y, z]);
    return cube;
  });
  const pbrMetallicRoughness = { baseColorTexture: { index: 0 } };
  const half = madePng(32, 32, () => [200, 100, 50, 128]);
  const before = texturedGlb(parts, {
    materials: [
      { name: 'opaque', pbrMetallicRoughness },
      {
        name: 'leaf',
        pbrMetallicRoughness,
        alphaMode: 'MASK',
        alphaCutoff: 0.3,
        doubleSided: true,
      },
      { name: 'paint', pbrMetallicRoughness },
    ],
    textures: [{ source: 0 }],
    images: [half],
  });
  const { bytes } = await unwrapped(t, before, '--bake-resolution', '512');
  const { sample, json } = samplerOf(bytes);
  assert.deepEqual(
    json.materials.map(({ name, alphaMode, alphaCutoff, doubleSided }) => [
      name,
      alphaMode,
      alphaCutoff,
      doubleSided,
    ]),
    [
      ['opaque', undefined, undefined, undefined],
      ['leaf', 'MASK', 0.3, true],
    ],
  );
  assert.deepEqual(
    json.meshes[0].primitives.map(({ material }) => material),
    [0, 1, 0],
  );
  atRandomPoints(36, (triangle, weights) => {
    const alpha = sample(COLOUR, triangle, weights)[3];
    assert.ok(Math.abs(alpha - (triangle >= 12 && triangle < 24 ? 128 / 255 : 1)) < 0.01);
  });
  const jpeg = await unwrapped(t, before, '--image-format', 'jpeg');
  assert.match(jpeg.report.notes.join(), /baseColor is a PNG, because it has alpha/);
});

test('textures that are not baked keep their texcoords', async (t) => {
  const clearcoat = { clearcoatFactor: 1, clearcoatTexture: { index: 0 } };
  const before = texturedGlb([texturedCube()], {
    ...oneMaterial({ extensions: { KHR_materials_clearcoat: clearcoat } }),
    extensionsUsed: ['KHR_materials_clearcoat'],
  });
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), before);
  const args = ['unwrap', 'in.glb', '-o', 'out.glb', '--bake', '--report', 'r.json'];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.equal(code, 0);
  assert.match(stderr, /a texture uses TEXCOORD_0, so the new texcoords are TEXCOORD_1/);
  const bytes = readFileSync(at('out.glb'));
  const { json } = samplerOf(bytes);
  assert.deepEqual(json.materials[0].extensions.KHR_materials_clearcoat, clearcoat);
  assert.equal(json.materials[0].pbrMetallicRoughness.baseColorTexture.texCoord, 1);
  assert.equal(json.images.length, 2);
  // So do those of the variants of a material.
  const mappings = [{ material: 1, variants: [0] }];
  const { gltf, json: changed } = samplerOf(texturedGlb([texturedCube()], oneMaterial()));
  changed.materials.push({ name: 'night', ...changed.materials[0] });
  changed.meshes[0].primitives[0].extensions = { KHR_materials_variants: { mappings } };
  changed.extensions = { KHR_materials_variants: { variants: [{ name: 'night' }] } };
  changed.extensionsUsed = ['KHR_materials_variants'];
  writeFileSync(at('in.glb'), glbOf(changed, gltf.buffer));
  assert.equal((await runAbflat(args, { cwd: at() })).code, 0);
  const variants = samplerOf(readFileSync(at('out.glb'))).json;
  const [{ material, extensions }] = variants.meshes[0].primitives;
  const night = variants.materials[extensions.KHR_materials_variants.mappings[0].material];
  assert.deepEqual(
    [night, variants.materials[material]].map(
      ({ pbrMetallicRoughness: { baseColorTexture } }) => baseColorTexture.texCoord ?? 0,
    ),
    [0, 1],
  );
  const path = 'extensions.KHR_materials_clearcoat.clearcoatTexture';
  assert.ok(difference(before, bytes, path) < 1e-9);
  assert.ok(difference(before, bytes, COLOUR, { isColour: true }) < 0.1);
});

test('what else is in the file stays, and what nothing uses goes', async (t) => {
  const maker = new GlbMaker();
  const cube = texturedCube();
  const vertices = (list, type) =>
    maker.accessor(Float32Array.from(list.flat()), type, { box: true, target: 34962 });
  const attributes = {
    POSITION: vertices(cube.positions, 'VEC3'),
    NORMAL: vertices(cube.normals, 'VEC3'),
    TEXCOORD_0: vertices(cube.uv, 'VEC2'),
    COLOR_0: vertices(
      cube.positions.map(() => [0.5, 0.25, 1]),
      'VEC3',
    ),
  };
  const indices = maker.accessor(Uint16Array.from(cube.triangles.flat()), 'SCALAR', {
    target: 34963,
  });
  const times = maker.accessor(Float32Array.of(0, 1), 'SCALAR', { box: true });
  const moves = maker.accessor(Float32Array.of(0, 0, 0, 1, 2, 3), 'VEC3');
  const big = maker.view(madePng(512, 512, (x, y) => [x % 256, y % 256, (x * y) % 251]));
  Object.assign(maker.json, {
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, name: 'box', extras: { id: 7 } }],
    meshes: [{ primitives: [{ attributes, indices, material: 0 }] }],
    materials: [
      { pbrMetallicRoughness: { baseColorTexture: { index: 0 } } },
      { name: 'unused', emissiveTexture: { index: 0 } },
    ],
    textures: [{ source: 0 }],
    images: [{ bufferView: big, mimeType: 'image/png' }],
    animations: [
      {
        channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }],
        samplers: [{ input: times, output: moves }],
      },
    ],
  });
  const before = maker.glb();
  const { bytes } = await unwrapped(t, before, '--bake-resolution', '64');
  const { gltf, json } = samplerOf(bytes);
  assert.ok(bytes.length < before.length / 2);
  assert.deepEqual(json.nodes, maker.json.nodes);
  assert.deepEqual([json.materials.length, json.images.length], [1, 1]);
  const { input, output } = json.animations[0].samplers[0];
  assert.deepEqual(elementsOf(gltf, input), [[0], [1]]);
  assert.deepEqual(elementsOf(gltf, output), [
    [0, 0, 0],
    [1, 2, 3],
  ]);
  assert.equal('COLOR_0' in json.meshes[0].primitives[0].attributes, false);
  // An extension that is not known may refer to anything.
  maker.json.extensionsUsed = ['KHR_animation_pointer'];
  const kept = await unwrapped(t, maker.glb(), '--bake-resolution', '64');
  assert.equal(samplerOf(kept.bytes).json.images.length, 2);
});
