// Documents of glTF-Transform get an atlas, and everything else of them stays.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { KHRMeshQuantization } from '@gltf-transform/extensions';
import { createAbflat } from 'abflat';
import { documentMesh, setTexcoords, unwrap } from 'abflat/gltf';
import {
  accessor,
  addMesh,
  assertSameButTexcoord,
  assertValidFile,
  atlasOf,
  emptyDocument,
  flaws,
  indicesOf,
  io,
  positionsOf,
  primitiveOf,
  primitivesOf,
  randomRows,
  reread,
} from '../support/gltf.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { sphere, torus } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

/** Unwraps a document and checks all that must hold for any; gives its file read again, and the atlases. */
async function unwrapped(document, { isMirrored, ...options } = {}) {
  const { texcoord = 0 } = options;
  const before = await reread(document);
  const atlases = [];
  await document.transform(unwrap(abflat, { ...options, onAtlas: (atlas) => atlases.push(atlas) }));
  await assertValidFile(document);
  const after = await reread(document);
  assertSameButTexcoord(after, before, `TEXCOORD_${texcoord}`);
  for (const { parts, result } of atlases) {
    assert.ok(result.report.valid);
    const primitives = parts.map(({ primitive }) => primitive);
    assert.deepEqual(flaws(atlasOf(primitives, { texcoord, isMirrored })), []);
  }
  return { after, before, atlases };
}

const kindOf = (accessor) => accessor.getArray().constructor;
const rowsOf = (primitive) => primitive.getAttribute('POSITION').getCount();

/** Two materials on the halves of a ring, with everything that a character has. */
function character() {
  const document = emptyDocument();
  const ring = torus(24, 12);
  const { length } = ring.faces;
  const halves = [ring.faces.slice(0, length / 2), ring.faces.slice(length / 2)];
  const primitives = halves.map((faces, i) => {
    const primitive = primitiveOf(document, { ...ring, faces });
    const count = rowsOf(primitive);
    const rows = (type, Kind, normalized) =>
      randomRows(document, type, Kind, count, { seed: i + 1, normalized });
    const weights = accessor(
      document,
      'VEC4',
      Uint8Array.from({ length: 4 * count }, (_, k) => (k % 4 === 0 ? 255 : 0)),
      true,
    );
    const joints = Uint8Array.from({ length: 4 * count }, (_, k) =>
      k % 4 === 0 ? (k >> 2) % 2 : 0,
    );
    const normals = Float32Array.from({ length: 3 * count }, (_, k) => (k % 3 === 2 ? 1 : 0));
    return primitive
      .setAttribute('NORMAL', accessor(document, 'VEC3', normals))
      .setAttribute('COLOR_0', rows('VEC4', Uint8Array, true))
      .setAttribute('TEXCOORD_0', rows('VEC2', Float32Array))
      .setAttribute('TEXCOORD_1', rows('VEC2', Uint16Array, true))
      .setAttribute('JOINTS_0', accessor(document, 'VEC4', joints))
      .setAttribute('WEIGHTS_0', weights)
      .setAttribute('_TEMPERATURE', rows('SCALAR', Float32Array))
      .setMaterial(document.createMaterial(`material ${i}`))
      .addTarget(
        document
          .createPrimitiveTarget('larger')
          .setAttribute('POSITION', rows('VEC3', Float32Array))
          .setAttribute('NORMAL', rows('VEC3', Float32Array)),
      );
  });
  const { node } = addMesh(document, 'character', ...primitives);
  const joints = ['root', 'tip'].map((name) => document.createNode(name));
  document.getRoot().listScenes()[0].addChild(joints[0].addChild(joints[1]));
  const skin = document.createSkin().addJoint(joints[0]).addJoint(joints[1]);
  // Ignored by what draws a skinned mesh.
  node.setSkin(skin).setScale([5, 1, 1]);
  return document;
}

