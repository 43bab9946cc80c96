// glTF-Transform documents: what can be asked for, and what goes wrong.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { UNWRAP_DEFAULTS } from '@gltf-transform/functions';
import { createAbflat } from 'abflat';
import { documentMesh, setTexcoords, unwrap } from 'abflat/gltf';
import {
  accessor,
  addMesh,
  assertSameButTexcoord,
  assertValidFile,
  atlasOf,
  cross,
  emptyDocument,
  flaws,
  io,
  primitiveOf,
  primitivesOf,
  randomRows,
  reread,
} from '../support/gltf.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { sphere, torus } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { character, rowsOf } from './support/character.mjs';
import { unwrapDocument } from './support/unwrap-document.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

const unwrapped = (document, options) => unwrapDocument(abflat, document, options);

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

test('by default meshes have atlases of their own, unless they share what they have', async () => {
  const partsIn = async (options) => {
    const document = character();
    addMesh(document, 'ball', primitiveOf(document, sphere(4)));
    const sizes = [];
    const onAtlas = ({ parts }) => sizes.push(parts.length);
    await document.transform(unwrap(abflat, { texcoord: 2, ...options, onAtlas }));
    return sizes;
  };
  assert.deepEqual(UNWRAP_DEFAULTS.groupBy, 'mesh', 'that of glTF-Transform');
  assert.deepEqual(await partsIn({}), [2, 1]);
  assert.deepEqual(await partsIn({ ownTexels: true }), [3]);
  assert.deepEqual(await partsIn({ fixedFaces: new Uint32Array(0), overwrite: true }), [3]);
});

test('a mesh that nodes share is sized for the largest of them beside other meshes', async () => {
  const areas = async (sizes) => {
    const document = emptyDocument();
    const { mesh, node } = addMesh(document, 'ball', primitiveOf(document, sphere(4)));
    const other = addMesh(document, 'other', primitiveOf(document, sphere(4)));
    other.node.setTranslation([50, 0, 0]);
    node.setScale(Array(3).fill(sizes[0]));
    for (const size of sizes.slice(1)) {
      const again = document.createNode().setMesh(mesh).setScale(Array(3).fill(size));
      document
        .getRoot()
        .listScenes()[0]
        .addChild(again.setTranslation([0, 50, 0]));
    }
    await document.transform(unwrap(abflat, { groupBy: 'scene' }));
    const [shared, single] = areasIn(document);
    return shared / single;
  };
  for (const sizes of [
    [1, 5],
    [5, 1],
    [2, 5, 1],
  ]) {
    const ratio = await areas(sizes);
    assert.ok(Math.abs(ratio / 25 - 1) < 0.05, `${sizes}: ${ratio}`);
  }
});

/** A ball in three sizes, one of them mirrored, and one outside the scene. */
function balls() {
  const document = emptyDocument();
  const primitive = primitiveOf(document, sphere(4));
  const shape = primitive.getAttribute('POSITION');
  primitive.addTarget(document.createPrimitiveTarget().setAttribute('POSITION', shape));
  const { mesh, node } = addMesh(document, 'ball', primitive);
  const scaled = (size) => document.createNode().setMesh(mesh).setScale([size, size, size]);
  for (const size of [3, -2]) document.getRoot().listScenes()[0].addChild(scaled(size));
  scaled(1);
  return { document, mesh, node, nodes: () => document.getRoot().listNodes() };
}

const contents = (document) =>
  ['Nodes', 'Meshes', 'Accessors'].map((kind) => document.getRoot()[`list${kind}`]().length);

/** Each mesh's area in the atlas. */
const areasIn = (document) =>
  document
    .getRoot()
    .listMeshes()
    .map((mesh) =>
      atlasOf(mesh.listPrimitives()).reduce((sum, t) => sum + Math.abs(cross(...t)), 0),
    );

test('with texels of its own, each node has them at its size', async () => {
  const { document, mesh, node, nodes } = balls();
  const atlases = [];
  const onAtlas = (atlas) => atlases.push(atlas);
  await document.transform(unwrap(abflat, { ownTexels: true, onAtlas }));
  assert.deepEqual(atlases[0].result.report.notes, []);
  assert.ok(atlases[0].result.report.valid);
  assert.equal(node.getMesh(), mesh, 'the first node keeps the mesh');
  assert.equal(nodes()[3].getMesh(), mesh, 'so does one outside the scene');
  await assertValidFile(document);
  const after = await reread(document);
  const isMirrored = (primitive) => primitive === primitivesOf(after)[2];
  assert.deepEqual(flaws(atlasOf(primitivesOf(after), { isMirrored })), []);
  const [least, larger, mirrored] = areasIn(after);
  assert.ok(Math.abs(larger / least - 9) < 0.1, `${larger / least}`);
  assert.ok(Math.abs(mirrored / least - 4) < 0.1, `${mirrored / least}`);
});

test('a run with texels of their own that fails, or has nothing to do, copies nothing', async () => {
  const { document, nodes, mesh } = balls();
  const run = (options) => document.transform(unwrap(abflat, options));
  const before = contents(document);
  await assert.rejects(run({ ownTexels: true, resolution: 16, padding: 256 }));
  assert.deepEqual(contents(document), before);
  assert.ok(nodes().every((node) => node.getMesh() === mesh));
  await run({});
  const after = contents(document);
  await run({ ownTexels: true });
  assert.deepEqual(contents(document), after, 'the primitive keeps its texcoords');
});

