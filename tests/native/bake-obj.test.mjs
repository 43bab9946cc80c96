// An OBJ whose textures follow its new layout.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import {
  atRandomPoints,
  COLOUR,
  difference,
  NEAR,
  oneMaterial,
  ROUGH,
  SIDE,
  tiling,
  turnedPlane,
  waves,
} from '../support/baking.mjs';
import { errorsIn } from '../support/gltf-errors.mjs';
import { grey16Png, madePng } from '../support/made-png.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { sphere } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { samplerOf, texturedCube, texturedGlb } from '../support/textured.mjs';
import { directionOfX, objSampler, texturedObj } from '../support/textured-obj.mjs';

/** Files in a folder of its own, `in.obj` among them; runs a command there. */
async function objRun(t, files, ...args) {
  const at = tempFolder(t);
  for (const [name, content] of Object.entries(files)) writeFileSync(at(name), content);
  const { code, stderr } = await runAbflat([...args, '--report', 'r.json'], { cwd: at() });
  const report = () => JSON.parse(readFileSync(at('r.json'), 'utf8'));
  return { at, code, stderr, report };
}

const moved = (part, x) => ({
  ...part,
  positions: part.positions.map((p) => [p[0] + x, p[1], p[2]]),
});

/** Two cubes beside each other, with a material each. */
const twoCubes = (...materials) =>
  texturedObj(
    'in.mtl',
    materials.map((material, i) => {
      const cube = moved(texturedCube(), 5 * i);
      // Beside each other, as pack keeps what lies on each other.
      return { ...cube, uv: cube.uv.map(([u, v]) => [u + i, v]), material };
    }),
  );

/** The largest difference of a map, of the channels that both have. */
function objDifference(before, after, keyword, { isColour = false } = {}) {
  let most = 0;
  atRandomPoints(before.count, (t, weights) => {
    const was = before.sample(keyword, t, weights, isColour);
    const is = after.sample(keyword, t, weights, isColour);
    assert.equal(is === undefined, was === undefined);
    was?.slice(0, 3).forEach((value, d) => {
      most = Math.max(most, Math.abs(value - (is[d] ?? is[0])));
    });
  });
  return most;
}

const MTL = `newmtl wood
Kd 0.5 0.5 0.5
map_Kd -s 2 2 1 -o 0.25 0.5 0 wood.png
map_Ks -s 2 2 1 -o 0.25 0.5 0 wood.png
Pr 0.5
map_Pr -imfchan g rough.png
# kept
illum 2
newmtl plain
Kd 1 0 0
map_Kd other.png
newmtl unused
map_Kd lost.png
`;

test('an OBJ has the same colours everywhere, with its materials beside it', async (t) => {
  const files = {
    'in.obj': twoCubes('wood', 'plain'),
    'in.mtl': MTL,
    'wood.png': tiling(128),
    'rough.png': waves(192, 128, 1),
    'other.png': waves(384, 256, 2),
  };
  for (const command of ['unwrap', 'pack']) {
    const args = [command, 'in.obj', '-o', 'out.obj', '--bake', '--bake-resolution', `${SIDE}`];
    const { at, code, stderr, report } = await objRun(t, files, ...args);
    assert.deepEqual([code, stderr], [0, '']);
    const [was, is] = [objSampler(at('in.obj')), objSampler(at('out.obj'))];
    for (const keyword of ['map_Kd', 'map_Ks'])
      assert.ok(objDifference(was, is, keyword, { isColour: true }) < NEAR);
    assert.ok(objDifference(was, is, 'map_Pr') < NEAR);
    // All else is as it was, and what the mesh does not use is gone.
    assert.equal(
      readFileSync(at('out.mtl'), 'utf8'),
      `newmtl wood
Kd 0.5 0.5 0.5
map_Kd out-diffuse.png
map_Ks out-diffuse.png
Pr 0.5
map_Pr -imfchan g out-roughness.png
# kept
illum 2
newmtl plain
Kd 1 0 0
map_Kd out-diffuse.png
`,
    );
    const { maps, materials, images } = report().baking;
    assert.deepEqual(
      maps.map(({ map }) => map),
      ['diffuse', 'roughness'],
    );
    assert.deepEqual([materials, images], [2, 3]);
  }
});

