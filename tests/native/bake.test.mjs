// Old textures in a new layout: by unwrap --bake, and by bake from one texcoord set to another.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { randomNumbers } from '../support/disks.mjs';
import { elementsOf, GlbMaker, glbOf } from '../support/glb.mjs';
import { errorsIn } from '../support/gltf-errors.mjs';
import { greyPng, madePng } from '../support/made-png.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { CUBE } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { oneTexture, samplerOf, texturedCube, texturedGlb } from '../support/textured.mjs';

const COLOUR = 'pbrMetallicRoughness.baseColorTexture';
const ROUGH = 'pbrMetallicRoughness.metallicRoughnessTexture';

/** A smooth picture. */
const waves = (width, height = width, phase = 0) =>
  madePng(width, height, (x, y) =>
    [0, 1, 2].map((d) =>
      Math.round(
        128 +
          100 * Math.sin((9 * x) / width + 2 * d + phase) * Math.cos((7 * y) / height + d + phase),
      ),
    ),
  );

const oneMaterial = (...more) => oneTexture(waves(384, 256), ...more);

/** Runs a command on the bytes of a GLB. Returns the bytes of the result and the report. */
async function run(t, bytes, command, ...options) {
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

const unwrapped = (t, bytes, ...options) => run(t, bytes, 'unwrap', '--bake', ...options);

async function refused(t, bytes, ...args) {
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), bytes);
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  return [code, stderr.split('\n')[0]];
}

/**
 * Calls `compare(triangle, weights)` for random points of the mesh; none is where a texel belongs to
 * two triangles, which may have been apart in the old layout.
 */
