// glTF-Transform's `unwrap` with the layouts of abflat in place of those of watlas: what its own
// tests ask for, and layouts of many documents judged by the numbers in their files.

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { unweld, unwrap, unwrapPrimitives } from '@gltf-transform/functions';
import * as watlas from 'abflat/watlas';
import {
  accessor,
  addMesh,
  assertValidFile,
  emptyDocument,
  io,
  positionsOf,
  primitivesOf,
  reread,
} from '../support/gltf.mjs';
import { ordinaryShapes } from '../support/ordinary-shapes.mjs';
import { richGltf } from '../support/rich-gltf.mjs';
import {
  boxArray,
  isosurface,
  kleinBottle,
  knot,
  moebius,
  plate,
  sphere,
  torus,
  triangleSoup,
  tube,
  unwelded,
  windows,
} from '../support/surfaces.mjs';
import {
  assertLaidOut,
  corners,
  knotPrimitive,
  scaleRows,
  uvArea,
  uvTriangles,
} from './support/watlas.mjs';

before(() => watlas.Initialize());

function withKnot(document = emptyDocument()) {
  const primitive = knotPrimitive(document, 6);
  addMesh(document, 'knot', primitive);
  return { document, primitive };
}

test('a primitive without indices gets some, if it is unwrapped', async () => {
  const { document, primitive } = withKnot();
  await document.transform(unweld());
  assert.equal(primitive.getIndices(), null);
  unwrapPrimitives([primitive], { watlas, overwrite: false });
  assert.equal(primitive.getIndices(), null);
  unwrapPrimitives([primitive], { watlas, overwrite: true });
  assert.ok(primitive.getIndices());
});

test('as many indices as before, and no vertex that is not used', () => {
  const { primitive } = withKnot();
  const indices = primitive.getIndices().getCount();
  const vertices = primitive.getAttribute('POSITION').getCount();
  assert.equal(vertices, 63);
  unwrapPrimitives([primitive], { watlas, overwrite: true });
  assert.equal(primitive.getIndices().getCount(), indices);
  const after = primitive.getAttribute('POSITION').getCount();
  // watlas makes more than 100.
  assert.ok(after < 150, `${after}`);
  assert.equal(new Set(corners(primitive)).size, after);
});

test('the set asked for is written, and lower ones are there', () => {
  const { primitive } = withKnot();
  const has = (set) => primitive.getAttribute(`TEXCOORD_${set}`);
  const first = has(0);
  assert.deepEqual([has(1), has(2), has(3)], [null, null, null]);
  unwrapPrimitives([primitive], { watlas, texcoord: 1 });
  assert.ok(has(0) && has(1));
  assert.equal(has(3), null);
  assert.notDeepEqual(has(0).getArray(), has(1).getArray());
  unwrapPrimitives([primitive], { watlas, texcoord: 2 });
  assert.ok(has(0) && has(1) && has(2));
  assert.notDeepEqual(has(1).getArray(), has(2).getArray());
  assert.ok(first);
});

/** Rounded to thousandths. */
function bounds(attribute) {
  const array = attribute.getArray();
  const range = (axis) => {
    const values = array.filter((_, i) => i % 2 === axis);
    return [Math.min(...values), Math.max(...values)].map((x) => Math.round(1000 * x) / 1000);
  };
  return [range(0), range(1)];
}

test('a set that is there is replaced only with overwrite', () => {
  const { primitive } = withKnot();
  const a = primitive.getAttribute('TEXCOORD_0');
  const b = a.clone();
  primitive.setAttribute('TEXCOORD_1', b);
  scaleRows(a, 2);
  scaleRows(b, 0.5);
  const [boundsA, boundsB] = [bounds(a), bounds(b)];
  unwrapPrimitives([primitive], { watlas, texcoord: 1, overwrite: false });
  assert.equal(primitive.getAttribute('TEXCOORD_0'), a);
  assert.equal(primitive.getAttribute('TEXCOORD_1'), b);
  assert.deepEqual([bounds(a), bounds(b)], [boundsA, boundsB]);
  unwrapPrimitives([primitive], { watlas, texcoord: 1, overwrite: true });
  assert.deepEqual(bounds(primitive.getAttribute('TEXCOORD_0')), boundsA);
  for (const [least, most] of bounds(primitive.getAttribute('TEXCOORD_1')))
    assert.ok(least >= 0 && most <= 1 && most - least > 0.8, `${least} ${most}`);
});

/** Two meshes, of two primitives and of one, in sizes of 10, 5 and 0.5. */
function ofSizes() {
  const document = emptyDocument();
  const [a, b, c] = [6, 7, 8].map((segments) => knotPrimitive(document, segments));
  addMesh(document, 'A', a, b);
  addMesh(document, 'B', c);
  for (const [primitive, size] of [
    [a, 10],
    [b, 5],
    [c, 0.5],
  ]) {
    scaleRows(primitive.getAttribute('POSITION'), size);
    primitive.setAttribute('TEXCOORD_0', null);
  }
  return { document, all: [a, b, c] };
}

