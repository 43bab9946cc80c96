// What unwrap rejects, and its messages.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { sphere } from '../support/surfaces.mjs';
import { bytesOf } from './support/meshes.mjs';
import { arraysOf, assertFails, CUBE } from './support/unwrapping.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat?.terminate());

const REFUSED = [
  [{ untangle: 'best' }, /untangle.*maxStretch/],
  [{ maxStretch: 1 }, /maxStretch must be a number above 1/],
  [{ resolution: 100.5 }, /resolution.*whole/],
  [{ padding: -1 }, /padding/],
  [{ seams: 'everywhere' }, /'everywhere' is not auto, /],
  [{ seams: '' }, /seams/],
  [{ seams: 5 }, /seams must be a string/],
  [{ seams: 'none,auto' }, /none/],
  [{ seamEdges: [0, 1] }, /seamEdges must be a Uint32Array/],
  [{ seamEdges: Uint32Array.of(0, 1, 2) }, /multiple of 2/],
  [{ seamEdges: Uint32Array.of(0, 99) }, /0-99.*99/],
  [{ seamEdges: Uint32Array.of(0, 7) }, /0-7 is not an edge/],
  [{ roundsForGltf: 1 }, /roundsForGltf must be true or false/],
  [{ fixedFaces: [0] }, /fixedFaces must be a Uint32Array/],
  [{ fixedFaces: 'all' }, /fixedFaces must be 'uv' or a Uint32Array/],
  [{ fixedFaces: 'uv' }, /fixedFaces: the mesh has no texcoords to keep/],
  [{ fixedFaces: Uint32Array.of(0) }, /the mesh has no texcoords/],
  [{ udim: true }, /texel density/],
  [{ texelDensity: 0 }, /texelDensity must be a number above 0/],
  [{ obj: 1 }, /obj/],
];

for (const [options, pattern] of REFUSED) {
  test(`the options ${JSON.stringify(options)}: InvalidOption`, async () => {
    await assertFails(abflat, abflat.unwrap(arraysOf(CUBE), options), 'InvalidOption', pattern);
  });
}

test('an atlas that is too small: AtlasTooSmall with what suffices', async () => {
  const mesh = arraysOf(CUBE);
  const options = { texelDensity: 1000, resolution: 256 };
  const error = await abflat.unwrap(mesh, options).catch((e) => e);
  assert.equal(error.code, 'AtlasTooSmall');
  const [, density] = error.message.match(/Lower the density to (\S+), raise/);
  const [, side] = error.message.match(/raise the resolution to (\d+), or/);
  for (const changes of [{ texelDensity: Number(density) }, { resolution: Number(side) }]) {
    const { report } = await abflat.unwrap(mesh, { ...options, ...changes });
    assert.equal(report.valid, true);
    assert.equal(report.atlas.tiles, 1);
  }
});

test('what is no mesh is refused as elsewhere', async () => {
  const mesh = arraysOf(CUBE);
  const noNumber = { ...mesh, positions: mesh.positions.map((x, i) => (i === 7 ? Number.NaN : x)) };
  await assertFails(abflat, abflat.unwrap(noNumber), 'InvalidMesh', /2/);
  await assertFails(
    abflat,
    abflat.unwrap({ ...mesh, indices: new Uint32Array() }),
    'EmptyMesh',
    /face/,
  );
  const bytes = bytesOf('f 1 2 3\n');
  await assertFails(abflat, abflat.unwrap({ bytes, name: 'a.obj' }), 'ParseError', /a\.obj/);
  await assertFails(abflat, abflat.unwrap(undefined), 'InvalidMesh', /positions/);
});

test('lack of memory is said', async () => {
  const small = await createAbflat({ maxMemory: 16 * 2 ** 20 });
  await assert.rejects(small.unwrap(arraysOf(sphere(40))), { code: 'OutOfMemory' });
  assert.equal((await small.unwrap(arraysOf(CUBE))).report.valid, true);
  small.terminate();
});
