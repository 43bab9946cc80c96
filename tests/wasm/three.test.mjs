// The helpers for three.js.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { toBufferGeometry, unwrapGeometry } from 'abflat/three';
import * as THREE from 'three';
import { bytesOf, grid, objText } from './support/meshes.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

test('arrays: positions come from the mesh through vertexMap', async () => {
  const { positions, indices } = grid(5);
  const mesh = {
    positions: Float64Array.from([9, 9, 9, ...positions]),
    indices: indices.map((v) => v + 1),
  };
  const result = await abflat.flatten(mesh);
  const geometry = toBufferGeometry(result, mesh, { normalize: false });
  assert.deepEqual([...geometry.index.array], [...result.indices]);
  assert.deepEqual(geometry.attributes.uv.array, Float32Array.from(result.uv));
  assert.equal(geometry.attributes.uv.itemSize, 2);
  const { array } = geometry.attributes.position;
  result.vertexMap.forEach((vertex, i) => {
    const expected = Float32Array.from(mesh.positions.subarray(3 * vertex, 3 * vertex + 3));
    assert.deepEqual(array.subarray(3 * i, 3 * i + 3), expected);
  });
});

test('files: positions come with the result', async () => {
  const mesh = grid(4);
  const result = await abflat.flatten({ bytes: bytesOf(objText(mesh)), name: 'a.obj' });
  const { position } = toBufferGeometry(result).attributes;
  assert.deepEqual(position.array, Float32Array.from(mesh.positions));
});

/**
 * A band of six quads around a hole; its ends meet in one vertex of the inner rim but not of the
 * outer rim.
 */
function pinchedBand() {
  const at = (radius, degrees) => {
    const angle = (degrees * Math.PI) / 180;
    return [radius * Math.cos(angle), radius * Math.sin(angle), 0];
  };
  const inner = Array.from({ length: 6 }, (_, k) => at(1, 60 * k));
  const outer = Array.from({ length: 7 }, (_, k) => at(2, 55 * k));
  const indices = Array.from({ length: 6 }, (_, k) => {
    const [i, j, o, p] = [k, (k + 1) % 6, 6 + k, 7 + k];
    return [i, o, p, i, p, j];
  });
  return {
    positions: Float64Array.from([...inner, ...outer].flat()),
    indices: Uint32Array.from(indices.flat()),
  };
}

test('a vertex where the surface touches itself is there once for each side', async () => {
  const mesh = pinchedBand();
  // Convex, so the two sides cannot stay together.
  const result = await abflat.flatten(mesh, { t: 1 });
  assert.deepEqual(
    [...result.vertexMap].sort((a, b) => a - b),
    [0, ...Array(13).keys()],
  );
  const { position, uv } = toBufferGeometry(result, mesh).attributes;
  assert.equal(position.count, 14);
  assert.equal(uv.count, 14);
  const [a, b] = [...result.vertexMap.keys()].filter((v) => result.vertexMap[v] === 0);
  assert.deepEqual([position.getX(a), position.getY(a)], [position.getX(b), position.getY(b)]);
  assert.notDeepEqual([uv.getX(a), uv.getY(a)], [uv.getX(b), uv.getY(b)]);
});

test('normalize fits the layout into the unit square without distorting it', async () => {
  const mesh = grid(6);
  const result = await abflat.flatten(mesh);
  const { array } = toBufferGeometry(result, mesh, { normalize: true }).attributes.uv;
  const [us, vs] = [0, 1].map((k) => [...array].filter((_, i) => i % 2 === k));
  const [least, most] = [Math.min(...us, ...vs), Math.max(...us, ...vs)];
  assert.ok(least >= 0 && most <= 1, `${least} to ${most}`);
  assert.equal(most, 1);
  const scale = (array[2] - array[0]) / (result.uv[2] - result.uv[0]);
  array.forEach((value, i) => {
    const expected = array[i % 2] + scale * (result.uv[i] - result.uv[i % 2]);
    assert.ok(Math.abs(value - expected) < 1e-5);
  });
});