function atRandomPoints(count, compare) {
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
function difference(before, after, path, { factor = () => [1, 1, 1, 1], isColour = false } = {}) {
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

test('a cube has the same colours everywhere when it is unwrapped anew', async (t) => {
  const before = texturedGlb([texturedCube()], oneMaterial());
  const { bytes, report } = await unwrapped(t, before, '--bake-resolution', '1024');
  assert.ok(difference(before, bytes, COLOUR, { isColour: true }) < 0.02);
  assert.deepEqual(
    report.baking.maps.map(({ map, resolution, format }) => [map, resolution, format]),
    [['baseColor', 1024, 'png']],
  );
  const { json } = samplerOf(bytes);
  assert.deepEqual([json.images.length, json.textures.length, json.materials.length], [1, 1, 1]);
  assert.equal(json.materials[0].name, 'wood');
  assert.equal('TEXCOORD_1' in json.meshes[0].primitives[0].attributes, false);
});

test('a layout that is packed again has the colours it had', async (t) => {
  const before = texturedGlb([texturedCube()], oneMaterial());
  const { bytes, report } = await run(t, before, 'pack', '--bake', '--bake-resolution', '1024');
  assert.ok(difference(before, bytes, COLOUR, { isColour: true }) < 0.02);
  assert.equal(report.baking.maps[0].resolution, 1024);
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

/** A square in the plane z = 0, with an old layout, and a new one that is turned. */
function turnedPlane(degrees, more = {}) {
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
  const { bytes, report } = await unwrapped(t, before, '--bake-resolution', '1024');
  const first = (t) => t < 12;
  assert.ok(
    difference(before, bytes, COLOUR, {
      isColour: true,
      factor: (t) => (first(t) ? [0.5, 1, 0.25] : [0.2, 0.4, 0.8]),
    }) < 0.02,
  );
  const [was, is] = [samplerOf(before), samplerOf(bytes)];
  atRandomPoints(was.count, (t, weights) => {
    const [occlusion, rough, metal] = is.sample(ROUGH, t, weights);
    const old = first(t) ? was.sample(ROUGH, t, weights) : [1, 1, 1];
    const expected = first(t) ? [0.5 + 0.5 * old[0], 0.25 * old[1], 0.8 * old[2]] : [1, 1, 1];
    [occlusion, rough, metal].forEach((x, d) => {
      assert.ok(Math.abs(x - expected[d]) < 0.02, `${[x, d]} is not ${expected}`);
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
      assert.ok(Math.abs(x - expected[d]) < 0.03, `${glow} is not ${expected}`);
    });
    assert.ok(Math.abs(shade[0] - (t < 12 ? 1 : 0.75 + 0.25 * old[0])) < 0.02);
  });
});

test('an OBJ with a picture is baked in two steps', async (t) => {
  const at = tempFolder(t);
  const cube = texturedCube();
  writeFileSync(at('wood.png'), waves(384, 256));
  writeFileSync(at('in.mtl'), 'newmtl wood\nmap_Kd wood.png\n');
  writeFileSync(
    at('in.obj'),
    [
      'mtllib in.mtl\nusemtl wood',
      ...cube.positions.map((p) => `v ${p.join(' ')}`),
      ...cube.uv.map(([u, v]) => `vt ${u} ${1 - v}`),
      ...cube.triangles.map((face) => `f ${face.map((v) => `${v + 1}/${v + 1}`).join(' ')}`),
    ].join('\n'),
  );
  for (const args of [
    ['unwrap', 'in.obj', '-o', 'two.glb', '--texcoord', '1'],
    ['bake', 'two.glb', '-o', 'out.glb', '--bake-resolution', '1024'],
  ])
    assert.equal((await runAbflat(args, { cwd: at() })).code, 0);
  const before = texturedGlb([cube], oneMaterial());
  const bytes = readFileSync(at('out.glb'));
  assert.ok(difference(before, bytes, COLOUR, { isColour: true }) < 0.02);
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
      images: [
        madePng(64, 64, (x, y) =>
          [0, 1, 2].map((d) =>
            Math.round(
              128 +
                90 *
                  Math.sin(0.5 + (Math.PI * (x + 0.5)) / 32 + d) *
                  Math.cos((Math.PI * (y + 0.5)) / 32 + d),
            ),
          ),
        ),
      ],
    });
    const { bytes } = await unwrapped(t, before, '--bake-resolution', '1024');
    assert.ok(difference(before, bytes, COLOUR, { isColour: true }) < 0.03);
    const { json } = samplerOf(bytes);
    assert.deepEqual([json.extensionsUsed, json.samplers], [undefined, undefined]);
  }
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
  const colors = elementsOf(gltf, json.meshes[0].primitives[0].attributes.COLOR_0);
  assert.ok(colors.every((each) => each.join() === '0.5,0.25,1'));
  // An extension that is not known may refer to anything.
  maker.json.extensionsUsed = ['KHR_animation_pointer'];
  const kept = await unwrapped(t, maker.glb(), '--bake-resolution', '64');
  assert.equal(samplerOf(kept.bytes).json.images.length, 2);
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

test('what cannot be baked is refused in a sentence', async (t) => {
  const good = texturedGlb([texturedCube()], oneMaterial());
  const unwrap = (...options) => ['unwrap', 'in.glb', '-o', 'out.glb', '--bake', ...options];
  const broken = texturedGlb([texturedCube()], {
    ...oneMaterial(),
    images: [waves(64).subarray(0, 900)],
  });
  assert.deepEqual(await refused(t, broken, ...unwrap()), [
    3,
    'abflat: in.glb: images[0] is a damaged PNG: it ends too early. Export it again.',
  ]);
  // A few kilobytes that would be gigabytes.
  const huge = Array.from({ length: 3 }, (_, i) => greyPng(16384, 16384, i));
  const bomb = texturedGlb(
    huge.map((_, i) => texturedCube(i)),
    {
      materials: huge.map((_, index) => ({ emissiveTexture: { index } })),
      textures: huge.map((_, source) => ({ source })),
      images: huge,
    },
  );
  assert.match(
    (await refused(t, bomb, ...unwrap()))[1],
    /images\[2\] brings the images to 805306368 pixels from \d+ bytes, which is too many/,
  );
  const strange = texturedGlb([texturedCube()], {
    ...oneMaterial(),
    images: [Buffer.from('\xabKTX 20\xbb\r\n\x1a\n', 'latin1')],
  });
  assert.match((await refused(t, strange, ...unwrap()))[1], /images\[0\] is a KTX2 texture/);
  assert.deepEqual(await refused(t, good, 'unwrap', 'in.glb', '-o', 'out.obj', '--bake'), [
    2,
    'abflat: --output: must end in .glb or .gltf: only a glTF holds the new images, not out.obj.',
  ]);
  assert.match(
    (await refused(t, good, ...unwrap('--udim', '--texel-density', '9')))[1],
    /one tile/,
  );
  assert.match(
    (await refused(t, good, 'unwrap', 'in.glb', '-o', 'out.glb', '--image-format', 'png'))[1],
    /--bake/,
  );
  assert.deepEqual(await refused(t, good, 'bake', 'in.glb', '-o', 'out.glb'), [
    4,
    'abflat: in.glb: no face has TEXCOORD_1. Name the set of the new layout with --texcoord, or use unwrap --bake.',
  ]);
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), CUBE);
  const obj = await runAbflat(['unwrap', 'in.obj', '-o', 'out.glb', '--bake'], { cwd: at() });
  assert.deepEqual(
    [obj.code, obj.stderr],
    [
      2,
      'abflat: in.obj is OBJ. --bake needs a glTF: write one with --texcoord 1, then use abflat bake.\n',
    ],
  );
});