test('an opacity is the alpha of its image, as before', async (t) => {
  const leaf = madePng(96, 64, (x, y) => [200, 100, 50, 2 * x + (y % 3)]);
  const { at, code } = await objRun(
    t,
    {
      'in.obj': twoCubes('leaf', 'wood'),
      'in.mtl': 'newmtl leaf\nmap_Kd leaf.png\nmap_d leaf.png\nnewmtl wood\nmap_Kd wood.png\n',
      'leaf.png': leaf,
      'wood.png': waves(96, 64),
    },
    ...['unwrap', 'in.obj', '-o', 'out.obj', '--bake', '--bake-resolution', `${SIDE}`],
  );
  assert.equal(code, 0);
  const [was, is] = [objSampler(at('in.obj')), objSampler(at('out.obj'))];
  assert.equal(is.words('map_d', 0).at(-1), 'out-diffuse.png');
  assert.equal(is.words('map_d', 12), undefined);
  atRandomPoints(24, (triangle, weights) => {
    const [before, now] = [was, is].map((each) => each.sample('map_Kd', triangle, weights));
    assert.ok(Math.abs(before[3] - now[3]) < NEAR, `${before} is not ${now}`);
  });
});

test('bumps of an OBJ are turned if they are normals, and stay heights otherwise', async (t) => {
  const plane = { ...turnedPlane(0), material: 'wood' };
  const heights = grey16Png(64, 64, (x) => 900 * x);
  const { at, code, stderr, report } = await objRun(
    t,
    {
      'in.obj': texturedObj('in.mtl', [plane, { ...moved(plane, 3), material: 'stone' }]),
      'in.mtl':
        'newmtl wood\nmap_Bump -bm 0.5 tilted.png\nnewmtl stone\nmap_Bump -bm 0.2 heights.png\n',
      'tilted.png': madePng(64, 64, () => [178, 128, 245]),
      'heights.png': heights,
    },
    ...['unwrap', 'in.obj', '-o', 'out.obj', '--bake', '--bake-resolution', '256'],
  );
  assert.deepEqual([code, stderr], [0, '']);
  assert.deepEqual(
    report().baking.maps.map(({ map }) => map),
    ['normal', 'bump'],
  );
  const mtl = readFileSync(at('out.mtl'), 'utf8');
  assert.match(mtl, /map_Bump -bm 0.5 out-normal.png\nnewmtl stone\nmap_Bump -bm 0.2 out-bump.png/);
  // The directions of the old u and v in the new layout.
  const { sample } = objSampler(at('out.obj'));
  for (const triangle of [0, 1]) {
    const [r, g, b] = sample('map_Bump', triangle, [0.4, 0.3, 0.3]).map((x) => 2 * x - 1);
    const [c, s] = directionOfX(at('out.obj'), triangle);
    const length = Math.hypot(178 / 127.5 - 1, 0.004, 245 / 127.5 - 1);
    const tilt = (178 / 127.5 - 1) / length;
    for (const [is, expected] of [
      [r, c * tilt],
      [g, s * tilt],
      [b, (245 / 127.5 - 1) / length],
    ])
      assert.ok(Math.abs(is - expected) < 0.02, `${[r, g, b]} is not at ${[c, s]}`);
  }
  // Without steps of 8 bits.
  assert.equal(readFileSync(at('out-bump.png'))[24], 16);
});

test('what an OBJ cannot keep is said, and its own files are not replaced', async (t) => {
  const files = {
    'in.obj': twoCubes('wood', 'plain'),
    'in.mtl': 'newmtl wood\nmap_Kd wood.png\nrefl sky.png\nmap_Ks lost.png\nmap_Ns bad.tga\n',
    'wood.png': waves(64),
    'bad.tga': 'no image',
  };
  const args = (output) => ['unwrap', 'in.obj', '-o', output, '--bake'];
  const { at, code, stderr, report } = await objRun(t, files, ...args('out.obj'));
  assert.equal(code, 0);
  for (const sentence of [
    /'refl' of material 'wood' was left out, because images of this kind are not baked/,
    /image lost.png was left out: cannot read lost.png: No such file/,
    /image bad.tga was left out: it is neither a PNG, a JPEG nor a WebP image. Convert it to PNG/,
  ]) {
    assert.match(stderr, sentence);
    assert.match(report().notes.join('\n'), sentence);
  }
  assert.equal(readFileSync(at('out.mtl'), 'utf8'), 'newmtl wood\nmap_Kd out-diffuse.png\n');
  const again = await runAbflat(args('in.obj'), { cwd: at() });
  assert.deepEqual(
    [again.code, again.stderr],
    [2, 'abflat: --bake would write in.mtl, which is in use. Give --output another name.\n'],
  );
  assert.equal(readFileSync(at('in.mtl'), 'utf8'), files['in.mtl']);
  const plain = await objRun(
    t,
    { 'in.obj': twoCubes('wood', 'plain').replace('mtllib in.mtl\n', '') },
    ...args('out.obj'),
  );
  assert.equal(plain.code, 0);
  assert.match(plain.report().notes.join(), /nothing was baked/);
  assert.equal(existsSync(plain.at('out.mtl')), false);
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
    ['bake', 'two.glb', '-o', 'out.glb', '--bake-resolution', `${SIDE}`],
  ])
    assert.equal((await runAbflat(args, { cwd: at() })).code, 0);
  const before = texturedGlb([cube], oneMaterial());
  const bytes = readFileSync(at('out.glb'));
  assert.ok(difference(before, bytes, COLOUR, { isColour: true }) < NEAR);
});