test('without a mesh, arrays are refused', async () => {
  const result = await abflat.flatten(grid(2));
  assert.throws(() => toBufferGeometry(result), /mesh/);
});

/** Rows of an attribute, however it is stored. */
const rows = (attribute) =>
  Array.from({ length: attribute.count }, (_, i) =>
    Array.from({ length: attribute.itemSize }, (_, k) => attribute.getComponent(i, k)),
  );

/** Asserts that every corner of every triangle has the attributes that it had. */
function assertSameCorners(after, before, names) {
  const corners = (geometry, attribute) => {
    const values = rows(attribute);
    const { index } = geometry;
    return index ? Array.from(index.array, (v) => values[v]) : values;
  };
  for (const name of names) {
    const [to, from] = [after.getAttribute(name), before.getAttribute(name)];
    assert.equal(to.array.constructor, (from.data ?? from).array.constructor, name);
    assert.equal(to.normalized, from.normalized, name);
    assert.deepEqual(corners(after, to), corners(before, from), name);
  }
  for (const [name, targets] of Object.entries(before.morphAttributes))
    targets.forEach((from, i) => {
      const to = after.morphAttributes[name][i];
      assert.equal(to.name, from.name);
      assert.deepEqual(corners(after, to), corners(before, from), `morph target ${i} of ${name}`);
    });
}

test('unwrapGeometry keeps attributes, morph targets and groups of every corner', async () => {
  const box = new THREE.BoxGeometry(1, 2, 3, 4, 4, 4);
  const { count } = box.attributes.position;
  const skin = Uint16Array.from({ length: 4 * count }, (_, i) => i % 7);
  box.setAttribute('skinIndex', new THREE.BufferAttribute(skin, 4));
  const colors = Uint8Array.from({ length: 4 * count }, (_, i) => (31 * i) % 256);
  box.setAttribute('color', new THREE.BufferAttribute(colors, 4, true));
  const target = box.attributes.position.clone();
  target.array.forEach((x, i) => {
    target.array[i] = 2 * x;
  });
  target.name = 'larger';
  box.morphAttributes.position = [target];
  box.morphTargetsRelative = true;
  box.name = 'a box';
  const before = box.toJSON();
  const { geometry, result } = await unwrapGeometry(abflat, box);
  assert.deepEqual(box.toJSON(), before, 'what goes in stays as it is');
  assert.ok(result.report.valid);
  assertSameCorners(geometry, box, ['position', 'normal', 'skinIndex', 'color']);
  assert.deepEqual(geometry.groups, box.groups);
  assert.equal(geometry.morphTargetsRelative, true);
  assert.equal(geometry.name, 'a box');
  assert.deepEqual(geometry.attributes.uv.array, Float32Array.from(result.uv));
  assert.deepEqual(Float64Array.from(geometry.attributes.uv.array), result.uv, 'as checked');
});

test('unwrapGeometry cuts between groups and round islands when asked to', async () => {
  const ball = new THREE.SphereGeometry(1, 16, 8);
  const half = ball.index.count / 2;
  ball.addGroup(0, half, 0);
  ball.addGroup(half, half, 1);
  const chartsOf = async (geometry, seams) =>
    (await unwrapGeometry(abflat, geometry, { seams })).result.chartOfTriangle;
  const byGroup = await chartsOf(ball, 'material');
  const halves = [byGroup.slice(0, half / 3), byGroup.slice(half / 3)].map((part) => new Set(part));
  assert.ok([...halves[0]].every((chart) => !halves[1].has(chart)));

  const box = new THREE.BoxGeometry(1, 1, 1, 3, 3, 3);
  assert.equal(new Set(await chartsOf(box, 'none')).size, 1);
  // Each side of the box has its own copy of the same coordinates.
  box.attributes.uv.array.forEach((x, i, uv) => {
    uv[i] = x + 2 * Math.floor(i / 32);
  });
  assert.equal(new Set(await chartsOf(box, 'uv')).size, 6);
});

