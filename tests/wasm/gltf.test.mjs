// glTF-Transform documents get an atlas, and everything else in them stays.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { KHRMeshQuantization } from '@gltf-transform/extensions';
import { createAbflat } from 'abflat';
import { documentMesh, unwrap } from 'abflat/gltf';
import {
  accessor,
  addMesh,
  assertValidFile,
  atlasOf,
  emptyDocument,
  flaws,
  indicesOf,
  positionsOf,
  primitiveOf,
  primitivesOf,
  randomRows,
} from '../support/gltf.mjs';
import { sphere, torus } from '../support/surfaces.mjs';
import { character, rowsOf } from './support/character.mjs';
import { unwrapDocument } from './support/unwrap-document.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

const unwrapped = (document, options) => unwrapDocument(abflat, document, options);

const kindOf = (accessor) => accessor.getArray().constructor;

test('skin weights, colours, morph targets and further sets stay with every corner', async () => {
  const { after, atlases } = await unwrapped(character());
  assert.equal(atlases.length, 1);
  const [a, b] = primitivesOf(after);
  assert.equal(kindOf(a.getAttribute('TEXCOORD_0')), Float32Array);
  assert.equal(kindOf(a.getIndices()), Uint16Array);
  assert.equal(after.getRoot().listSkins().length, 1);
  // A ring with two materials is one surface: seams are where charts end, not where a material
  // does.
  const cut = atlases[0].result.seams.length / 2;
  assert.ok(cut > 0);
  assert.ok(rowsOf(a) - 24 * 12 < 2 * cut && rowsOf(b) - 24 * 12 < 2 * cut);
});

test('a skin makes the node’s place count for nothing', async () => {
  const [document, plain] = [character(), character()];
  plain.getRoot().listNodes()[0].setScale([1, 1, 1]);
  assert.deepEqual(documentMesh(document).positions, documentMesh(plain).positions);
  plain.getRoot().listNodes()[0].setSkin(null).setScale([5, 1, 1]);
  assert.notDeepEqual(documentMesh(document).positions, documentMesh(plain).positions);
});

test('another set: those before stay, and a gap is filled', async () => {
  const document = character();
  const { after, before } = await unwrapped(document, { texcoord: 1 });
  assert.deepEqual(
    primitivesOf(after)[0].listSemantics().sort(),
    primitivesOf(before)[0].listSemantics().sort(),
  );
  const bare = emptyDocument();
  addMesh(bare, 'ball', primitiveOf(bare, sphere(6)));
  const [primitive] = primitivesOf((await unwrapped(bare, { texcoord: 2 })).after);
  const sets = [0, 1, 2].map((i) => primitive.getAttribute(`TEXCOORD_${i}`).getArray());
  assert.deepEqual(sets[0], sets[2]);
  assert.deepEqual(sets[1], sets[2]);
});

test('primitives with the same accessors go on sharing them', async () => {
  const document = emptyDocument();
  const ball = sphere(8);
  const { length } = ball.faces;
  const position = positionsOf(document, ball);
  const color = randomRows(document, 'VEC3', Uint8Array, position.getCount(), { normalized: true });
  const halves = [ball.faces.slice(0, length / 2), ball.faces.slice(length / 2)];
  const primitives = halves.map((faces) =>
    document
      .createPrimitive()
      .setAttribute('POSITION', position)
      .setAttribute('COLOR_0', color)
      .setIndices(accessor(document, 'SCALAR', Uint16Array.from(indicesOf({ faces })))),
  );
  addMesh(document, 'ball', ...primitives);
  const { after, atlases } = await unwrapped(document);
  assert.equal(atlases.length, 1);
  const [a, b] = primitivesOf(after);
  for (const name of ['POSITION', 'COLOR_0', 'TEXCOORD_0'])
    assert.equal(a.getAttribute(name), b.getAttribute(name), name);
  // Nothing that was replaced is left behind: two indices and three attributes.
  assert.equal(document.getRoot().listAccessors().length, 5);
});

test('one mesh at two places shares a layout; one set of positions at two places does not', async () => {
  const document = emptyDocument();
  const { mesh } = addMesh(document, 'ring', primitiveOf(document, torus(16, 8)));
  const again = document.createNode('again').setMesh(mesh).setTranslation([5, 0, 0]);
  document.getRoot().listScenes()[0].addChild(again);
  const instances = await unwrapped(document);
  assert.equal(instances.atlases[0].parts.length, 1);
  assert.equal(instances.after.getRoot().listNodes().length, 2);

  const copy = document
    .createPrimitive()
    .setAttribute('POSITION', primitivesOf(document)[0].getAttribute('POSITION'))
    .setIndices(primitivesOf(document)[0].getIndices());
  addMesh(document, 'other', copy).node.setTranslation([0, 9, 0]);
  const { after } = await unwrapped(document);
  const [a, b] = primitivesOf(after);
  assert.notEqual(a.getAttribute('TEXCOORD_0'), b.getAttribute('TEXCOORD_0'));
});