/** What glTF-Transform asks of the areas; those at the upper end may be larger here. */
const AREAS = {
  primitive: [
    [0.4, 1],
    [0.4, 1],
    [0.4, 1],
  ],
  mesh: [
    [0.3, 1],
    [0.05, 0.25],
    [0.4, 1],
  ],
  scene: [
    [0.3, 1],
    [0.05, 0.25],
    [0, 0.01],
  ],
};
for (const [groupBy, wanted] of Object.entries(AREAS))
  test(`groupBy: ${groupBy}`, async () => {
    const { document, all } = ofSizes();
    await document.transform(unwrap({ watlas, groupBy, overwrite: true }));
    const areas = all.map((primitive) => uvArea(primitive));
    for (const [i, [least, most]] of wanted.entries())
      assert.ok(areas[i] > least && areas[i] < most, `${areas}`);
    const groups = {
      primitive: all.map((each) => [each]),
      mesh: [all.slice(0, 2), all.slice(2)],
      scene: [all],
    };
    for (const group of groups[groupBy])
      assertLaidOut(group.flatMap((primitive) => uvTriangles(primitive)));
  });

test('groupBy: scene, with nodes that scale their meshes', async () => {
  const document = emptyDocument();
  const all = [6, 7, 8].map((segments) => knotPrimitive(document, segments));
  const large = addMesh(document, 'A', all[0], all[1]);
  const small = addMesh(document, 'B', all[2]);
  large.node.setScale([10, 10, 10]);
  small.node.setScale([0.5, 0.5, 0.5]);
  for (const primitive of all) primitive.setAttribute('TEXCOORD_0', null);
  await document.transform(unwrap({ watlas, groupBy: 'scene', overwrite: true }));
  const [a, b, c] = all.map((primitive) => uvArea(primitive));
  assert.ok(a > 0.2 && b > 0.2 && c > 0 && c < 0.01, `${[a, b, c]}`);
});

/** A document of surfaces, each a mesh; `more` changes them. */
function documentOf(...surfaces) {
  const document = emptyDocument();
  for (const [i, surface] of surfaces.entries()) {
    const Kind = surface.positions.length > 65535 ? Uint32Array : Uint16Array;
    const fans = surface.faces.flatMap((face) =>
      face.slice(2).flatMap((c, k) => [face[0], face[k + 1], c]),
    );
    addMesh(
      document,
      `${i}`,
      document
        .createPrimitive()
        .setAttribute('POSITION', positionsOf(document, surface))
        .setIndices(accessor(document, 'SCALAR', Kind.from(fans))),
    );
  }
  return document;
}

const SURFACES = {
  sphere: [sphere(8)],
  torus: [torus(24, 12)],
  knot: [knot(60, 8)],
  Moebius: [moebius()],
  'Klein bottle': [kleinBottle(24, 12)],
  boxes: [boxArray(2)],
  isosurface: [isosurface(7)],
  tube: [tube(8)],
  windows: [windows(3)],
  plate: [plate(2, 4)],
  soup: [triangleSoup(60)],
  'loose triangles': [unwelded(sphere(5))],
  'several meshes': [sphere(4), torus(12, 6), moebius(20, 3), knot(30, 6)],
  'the same mesh thrice': [torus(12, 6), torus(12, 6), torus(12, 6)],
};
const DOCUMENTS = {
  ...Object.fromEntries(
    Object.entries(SURFACES).map(([name, surfaces]) => [name, () => documentOf(...surfaces)]),
  ),
  ...Object.fromEntries(
    ordinaryShapes()
      .slice(0, 8)
      .map(({ name, points, faces }) => [name, () => documentOf({ positions: points, faces })]),
  ),
};
for (const [name, make] of Object.entries(DOCUMENTS))
  test(`${name}: no triangle is flipped, and none overlap`, async () => {
    const document = await io.readBinary(await io.writeBinary(make()));
    const before = primitivesOf(document).map((primitive) => ({
      at: corners(primitive),
      positions: primitive.getAttribute('POSITION').getArray().slice(),
    }));
    await document.transform(unwrap({ watlas, groupBy: 'scene' }));
    await assertValidFile(document);
    const primitives = primitivesOf(await reread(document));
    assertLaidOut(primitives.flatMap((primitive) => uvTriangles(primitive)));
    for (const [i, primitive] of primitives.entries()) {
      const positions = primitive.getAttribute('POSITION').getArray();
      const place = (array, vertex) => [...array.subarray(3 * vertex, 3 * vertex + 3)];
      assert.deepEqual(
        corners(primitive).map((vertex) => place(positions, vertex)),
        before[i].at.map((vertex) => place(before[i].positions, vertex)),
        'faces in their order',
      );
    }
  });

test('a document with skins, morph targets and sets of its own', async () => {
  const document = await io.readBinary(richGltf({ uv: false }).glb());
  // glTF-Transform takes lists of triangles only.
  for (const primitive of primitivesOf(document))
    if (primitive.getMode() !== 4) primitive.dispose();
  for (const mesh of document.getRoot().listMeshes())
    if (mesh.listPrimitives().length === 0) mesh.dispose();
  for (const groupBy of ['mesh', 'scene']) {
    await document.transform(unwrap({ watlas, groupBy, overwrite: true }));
    const primitives = primitivesOf(document);
    assert.ok(primitives.length >= 3);
    const groups = groupBy === 'scene' ? [primitives] : [];
    for (const mesh of document.getRoot().listMeshes())
      if (groupBy === 'mesh') groups.push(mesh.listPrimitives());
    for (const group of groups)
      assertLaidOut(
        group.flatMap((primitive) => uvTriangles(primitive)),
        groupBy,
      );
  }
});