/** The lengths of the longest edge of each triangle without area, on the surface and in uv. */
function longestOfFlat({ index, attributes: { position, uv } }) {
  const longest = (attribute, vertices) => {
    const Point = attribute.itemSize === 2 ? THREE.Vector2 : THREE.Vector3;
    const at = vertices.map((v) => new Point().fromBufferAttribute(attribute, v));
    return Math.max(...at.map((p, k) => p.distanceTo(at[(k + 1) % 3])));
  };
  const triangles = Array.from({ length: index.count / 3 }, (_, f) =>
    [0, 1, 2].map((k) => index.getX(3 * f + k)),
  );
  const isFlat = (vertices) => {
    const at = vertices.map((v) => new THREE.Vector3().fromBufferAttribute(position, v));
    return new THREE.Triangle(...at).getArea() < 1e-12;
  };
  return triangles.filter(isFlat).map((v) => [longest(position, v), longest(uv, v)]);
}

test('unwrapGeometry leaves triangles without area, as at the poles of a capsule, at their neighbours', async () => {
  const profile = [0, 1, 1, 0].map((r, k) => new THREE.Vector2(r, k));
  const shapes = [
    new THREE.CapsuleGeometry(),
    new THREE.CapsuleGeometry(1, 1, 4, 48),
    new THREE.LatheGeometry(profile, 32),
  ];
  for (const shape of shapes) {
    const { geometry, result } = await unwrapGeometry(abflat, shape);
    const { atlas, valid } = result.report;
    assert.ok(valid);
    const lengths = longestOfFlat(geometry);
    assert.ok(lengths.length > 0);
    const perUnit = atlas.texelDensity / atlas.resolution;
    for (const [onSurface, inUv] of lengths) assert.ok(inUv < 1.5 * perUnit * onSurface);
  }
});

test('unwrapGeometry puts a second set of coordinates beside the first', async () => {
  const torus = new THREE.TorusGeometry(1, 0.4, 8, 16);
  const { geometry } = await unwrapGeometry(abflat, torus, { attribute: 'uv1', maxStretch: 1.2 });
  assertSameCorners(geometry, torus, ['position', 'normal', 'uv']);
  const { uv1 } = geometry.attributes;
  assert.equal(uv1.itemSize, 2);
  assert.ok(uv1.array.every((x) => x >= 0 && x <= 1));
});

test('unwrapGeometry takes geometry without an index, and interleaved attributes', async () => {
  const soup = new THREE.IcosahedronGeometry(1, 2);
  assert.equal(soup.index, null);
  const whole = await unwrapGeometry(abflat, soup, { seams: 'none' });
  assertSameCorners(whole.geometry, soup, ['position', 'normal']);
  assert.equal(whole.result.report.charts.length, 1, 'joined by position');

  const data = new Float32Array(8 * soup.attributes.position.count);
  rows(soup.attributes.position).forEach((p, i) => {
    data.set([...p, 0.5 * i, ...p.map((x) => -x)], 8 * i);
  });
  const buffer = new THREE.InterleavedBuffer(data, 8);
  const mixed = new THREE.BufferGeometry();
  mixed.setAttribute('position', new THREE.InterleavedBufferAttribute(buffer, 3, 0));
  mixed.setAttribute('weight', new THREE.InterleavedBufferAttribute(buffer, 1, 3));
  mixed.setAttribute('normal', new THREE.InterleavedBufferAttribute(buffer, 3, 4));
  const { geometry } = await unwrapGeometry(abflat, mixed, { seams: 'none' });
  assertSameCorners(geometry, mixed, ['position', 'weight', 'normal']);
  assert.deepEqual(geometry.attributes.uv.array, whole.geometry.attributes.uv.array);
});

