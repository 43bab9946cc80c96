// A glTF that is baked into an OBJ, with its materials and images beside it.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { assertSameCubes, CUBE_NAMES, cubeAt, threeCubes } from '../support/baked-cubes.mjs';
import {
  atRandomPoints,
  COLOUR,
  NEAR,
  oneMaterial,
  SIDE,
  turnedPlane,
  waves,
} from '../support/baking.mjs';
import { parseGltf } from '../support/glb.mjs';
import { madePng } from '../support/made-png.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { samplerOf, texturedCube, texturedGlb } from '../support/textured.mjs';
import { directionOfX, objSampler } from '../support/textured-obj.mjs';

/** Runs a command on a GLB in a folder of its own. */
async function bakedObj(t, bytes, command, ...options) {
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), bytes);
  const args = [command, 'in.glb', '-o', 'out.obj', '--report', 'r.json', ...options];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.deepEqual([code, stderr], [0, '']);
  const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  return { at, report, mtl: readFileSync(at('out.mtl'), 'utf8') };
}

test('each map of a glTF is an image of the OBJ, and materials keep their names', async (t) => {
  const before = threeCubes();
  for (const command of ['unwrap', 'pack']) {
    const options = ['--bake', '--bake-resolution', `${SIDE}`];
    const { at, report, mtl } = await bakedObj(t, before, command, ...options);
    assertSameCubes(before, at('out.obj'));
    assert.deepEqual(
      mtl.match(/^newmtl .*$/gm),
      CUBE_NAMES.map((name) => `newmtl ${name}`),
    );
    assert.deepEqual(
      mtl.split('newmtl')[1],
      ' old_metal\nKd 1 1 1\nKs 0.5 0.5 0.5\nNi 1.5\nillum 2\nKe 1 1 1\nd 1\nPr 1\nPm 1\nmap_Kd out-diffuse.png\n' +
        'map_Pr out-roughness.png\nmap_Pm out-metallic.png\nmap_Ke out-emissive.png\n',
    );
    assert.deepEqual(
      report.baking.maps.map(({ map }) => map),
      ['diffuse', 'roughness', 'metallic', 'emissive'],
    );
    assert.ok(report.notes.some((note) => /^occlusion was left out/.test(note)));
    // The normals are those of the file.
    const obj = readFileSync(at('out.obj'), 'utf8');
    assert.equal(obj.match(/^vn /gm).length, 72);
    assert.ok(obj.match(/^f .*$/gm).every((line) => /^f( \d+\/\d+\/\d+){3}$/.test(line)));
  }
});

test('a normal map keeps its direction, and numbers without images are in the material file', async (t) => {
  const before = texturedGlb([turnedPlane(37)], {
    materials: [
      {
        normalTexture: { index: 0 },
        emissiveFactor: [0.2, 0, 1],
        alphaMode: 'BLEND',
        pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 0.25], roughnessFactor: 0.75 },
      },
    ],
    textures: [{ source: 0 }],
    // Tilted along x of the plane.
    images: [madePng(64, 64, () => [200, 128, 232])],
  });
  const { at, mtl } = await bakedObj(t, before, 'bake', '--texcoord', '1');
  const after = objSampler(at('out.obj'));
  const [c, s] = directionOfX(at('out.obj'), 0);
  atRandomPoints(after.count, (t, weights) => {
    const [x, y, z] = after.sample('norm', t, weights).map((value) => 2 * value - 1);
    const [a, , b] = [200, 128, 232].map((value) => value / 127.5 - 1);
    const tilt = a / Math.hypot(a, b);
    assert.ok(Math.hypot(x - c * tilt, y - s * tilt) < 0.03, `${[x, y, z]} is not at ${[c, s]}`);
  });
  assert.match(
    mtl,
    /^Ke 0\.484529 0 1\nd 0\.25\nPr 0\.75\nPm 1\nmap_Bump -bm 1 out-normal\.png\nnorm out-normal\.png$/m,
  );
});

test('only what is transparent takes the alpha of the image', async (t) => {
  const { images, textures, materials } = oneMaterial();
  const [wood] = materials;
  const before = texturedGlb([cubeAt(0, 0), cubeAt(1, 5)], {
    images: [madePng(96, 64, (x, y) => [200, 100, 50, 2 * x + (y % 3)])],
    textures,
    materials: [wood, { ...wood, name: 'leaf', alphaMode: 'BLEND' }],
  });
  assert.equal(images.length, 1);
  const { at, mtl } = await bakedObj(t, before, 'unwrap', '--bake', '--bake-resolution', `${SIDE}`);
  const [, opaque, leaf] = mtl.split('newmtl');
  assert.doesNotMatch(opaque, /map_d/);
  assert.match(leaf, /^map_d out-diffuse\.png$/m);
  const [was, is] = [samplerOf(before), objSampler(at('out.obj'))];
  atRandomPoints(was.count, (t, weights) => {
    const [, , , alpha] = is.sample('map_Kd', t, weights);
    const expected = t < 12 ? 1 : was.sample(COLOUR, t, weights)[3];
    assert.ok(Math.abs(alpha - expected) < NEAR, `${alpha} is not ${expected}`);
  });
});

test('without textures there is a material file; a name that is in use is refused', async (t) => {
  const plain = texturedGlb([texturedCube()], {
    materials: [{ name: 'red', pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 1] } }],
  });
  const { report, mtl } = await bakedObj(t, plain, 'unwrap', '--bake');
  assert.ok(report.notes.some((note) => /^nothing was baked/.test(note)));
  assert.match(mtl, /^newmtl red\nKd 1 0 0\n/);
  const at = tempFolder(t);
  const { json, buffer } = parseGltf(texturedGlb([texturedCube()], oneMaterial()));
  json.buffers = [
    { byteLength: buffer.length, uri: `data:;base64,${Buffer.from(buffer).toString('base64')}` },
  ];
  json.images = [{ uri: 'out-diffuse.png' }];
  writeFileSync(at('in.gltf'), JSON.stringify(json));
  writeFileSync(at('out-diffuse.png'), waves(64));
  const args = ['unwrap', 'in.gltf', '-o', 'out.obj', '--bake'];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.equal(code, 2);
  assert.match(stderr, /--bake would write out-diffuse\.png, which is in use\. Give --output /);
  assert.ok(!existsSync(at('out.obj')) && !existsSync(at('out.mtl')));
});