test('skin weights, colours, morph targets and further sets stay with every corner', async () => {
  const { after, atlases } = await unwrapped(character());
  assert.equal(atlases.length, 1);
  const [a, b] = primitivesOf(after);
  assert.equal(kindOf(a.getAttribute('TEXCOORD_0')), Float32Array);
  assert.equal(kindOf(a.getIndices()), Uint16Array);
  assert.equal(after.getRoot().listSkins().length, 1);
  // A ring of two materials is one surface: seams are where charts end, not where a material does.
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

test('overwrite: false leaves primitives that have the set alone', async () => {
  const document = emptyDocument();
  const primitives = [sphere(5), torus(12, 6)].map((each) => primitiveOf(document, each));
  addMesh(document, 'both', ...primitives);
  const given = randomRows(document, 'VEC2', Float32Array, rowsOf(primitives[0]));
  primitives[0].setAttribute('TEXCOORD_0', given);
  const { atlases } = await unwrapped(document, { overwrite: false });
  assert.equal(primitives[0].getAttribute('TEXCOORD_0'), given);
  assert.deepEqual(
    atlases[0].parts.map(({ primitive }) => primitive),
    [primitives[1]],
  );
  assert.deepEqual((await unwrapped(document, { overwrite: false })).atlases, []);
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
  // Nothing of what was replaced is left behind: two indices and three attributes.
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
  // Only through its parent.
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

test('a node that mirrors: the other half of a body fits, and is not seen from behind', async () => {
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
  assert.equal(atlases[0].result.report.seams.genus, 1, 'both halves are one ring');
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
      // Twice the same vertex joins two strips.
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

test('groupBy: an atlas for all, for each mesh, or for each primitive', async () => {
  const counts = {};
  for (const groupBy of ['scene', 'mesh', 'primitive']) {
    const document = character();
    addMesh(document, 'ball', primitiveOf(document, sphere(4)));
    const fractions = [];
    const { atlases } = await unwrapped(document, {
      groupBy,
      onProgress: ({ fraction }) => fractions.push(fraction),
    });
    counts[groupBy] = atlases.map(({ parts }) => parts.length);
    assert.deepEqual(
      fractions,
      [...fractions].sort((a, b) => a - b),
    );
    assert.equal(fractions.at(-1), 1);
  }
  assert.deepEqual(counts, { scene: [3], mesh: [2, 1], primitive: [1, 1, 1] });
});

/** Whether any triangles of the two primitives share an edge of the atlas. */
function touch(a, b) {
  const edges = (primitive) =>
    atlasOf([primitive]).flatMap((triangle) =>
      triangle.map((from, k) => [from, triangle[(k + 1) % 3]].map(String).sort().join(' ')),
    );
  const known = new Set(edges(a));
  return edges(b).some((edge) => known.has(edge));
}

test('seams between materials, and round the islands that a document has', async () => {
  const joined = await unwrapped(character(), { seams: 'none' });
  assert.ok(touch(...primitivesOf(joined.after)));
  const cut = await unwrapped(character(), { seams: 'auto,material' });
  assert.ok(!touch(...primitivesOf(cut.after)));

  // It keeps the charts that it has by now.
  const document = cut.after;
  const charts = cut.atlases[0].result.report.charts.length;
  const kept = await unwrapped(document, { seams: 'uv', texcoord: 1 });
  assert.equal(kept.atlases[0].result.report.charts.length, charts);
  for (const primitive of primitivesOf(document)) primitive.setAttribute('TEXCOORD_0', null);
  await assert.rejects(document.transform(unwrap(abflat, { seams: 'uv' })), {
    code: 'InvalidOption',
  });
});

test('primitives without coordinates are islands of their own', async () => {
  const document = character();
  const [first, second] = primitivesOf(document);
  const zeros = new Float32Array(2 * rowsOf(first));
  first
    .setAttribute('TEXCOORD_0', accessor(document, 'VEC2', zeros))
    .setAttribute('TEXCOORD_1', null);
  second.setAttribute('TEXCOORD_0', null).setAttribute('TEXCOORD_1', null);
  const { after } = await unwrapped(document, { seams: 'uv' });
  assert.ok(!touch(...primitivesOf(after)));
});

test('the command line program gives the same atlas', async (t) => {
  const path = tempFolder(t);
  const document = character();
  addMesh(document, 'ball', primitiveOf(document, sphere(5)))
    .node.setScale([-1, 2, 1])
    .setTranslation([3, 0, 0]);
  for (const primitive of primitivesOf(document)) primitive.setAttribute('TEXCOORD_1', null);
  await io.write(path('in.glb'), document);
  const { after } = await unwrapped(document, {
    isMirrored: (primitive) => primitive === primitivesOf(document)[2],
  });
  const { code, stderr } = await runAbflat(['unwrap', path('in.glb'), '-o', path('out.glb')]);
  assert.equal(code, 0, stderr);
  const other = await io.read(path('out.glb'));
  assertSameButTexcoord(other, await io.read(path('in.glb')));
  const [ours, theirs] = [after, other].map((each) => atlasOf(primitivesOf(each)).flat(2));
  assert.equal(ours.length, theirs.length);
  ours.forEach((x, i) => {
    assert.ok(Math.abs(x - theirs[i]) < 1e-5, `number ${i}: ${x} and ${theirs[i]}`);
  });
});

test('options are those of unwrap', async () => {
  const document = character();
  const { atlases } = await unwrapped(document, { maxStretch: 1.3, resolution: 256, padding: 4 });
  const { options } = atlases[0].result.report;
  assert.deepEqual([options.maxStretch, options.resolution, options.padding], [1.3, 256, 4]);
});

test('what goes wrong leaves the document as it was, and is said with its place', async () => {
  const document = character();
  const bytes = () =>
    primitivesOf(document)
      .flatMap((primitive) => [...primitive.listAttributes(), primitive.getIndices()])
      .map((each) => [...each.getArray()]);
  const before = bytes();
  const controller = new AbortController();
  const aborted = document.transform(
    unwrap(abflat, {
      groupBy: 'primitive',
      signal: controller.signal,
      onProgress: ({ fraction }) => fraction > 0.6 && controller.abort(),
    }),
  );
  await assert.rejects(aborted, { name: 'AbortError' });
  assert.deepEqual(bytes(), before);

  const invalid = { code: 'InvalidOption' };
  assert.throws(() => unwrap(abflat, { texcoord: 0.5 }), invalid);
  assert.throws(() => unwrap(abflat, { groupBy: 'node' }), invalid);
  assert.throws(() => unwrap(abflat, { overwrite: 1 }), invalid);
  await assert.rejects(document.transform(unwrap(abflat, { nothing: 1 })), invalid);
  await assert.rejects(emptyDocument().transform(unwrap(abflat)), { code: 'EmptyMesh' });

  const second = primitivesOf(document)[1];
  const fails = (message) =>
    assert.rejects(document.transform(unwrap(abflat)), { code: 'InvalidMesh', message });
  const indices = second.getIndices().getArray();
  const first = indices[4];
  indices[4] = 60000;
  await fails(/mesh 0 \("character"\), primitive 1: triangle 1 has vertex 60000/);
  indices[4] = first;
  second.getAttribute('POSITION').getArray()[7] = Number.NaN;
  await fails(/mesh 0 \("character"\), primitive 1: vertex 2 /);
  second.getAttribute('POSITION').getArray()[7] = 0;
  second.setAttribute('COLOR_0', randomRows(document, 'VEC3', Float32Array, 5));
  await fails(/primitive 1: COLOR_0 has 5 rows/);
});

test('a layout of one’s own goes into a document as well', async () => {
  const document = emptyDocument();
  const { positions, faces } = torus(12, 6);
  const open = { positions, faces: faces.slice(0, 24) };
  addMesh(document, 'strip', primitiveOf(document, open));
  const before = await reread(document);
  const mesh = documentMesh(document);
  const layout = await abflat.unwrap(mesh, { seamEdges: Uint32Array.of(0, 12) });
  assert.throws(
    () => setTexcoords(mesh, { ...layout, indices: layout.indices.slice(3) }),
    /has 23 triangles, the document 24/,
  );
  setTexcoords(mesh, layout);
  assertSameButTexcoord(document, before);
  assert.deepEqual(flaws(atlasOf(primitivesOf(document))), []);
});