test('unwrapGeometry refuses geometry without positions, and says what is wrong with others', async () => {
  await assert.rejects(unwrapGeometry(abflat, new THREE.BufferGeometry()), /position/);
  const box = new THREE.BoxGeometry();
  await assert.rejects(unwrapGeometry(abflat, new THREE.Mesh(box)), /mesh\.geometry/);
  await assert.rejects(unwrapGeometry(createAbflat(), box), /await createAbflat/);
  await assert.rejects(unwrapGeometry(abflat, box, { attribute: 1 }), { code: 'InvalidOption' });
  for (const mesh of [box, new THREE.Mesh(box)])
    await assert.rejects(
      abflat.unwrap(mesh),
      /no positions.*unwrapGeometry, packGeometry or verifyGeometry of "abflat\/three"/,
    );
  await assert.rejects(unwrapGeometry(abflat, box, { maxStretch: 0 }), { code: 'InvalidOption' });
  box.attributes.position.array[4] = Number.NaN;
  await assert.rejects(unwrapGeometry(abflat, box), { code: 'InvalidMesh' });
});

test('toBufferGeometry shades seams as the surface that they are', async () => {
  const mesh = new THREE.IcosahedronGeometry(1, 3);
  const positions = mesh.attributes.position.array;
  const indices = Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
  const keys = Array.from(indices, (v) => positions.subarray(3 * v, 3 * v + 3).join());
  const input = { positions, indices: indices.map((v) => keys.indexOf(keys[v])) };
  const result = await abflat.unwrap(input);
  const { normal, position } = toBufferGeometry(result, input).attributes;
  const points = rows(position);
  rows(normal).forEach((n, i) => {
    const p = points[i];
    assert.ok(n[0] * p[0] + n[1] * p[1] + n[2] * p[2] > 0.98, `vertex ${i}`);
  });
});

test('unwrapGeometry keeps instances: their number, and attributes with a row for each', async () => {
  const box = new THREE.InstancedBufferGeometry().copy(new THREE.BoxGeometry());
  box.instanceCount = 5;
  const offsets = Float32Array.from({ length: 15 }, (_, i) => i);
  box.setAttribute('offset', new THREE.InstancedBufferAttribute(offsets, 3));
  const buffer = new THREE.InstancedInterleavedBuffer(new Float32Array(20).fill(0.5), 4, 2);
  box.setAttribute('tint', new THREE.InterleavedBufferAttribute(buffer, 4, 0));
  const { geometry } = await unwrapGeometry(abflat, box);
  assert.ok(geometry.isInstancedBufferGeometry);
  assert.equal(geometry.instanceCount, 5);
  const { offset, tint } = geometry.attributes;
  assert.ok(offset.isInstancedBufferAttribute);
  assert.deepEqual(rows(offset), rows(box.attributes.offset));
  assert.ok(tint.data.isInstancedInterleavedBuffer);
  assert.deepEqual([tint.count, tint.data.meshPerAttribute], [5, 2]);
  assertSameCorners(geometry, box, ['position', 'normal']);
});

test('unwrapGeometry takes userData of any kind along', async () => {
  const box = new THREE.BoxGeometry();
  const onClick = () => 'clicked';
  box.userData = { onClick, tags: ['a'] };
  const { geometry } = await unwrapGeometry(abflat, box);
  assert.equal(geometry.userData.onClick, onClick);
  geometry.userData.more = true;
  assert.equal(box.userData.more, undefined);
});

test('unwrapGeometry takes half floats, points of a plane and indices that are left over as they are drawn', async () => {
  const plane = new THREE.PlaneGeometry(2, 1, 4, 4);
  const wanted = (await unwrapGeometry(abflat, plane)).result.uv;
  const { count } = plane.attributes.position;
  const half = new THREE.Float16BufferAttribute(new Uint16Array(3 * count), 3);
  const flat = new THREE.BufferAttribute(new Float32Array(2 * count), 2);
  for (const [i, [x, y, z]] of rows(plane.attributes.position).entries()) {
    half.setXYZ(i, x, y, z);
    flat.setXY(i, x, y);
  }
  for (const position of [half, flat]) {
    const other = plane.clone().setAttribute('position', position);
    other.setIndex([...plane.index.array, 0, 1]);
    const { geometry, result } = await unwrapGeometry(abflat, other);
    assert.deepEqual(result.uv, wanted);
    const made = geometry.attributes.position;
    assert.equal(made.isFloat16BufferAttribute, position.isFloat16BufferAttribute);
    assert.equal(made.getX(7), position.getX(result.vertexMap[7]));
    assert.equal(geometry.index.count, plane.index.count);
  }
});

