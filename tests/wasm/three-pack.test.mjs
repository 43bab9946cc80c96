// packGeometry: the layout of a three.js geometry, packed again.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { packGeometry } from 'abflat/three';
import * as THREE from 'three';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

test('a box, whose sides lie on each other, keeps vertices, index, groups and other attributes', async () => {
  const box = new THREE.BoxGeometry(1, 2, 3);
  const { geometry, result } = await packGeometry(abflat, box, { padding: 4 });
  assert.equal(result.report.valid, true);
  assert.equal(result.report.stacked.islands, 5);
  for (const name of ['position', 'normal'])
    assert.deepEqual(geometry.attributes[name].array, box.attributes[name].array);
  assert.deepEqual([...geometry.index.array], [...box.index.array]);
  assert.deepEqual(geometry.groups, box.groups);
  assert.deepEqual(geometry.attributes.uv.array, Float32Array.from(result.uv));
  assert.notDeepEqual(geometry.attributes.uv.array, box.attributes.uv.array);
});

test('attributes to read and to write have names; without a layout there is nothing to pack', async () => {
  const plane = new THREE.PlaneGeometry(1, 1);
  plane.setAttribute('uv1', plane.attributes.uv.clone());
  plane.attributes.uv1.array.forEach((x, i, all) => {
    all[i] = x * 5 - 2;
  });
  const inPlace = await packGeometry(abflat, plane, { readAttribute: 'uv1' });
  assert.deepEqual(inPlace.geometry.attributes.uv.array, plane.attributes.uv.array);
  const { array } = inPlace.geometry.attributes.uv1;
  assert.ok(array.every((x) => x >= 0 && x <= 1));
  const beside = await packGeometry(abflat, plane, { readAttribute: 'uv1', attribute: 'uv2' });
  assert.deepEqual(beside.geometry.attributes.uv2.array, array);
  assert.deepEqual(beside.geometry.attributes.uv1.array, plane.attributes.uv1.array);
  await assert.rejects(packGeometry(abflat, plane, { readAttribute: 'uv3' }), {
    code: 'NoTexcoords',
  });
  await assert.rejects(packGeometry(abflat, plane, { readAttribute: 1 }), {
    code: 'InvalidOption',
  });
  await assert.rejects(packGeometry(createAbflat(), plane), /await createAbflat/);
  await assert.rejects(packGeometry(abflat, new THREE.Mesh(plane)), /packGeometry.*mesh\.geometry/);
});