test('any set can be read: its islands are seams, or stay as they are', async () => {
  const document = character();
  const [primitive] = primitivesOf(document);
  const { atlases } = await unwrapped(document, { texcoord: 2, seams: 'auto,sharp=20' });
  const charts = atlases[0].result.report.charts.length;
  const cut = await unwrapped(document, { seams: 'uv', readTexcoord: 2, texcoord: 3 });
  assert.equal(cut.atlases[0].result.report.charts.length, charts);
  const numbers = (set) => [...primitive.getAttribute(`TEXCOORD_${set}`).getArray()];
  const [first, second] = [numbers(0), numbers(2)];
  const kept = await unwrapped(document, { fixedFaces: 'uv', readTexcoord: 2 });
  assert.equal(kept.atlases[0].texcoord, 2);
  // As texts: what deepEqual would print of so many numbers takes minutes.
  assert.ok(`${numbers(0)}` === `${first}`, 'the other set stays');
  assert.ok(`${numbers(2)}` === `${second}`, 'fixed islands stay bit by bit');
  assert.throws(() => unwrap(abflat, { readTexcoord: -1 }), /readTexcoord must be a whole number/);
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

  // It keeps the charts that it has so far.
  const document = cut.after;
  const charts = cut.atlases[0].result.report.charts.length;
  const kept = await unwrapped(document, { seams: 'uv', texcoord: 1 });
  assert.equal(kept.atlases[0].result.report.charts.length, charts);
  for (const primitive of primitivesOf(document)) primitive.setAttribute('TEXCOORD_0', null);
  await assert.rejects(document.transform(unwrap(abflat, { seams: 'uv', overwrite: true })), {
    code: 'InvalidOption',
  });
});

test('primitives that have coordinates keep them bit by bit, the others get some beside them', async () => {
  const document = emptyDocument();
  addMesh(document, 'ring', primitiveOf(document, torus(16, 8)));
  addMesh(document, 'ball', primitiveOf(document, sphere(6))).node.setTranslation([0, 0, 4]);
  const { after } = await unwrapped(document, {});
  const [ring, ball] = primitivesOf(after);
  const painted = atlasOf([ring]);
  ball.setAttribute('TEXCOORD_0', null);
  const { after: again, atlases } = await unwrapped(after, { fixedFaces: 'uv', maxStretch: 1.01 });
  assert.deepEqual(atlasOf([primitivesOf(again)[0]]), painted);
  assert.deepEqual(flaws(atlasOf(primitivesOf(again))), []);
  const { charts } = atlases[0].result.report;
  assert.ok(charts.some(({ fixed }) => fixed) && charts.some(({ fixed }) => !fixed));
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
  const args = ['unwrap', path('in.glb'), '-o', path('out.glb'), '--texcoord', '0'];
  const { code, stderr } = await runAbflat(args);
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
      overwrite: true,
      groupBy: 'primitive',
      signal: controller.signal,
      onProgress: ({ fraction }) => fraction > 0.6 && controller.abort(),
    }),
  );
  await assert.rejects(aborted, { name: 'AbortError' });
  assert.deepEqual(bytes(), before);

  const invalid = { code: 'InvalidOption' };
  assert.throws(() => unwrap({ texcoord: 1 }), { ...invalid, message: /await createAbflat/ });
  await assert.rejects(
    abflat.unwrap(document),
    /no positions.*unwrap, pack or verifyDocument of "abflat\/gltf"/,
  );
  assert.throws(() => unwrap(abflat, { texcoord: 0.5 }), invalid);
  assert.throws(() => unwrap(abflat, { groupBy: 'node' }), invalid);
  assert.throws(() => unwrap(abflat, { overwrite: 1 }), invalid);
  assert.throws(() => unwrap(abflat, { texcoord: 'first' }), invalid);
  await assert.rejects(document.transform(unwrap(abflat, { texcoord: 3, nothing: 1 })), invalid);

  const second = primitivesOf(document)[1];
  const fails = (message) =>
    assert.rejects(document.transform(unwrap(abflat, { overwrite: true })), {
      code: 'InvalidMesh',
      message,
    });
  const indices = second.getIndices().getArray();
  const first = indices[4];
  indices[4] = 60000;
  await fails(/mesh 0 \("character"\), primitive 1: triangle 1 refers to vertex 60000/);
  indices[4] = first;
  second.getAttribute('POSITION').getArray()[7] = Number.NaN;
  await fails(/mesh 0 \("character"\), primitive 1: vertex 2 /);
  second.getAttribute('POSITION').getArray()[7] = 0;
  second.setAttribute('COLOR_0', randomRows(document, 'VEC3', Float32Array, 5));
  await fails(/primitive 1: COLOR_0 has 5 elements/);
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
    /has 23 triangles, but the document has 24/,
  );
  setTexcoords(mesh, layout);
  assertSameButTexcoord(document, before);
  assert.deepEqual(flaws(atlasOf(primitivesOf(document))), []);
});