test('unwrapGeometry takes what a BatchedMesh holds', async () => {
  const batch = new THREE.BatchedMesh(2, 200, 1000);
  batch.addGeometry(new THREE.BoxGeometry());
  batch.addGeometry(new THREE.SphereGeometry(1, 8, 6).translate(3, 0, 0));
  const { result } = await unwrapGeometry(abflat, batch.geometry);
  assert.ok(result.report.valid);
  assert.equal(result.indices.length, 999);
});

/** A box whose `name` is a layout of its first side alone, in a corner of the square. */
function withFirstSide(name) {
  const box = new THREE.BoxGeometry();
  const uv = new Float32Array(2 * box.attributes.position.count).fill(Number.NaN);
  uv.set([0.1, 0.3, 0.3, 0.3, 0.1, 0.1, 0.3, 0.1]);
  return box.setAttribute(name, new THREE.BufferAttribute(uv, 2));
}

test('fixedFaces keeps what is in the attribute that is written, or in the one that is named', async () => {
  for (const options of [
    { attribute: 'uv1' },
    { readAttribute: 'uv1' },
    { attribute: 'uv2', readAttribute: 'uv1' },
    { preset: 'lightmap' },
  ]) {
    const box = withFirstSide('uv1');
    const { geometry, result } = await unwrapGeometry(abflat, box, {
      ...options,
      fixedFaces: 'uv',
    });
    assert.ok(result.report.valid);
    const isFixed = (chart) => result.report.charts[chart].fixed;
    assert.equal([...result.chartOfTriangle].filter(isFixed).length, 2);
    const written = geometry.attributes[options.attribute ?? 'uv1'];
    const kept = rows(written).slice(0, 4);
    assert.deepEqual(kept, rows(box.attributes.uv1).slice(0, 4), JSON.stringify(options));
    assert.deepEqual(geometry.attributes.uv.array.slice(0, 8), box.attributes.uv.array.slice(0, 8));
  }
  const plain = new THREE.BoxGeometry();
  await assert.rejects(
    unwrapGeometry(abflat, plain, { attribute: 'uv1', fixedFaces: 'uv' }),
    ({ code, message }) => code === 'NoTexcoords' && /no attribute uv1/.test(message),
  );
});

test('seams follow the islands of the attribute that is named', async () => {
  const box = new THREE.BoxGeometry();
  box.setAttribute('uv1', box.attributes.uv);
  box.deleteAttribute('uv');
  const options = { seams: 'uv', readAttribute: 'uv1' };
  const { geometry, result } = await unwrapGeometry(abflat, box, options);
  assert.equal(result.report.charts.length, 6);
  assert.ok(geometry.attributes.uv);
});

test('preset: what is set holds, the rest is for light maps', async () => {
  const settings = async (options) => {
    const sphere = new THREE.SphereGeometry(1, 8, 6);
    const { geometry, result } = await unwrapGeometry(abflat, sphere, options);
    const { rotate, padding, snapToTexels } = result.report.options;
    return [geometry.attributes.uv1 !== undefined, rotate, padding, snapToTexels];
  };
  assert.deepEqual(await settings({}), [false, 'auto', 2, false]);
  assert.deepEqual(await settings({ preset: 'lightmap' }), [true, 'quarter', 5, true]);
  assert.deepEqual(await settings({ preset: 'lightmap', mipLevels: 3 }), [
    true,
    'quarter',
    23,
    true,
  ]);
  const own = { attribute: 'uv', rotate: 'none', padding: 9, snapToTexels: false };
  assert.deepEqual(await settings({ preset: 'lightmap', ...own }), [false, 'none', 9, false]);
});