test('a glTF made from an OBJ has its images for the new layout', async (t) => {
  const files = {
    'in.obj': twoCubes('leaf', 'metal'),
    'in.mtl': `newmtl leaf
map_Kd leaf.png
map_d leaf.png
map_Ke glow.png
newmtl metal
Kd 1 0 0
Pr 0.25
map_Pm metal.png
norm -bm 0.5 tilted.png
map_Ks leaf.png
`,
    'leaf.png': madePng(96, 64, (x, y) => [200, 100, 50, 2 * x + (y % 3)]),
    'glow.png': waves(96, 64),
    'metal.png': waves(192, 128, 1),
    'tilted.png': madePng(64, 64, () => [178, 128, 245]),
  };
  const args = ['unwrap', 'in.obj', '-o', 'out.glb', '--bake', '--bake-resolution', `${SIDE}`];
  const { at, code, stderr, report } = await objRun(t, files, ...args);
  assert.deepEqual([code, stderr], [0, '']);
  assert.deepEqual(await errorsIn(at('out.glb'), at), []);
  assert.match(report().notes.join(), /images for specular were left out, because glTF has no/);
  const was = objSampler(at('in.obj'));
  const { sample, json, count } = samplerOf(readFileSync(at('out.glb')));
  assert.deepEqual(
    json.materials.map(({ name, alphaMode, pbrMetallicRoughness, normalTexture }) => [
      name,
      alphaMode,
      pbrMetallicRoughness.baseColorFactor,
      pbrMetallicRoughness.metallicFactor,
      pbrMetallicRoughness.roughnessFactor,
      normalTexture?.scale,
    ]),
    [
      ['leaf', 'BLEND', undefined, 0, undefined, undefined],
      ['metal', undefined, [1, 0, 0, 1], 1, 0.25, 0.5],
    ],
  );
  assert.equal('TEXCOORD_1' in json.meshes[0].primitives[0].attributes, false);
  assert.equal(count, was.count);
  atRandomPoints(count, (triangle, weights) => {
    const near = (is, expected, map) =>
      is.forEach((x, d) => {
        assert.ok(Math.abs(x - expected[d]) < NEAR, `${map} ${is} is not ${expected}`);
      });
    if (triangle < 12) {
      near(sample(COLOUR, triangle, weights), was.sample('map_Kd', triangle, weights), COLOUR);
      const glow = was.sample('map_Ke', triangle, weights).slice(0, 3);
      near(glow, sample('emissiveTexture', triangle, weights), 'emissive');
    } else {
      const metal = was.sample('map_Pm', triangle, weights)[0];
      near(sample(ROUGH, triangle, weights), [1, 1, metal], ROUGH);
      const normal = sample('normalTexture', triangle, weights).map((x) => 2 * x - 1);
      assert.ok(Math.abs(Math.hypot(...normal) - 1) < 0.02);
      assert.ok(Math.abs(Math.hypot(normal[0], normal[1]) - 0.393) < 0.02);
    }
  });
  const webp = await objRun(t, files, ...args, '--image-format', 'webp');
  assert.deepEqual(await errorsIn(webp.at('out.glb'), webp.at), []);
});

/** A ball that is red, green and blue by place, from 0 to 255. */
function paintedBall() {
  const { positions, faces } = sphere(8);
  const colours = positions.map((p) => p.map((x) => Math.round(127 * (1 + x))));
  return { positions, faces, colours };
}

