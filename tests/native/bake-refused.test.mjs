// What cannot be baked is refused in a sentence.

import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { oneMaterial, refused, waves } from '../support/baking.mjs';
import { greyPng } from '../support/made-png.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { CUBE } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { texturedCube, texturedGlb } from '../support/textured.mjs';

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
  assert.match(
    (await refused(t, strange, ...unwrap()))[1],
    /images\[0\] is a KTX2 texture, .* Convert it to PNG, such as with 'ktx extract'/,
  );
  assert.deepEqual(await refused(t, good, 'unwrap', 'in.glb', '-o', 'out.ply', '--bake'), [
    2,
    'abflat: --output: must end in .glb, .gltf or .obj: no other format holds new images. This is out.ply.',
  ]);
  assert.deepEqual(await refused(t, good, 'unwrap', 'in.glb', '-o', '-', '--bake'), [
    2,
    'abflat: --output: must be a file: the new images are written beside it.',
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
  writeFileSync(
    at('in.ply'),
    'ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n',
  );
  writeFileSync(at('in.off'), 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n');
  for (const [args, sentence] of [
    [
      ['bake', 'in.obj', '-o', 'out.obj'],
      'in.obj has only one layout. Use unwrap --bake or pack --bake.',
    ],
    [
      ['unwrap', 'in.off', '-o', 'out.obj', '--bake'],
      'in.off is OFF. Only a glTF, an OBJ or a PLY can be baked.',
    ],
    [
      ['unwrap', 'in.ply', '-o', 'out.obj', '--bake'],
      'in.ply is a PLY. It can only be baked into a .glb or .gltf; give --output such a name.',
    ],
  ]) {
    const { code, stderr } = await runAbflat(args, { cwd: at() });
    assert.deepEqual([code, stderr], [2, `abflat: ${sentence}\n`]);
  }
});