test('sizes are those of the scene', async () => {
  const document = emptyDocument();
  const nodes = [1, 3].map((scale, i) =>
    addMesh(document, `ball ${i}`, primitiveOf(document, sphere(6)))
      .node.setScale([scale, scale, scale])
      .setTranslation([10 * i, 0, 0]),
  );
  // Scaled only through its parent.
  const parent = document.createNode('parent').setScale([2, 2, 2]).addChild(nodes[0]);
  document.getRoot().listScenes()[0].addChild(parent);
  const { after } = await unwrapped(document);
  const [small, large] = primitivesOf(after).map((primitive) =>
    atlasOf([primitive])
      .map(([a, b, c]) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
      .reduce((sum, area) => sum + area, 0),
  );
  assert.ok(Math.abs(large / small - (3 / 2) ** 2) < 0.05, `${large / small}`);
});

test('a node that mirrors: the other half of a body is not seen from behind, and stays one of two', async () => {
  const document = emptyDocument();
  const bowl = torus(16, 8);
  const half = bowl.faces.filter((face) => face.every((v) => bowl.positions[v][0] > -1e-9));
  const primitives = [1, -1].map((side) => {
    const primitive = primitiveOf(document, { ...bowl, faces: half });
    addMesh(document, `side ${side}`, primitive).node.setScale([side, 1, 1]);
    return primitive;
  });
  const { atlases } = await unwrapped(document, {
    isMirrored: (primitive) => primitive === primitives[1],
  });
  assert.deepEqual(
    atlases[0].parts.map(({ isMirrored }) => isMirrored),
    [false, true],
  );
  assert.deepEqual(atlases[0].result.report.repair.orientationConflicts, []);
  assert.equal(atlases[0].result.report.seams.genus, 0, 'the halves do not make a ring');
});

test('of several nodes the one that makes the mesh largest counts, and a note says that they share', async () => {
  const sizes = [1, 3, 2];
  for (const order of [
    [0, 1, 2],
    [1, 2, 0],
  ]) {
    const document = emptyDocument();
    const { mesh, node } = addMesh(document, 'ball', primitiveOf(document, sphere(4)));
    addMesh(document, 'other', primitiveOf(document, sphere(4))).node.setTranslation([50, 0, 0]);
    node.setScale(Array(3).fill(sizes[order[0]]));
    for (const i of order.slice(1))
      document
        .getRoot()
        .listScenes()[0]
        .addChild(document.createNode().setMesh(mesh).setScale(Array(3).fill(sizes[i])));
    const { positions, notes } = documentMesh(document);
    assert.ok(Math.abs(Math.max(...positions.subarray(0, positions.length / 2)) - 3) < 0.3);
    assert.deepEqual(notes, [
      '3 nodes share 1 mesh and its texels. Their scales differ, so each layout is sized for the largest node',
    ]);
    const { atlases } = await unwrapped(document);
    assert.deepEqual(atlases[0].result.report.notes.slice(0, 1), [
      `${notes[0]}. With the option ownTexels each node gets texels of its own`,
    ]);
  }
  const document = emptyDocument();
  addMesh(document, 'ball', primitiveOf(document, sphere(4)));
  assert.deepEqual(documentMesh(document).notes, []);
});

test('orient turns triangles in the document, mirrored or not', async () => {
  for (const scale of [1, -1]) {
    const document = emptyDocument();
    const ring = torus(16, 8);
    const faces = ring.faces.map(([a, b, c], f) => (f % 3 === 1 ? [a, c, b] : [a, b, c]));
    addMesh(document, 'ring', primitiveOf(document, { ...ring, faces })).node.setScale([
      scale,
      1,
      1,
    ]);
    const [primitive] = primitivesOf(document);
    const points = [...primitive.getAttribute('POSITION').getArray()];
    const atlases = [];
    await document.transform(
      unwrap(abflat, { orient: true, onAtlas: (atlas) => atlases.push(atlas) }),
    );
    await assertValidFile(document);
    assert.deepEqual(
      atlases[0].result.report.repair.turnedFaces,
      faces.map((_, f) => f).filter((f) => f % 3 === 1),
    );
    assert.deepEqual(
      [...primitive.getAttribute('POSITION').getArray()].slice(0, points.length),
      points,
    );
    const places = (indices, of) => [...indices].map((v) => `${of.slice(3 * v, 3 * v + 3)}`);
    assert.deepEqual(
      places(primitive.getIndices().getArray(), primitive.getAttribute('POSITION').getArray()),
      places(indicesOf(ring), points),
    );
    assert.deepEqual(flaws(atlasOf([primitive], { isMirrored: () => scale < 0 })), []);
  }
});

test('a node without extent does not count', async () => {
  const document = emptyDocument();
  const { mesh, node } = addMesh(document, 'ball', primitiveOf(document, sphere(4)));
  node.setScale([0, 0, 0]);
  const seen = document.createNode('seen').setMesh(mesh).setScale([2, 2, 2]);
  document.getRoot().listScenes()[0].addChild(seen);
  const { positions } = documentMesh(document);
  assert.ok(Math.abs(Math.max(...positions) - 2) < 0.2);
  await unwrapped(document);
});

test('quantised positions, and indices that grow no more than they must', async () => {
  const document = emptyDocument();
  document.createExtension(KHRMeshQuantization).setRequired(true);
  const ball = sphere(6);
  const steps = Int16Array.from(ball.positions.flat(), (x) => Math.round(32767 * x));
  const quantised = document
    .createPrimitive()
    .setAttribute('POSITION', accessor(document, 'VEC3', steps, true))
    .setIndices(accessor(document, 'SCALAR', Uint8Array.from(indicesOf(ball))));
  addMesh(document, 'quantised', quantised);
  const few = rowsOf(quantised);
  const { after } = await unwrapped(document);
  const [primitive] = primitivesOf(after);
  assert.equal(kindOf(primitive.getAttribute('POSITION')), Int16Array);
  assert.ok(few <= 255);
  assert.equal(kindOf(primitive.getIndices()), rowsOf(primitive) <= 255 ? Uint8Array : Uint16Array);

  const large = emptyDocument();
  const unused = Array.from({ length: 65530 - ball.positions.length }, () => [7, 7, 7]);
  const most = { ...ball, positions: [...ball.positions, ...unused] };
  addMesh(large, 'large', primitiveOf(large, most));
  const [grown] = primitivesOf((await unwrapped(large)).after);
  assert.ok(rowsOf(grown) > 65535, `${rowsOf(grown)} vertices`);
  assert.equal(kindOf(grown.getIndices()), Uint32Array);
});

test('a triangle soup without indices stays one', async () => {
  const document = emptyDocument();
  const ball = sphere(5);
  const soup = indicesOf(ball).flatMap((v) => ball.positions[v]);
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', accessor(document, 'VEC3', Float32Array.from(soup)));
  addMesh(document, 'soup', primitive);
  const { after, atlases } = await unwrapped(document, { seams: 'none' });
  assert.equal(primitivesOf(after)[0].getIndices(), null);
  assert.equal(atlases[0].result.report.charts.length, 1, 'joined by position');
});

test('strips and fans become triangles', async () => {
  const document = emptyDocument();
  const strip = Float32Array.from({ length: 24 }, (_, i) =>
    i % 3 === 0 ? Math.floor(i / 6) : i % 3 === 1 ? Math.floor(i / 3) % 2 : 0,
  );
  const turn = (k) => [Math.cos(k), Math.sin(k), 5];
  const fan = Float32Array.from([[0, 0, 5], ...[0, 1, 2, 3, 4].map(turn)].flat());
  const primitives = [
    document
      .createPrimitive()
      .setMode(5)
      .setAttribute('POSITION', accessor(document, 'VEC3', strip))
      // Repeating a vertex joins two strips.
      .setIndices(accessor(document, 'SCALAR', Uint8Array.of(0, 2, 1, 3, 3, 4, 4, 6, 5, 7))),
    document
      .createPrimitive()
      .setMode(6)
      .setAttribute('POSITION', accessor(document, 'VEC3', fan)),
  ];
  addMesh(document, 'both', ...primitives);
  const { after } = await unwrapped(document);
  for (const primitive of primitivesOf(after)) assert.equal(primitive.getMode(), 4);
  assert.deepEqual(
    primitivesOf(after).map((primitive) => primitive.getIndices().getCount()),
    [12, 12],
  );
});

test('points and lines stay as they are', async () => {
  const document = emptyDocument();
  const ball = primitiveOf(document, sphere(4));
  const points = document
    .createPrimitive()
    .setMode(0)
    .setAttribute('POSITION', ball.getAttribute('POSITION'));
  addMesh(document, 'ball', ball, points);
  const before = rowsOf(points);
  await document.transform(unwrap(abflat));
  assert.deepEqual(points.listSemantics(), ['POSITION']);
  assert.equal(rowsOf(points), before);
  await assertValidFile(document);
});