const linear = (x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);

/** Text of a PLY; a row of `columns` for each vertex, a list for each face. */
const plyText = (columns, rows, faces, comment = '') =>
  [
    `ply\nformat ascii 1.0${comment}\nelement vertex ${rows.length}`,
    ...columns.map((name) => `property ${/^[xyzst]$/.test(name) ? 'double' : 'uchar'} ${name}`),
    `element face ${faces.length}\nproperty list uchar int vertex_indices\nend_header`,
    ...rows.map((row) => row.join(' ')),
    ...faces.map((face) => [face.length, ...face].join(' ')),
    '',
  ].join('\n');

/** Unwraps a painted file to a GLB, and returns its only image where vertices of triangles are. */
async function bakedImage(t, files, name) {
  const args = ['unwrap', name, '-o', 'out.glb', '--bake', '--bake-resolution', `${SIDE}`];
  const run = await objRun(t, files, ...args);
  assert.deepEqual([run.code, run.stderr], [0, '']);
  assert.deepEqual(await errorsIn(run.at('out.glb'), run.at), []);
  const maps = run.report().baking.maps.map(({ map }) => map);
  assert.deepEqual(maps, ['baseColor']);
  const { sample, json } = samplerOf(readFileSync(run.at('out.glb')));
  assert.equal('COLOR_0' in json.meshes[0].primitives[0].attributes, false);
  return (triangle, weights) => sample(COLOUR, triangle, weights, true);
}

const trianglesOf = (faces) =>
  faces.flatMap((face) => face.slice(2).map((_, i) => [face[0], face[i + 1], face[i + 2]]));

/** Colours of 0 to 255 at the vertices, times a colour, are what an image shows between them. */
function assertPainted(image, triangles, colours, times = [1, 1, 1]) {
  atRandomPoints(triangles.length, (triangle, weights) => {
    const is = image(triangle, weights);
    times.forEach((factor, d) => {
      const wanted = triangles[triangle].reduce(
        (sum, v, k) => sum + weights[k] * factor * linear(colours[v][d] / 255),
        0,
      );
      assert.ok(Math.abs(is[d] - wanted) < NEAR, `${is[d]} is not ${wanted}`);
    });
  });
}

test('colours of the vertices of a PLY or an OBJ become an image of a GLB', async (t) => {
  const { positions, faces, colours } = paintedBall();
  const columns = ['x', 'y', 'z', 'red', 'green', 'blue'];
  const rows = positions.map((p, v) => [...p, ...colours[v]]);
  const obj = [
    ...positions.map((p, v) => ['v', ...p, ...colours[v].map((x) => x / 255)].join(' ')),
    ...faces.map((face) => ['f', ...face.map((v) => v + 1)].join(' ')),
    '',
  ].join('\n');
  for (const [name, text] of [
    ['in.ply', plyText(columns, rows, faces)],
    ['in.obj', obj],
  ])
    assertPainted(await bakedImage(t, { [name]: text }, name), trianglesOf(faces), colours);
});

test('the image of a PLY follows its new layout, with and without colours of vertices', async (t) => {
  const [red, green, blue] = [200, 100, 50];
  const image = { 'skin.png': madePng(32, 32, () => [red, green, blue]) };
  const places = [0, 1, 2].flatMap((y) => [0, 1, 2].map((x) => [x, y]));
  const faces = [0, 1, 3, 4].map((v) => [v, v + 1, v + 4, v + 3]);
  const colours = places.map(([x, y]) => [120 * x, 100 * y, 255]);
  const comment = '\ncomment TextureFile skin.png';
  const placed = ([x, y]) => [x, y, x * y, x / 2, y / 2];
  const columns = ['x', 'y', 'z', 's', 't'];
  const white = places.map(() => [255, 255, 255]);
  const times = [red, green, blue].map((x) => linear(x / 255));
  const plain = plyText(columns, places.map(placed), faces, comment);
  const painted = plyText(
    [...columns, 'red', 'green', 'blue'],
    places.map((place, v) => [...placed(place), ...colours[v]]),
    faces,
    comment,
  );
  for (const [text, own] of [
    [plain, white],
    [painted, colours],
  ]) {
    const found = await bakedImage(t, { 'in.ply': text, ...image }, 'in.ply');
    assertPainted(found, trianglesOf(faces), own, times);
  }
});
