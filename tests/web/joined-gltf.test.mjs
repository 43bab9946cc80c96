// Several glTF files become one that has all that is in each of them.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import {
  EXTMeshGPUInstancing,
  KHRLightsPunctual,
  KHRMaterialsClearcoat,
  KHRMaterialsVariants,
} from '@gltf-transform/extensions';
import { codecIo, quantize, withMeshopt } from '../support/compressed-by-exporters.mjs';
import {
  accessor,
  addMesh,
  assertSameButTexcoord,
  assertValidFile,
  atlasOf,
  emptyDocument,
  flaws,
  io,
  primitiveOf,
  primitivesOf,
  randomRows,
  reread,
} from '../support/gltf.mjs';
import { richGltf } from '../support/rich-gltf.mjs';
import { objText, sphere, torus, voxels } from '../support/surfaces.mjs';
import { loadModule } from './modules.mjs';
import { dropFiles, exportMesh, openPage, settled, textOf } from './page.mjs';

const { joinedGlb } = await loadModule('files/joined-gltf');

const PIXEL = Buffer.from(
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==',
  'base64',
);

/** A ring in two variants, with a lacquer whose texture is an extension's, and a light. */
function ring(names) {
  const document = emptyDocument();
  const primitive = primitiveOf(document, torus(12, 6));
  const count = primitive.getAttribute('POSITION').getCount();
  primitive.setAttribute('TEXCOORD_0', randomRows(document, 'VEC2', Float32Array, count));
  const texture = document.createTexture('gloss').setImage(PIXEL).setMimeType('image/png');
  const lacquer = document
    .createExtension(KHRMaterialsClearcoat)
    .createClearcoat()
    .setClearcoatFactor(1)
    .setClearcoatTexture(texture);
  const material = document
    .createMaterial('lacquer')
    .setExtension('KHR_materials_clearcoat', lacquer);
  primitive.setMaterial(material);
  const variants = document.createExtension(KHRMaterialsVariants);
  const list = variants.createMappingList();
  for (const name of names)
    list.addMapping(
      variants
        .createMapping()
        .setMaterial(document.createMaterial(`${name} paint`))
        .addVariant(variants.createVariant(name)),
    );
  primitive.setExtension('KHR_materials_variants', list);
  const light = document.createExtension(KHRLightsPunctual).createLight('lamp').setType('point');
  const { node } = addMesh(document, 'ring', primitive);
  node.addChild(document.createNode('bulb').setExtension('KHR_lights_punctual', light));
  document.getRoot().getAsset().copyright = 'A. Smith';
  return document;
}

/** A ball that is drawn three times, moves, and has no name. */
function balls() {
  const document = emptyDocument();
  const { node } = addMesh(document, '', primitiveOf(document, sphere(4)));
  const places = Float32Array.of(0, 0, 0, 3, 0, 0, 6, 0, 0);
  const many = document
    .createExtension(EXTMeshGPUInstancing)
    .setRequired(true)
    .createInstancedMesh()
    .setAttribute('TRANSLATION', accessor(document, 'VEC3', places));
  node.setExtension('EXT_mesh_gpu_instancing', many);
  const sampler = document
    .createAnimationSampler()
    .setInput(accessor(document, 'SCALAR', Float32Array.of(0, 1)))
    .setOutput(accessor(document, 'VEC3', Float32Array.of(0, 0, 0, 0, 2, 0)));
  const channel = document
    .createAnimationChannel()
    .setTargetNode(node)
    .setTargetPath('translation')
    .setSampler(sampler);
  document.createAnimation('hop').addSampler(sampler).addChannel(channel);
  return document;
}

const fileOf = async (name, document) => ({
  file: new File(
    [document instanceof Uint8Array ? document : await io.writeBinary(document)],
    name,
  ),
  others: [],
});

async function joined(files) {
  const all = await Promise.all(Object.entries(files).map(([name, each]) => fileOf(name, each)));
  return io.readBinary(new Uint8Array(await (await joinedGlb(all)).arrayBuffer()));
}

const namesOf = (list) => list.map((each) => each.getName());

test('all that is in each file is in the joined one, and refers to its own', async () => {
  const rich = await io.readBinary(richGltf().glb());
  const document = await joined({ 'rich.glb': richGltf().glb(), 'balls.glb': balls() });
  await assertValidFile(document);
  const root = document.getRoot();
  const [first, second] = root.getDefaultScene().listChildren();
  assert.deepEqual(namesOf([first, second]), ['rich', 'balls']);
  assert.equal(root.listScenes().length, 1);
  assert.equal(root.listBuffers().length, 1);
  // The meshes of the first file come first.
  const meshes = root.listMeshes();
  assert.deepEqual(namesOf(meshes), [...namesOf(rich.getRoot().listMeshes()), '']);
  assert.deepEqual(meshes[0].getWeights(), rich.getRoot().listMeshes()[0].getWeights());
  meshes[3].dispose();
  assertSameButTexcoord(document, rich, '');

  const [skin] = root.listSkins();
  const skinned = root.listNodes().find((node) => node.getName() === 'skinned');
  assert.equal(skinned.getSkin(), skin);
  assert.deepEqual(namesOf(skin.listJoints()), ['joint', 'joint 2']);
  assert.ok(skin.listJoints()[0].getParentNode() === first);
  const targets = root.listAnimations().map((each) => each.listChannels()[0].getTargetNode());
  assert.equal(targets[1], second.listChildren()[0], 'each animation moves its own node');
  assert.notEqual(targets[0], targets[1]);
  assert.ok(targets[0].getParentNode() === first);
  const many = targets[1].getExtension('EXT_mesh_gpu_instancing');
  assert.deepEqual([...many.getAttribute('TRANSLATION').getArray()], [0, 0, 0, 3, 0, 0, 6, 0, 0]);
  const required = root.listExtensionsRequired().map(({ extensionName }) => extensionName);
  assert.deepEqual(required.sort(), ['EXT_mesh_gpu_instancing', 'KHR_mesh_quantization']);
});

test('materials of extensions, lights and variants are those of their files', async () => {
  const document = await joined({
    'one.glb': ring(['red', 'blue']),
    'two.glb': ring(['blue', 'green']),
  });
  await assertValidFile(document);
  const root = document.getRoot();
  assert.equal(root.getAsset().copyright, 'A. Smith', 'said once');
  const rings = primitivesOf(document);
  const textures = rings.map((primitive) => {
    const lacquer = primitive.getMaterial().getExtension('KHR_materials_clearcoat');
    return lacquer.getClearcoatTexture();
  });
  assert.equal(new Set(textures).size, 2);
  for (const texture of textures) assert.deepEqual(Buffer.from(texture.getImage()), PIXEL);
  const bulbs = root.listNodes().filter((node) => node.getName() === 'bulb');
  assert.equal(bulbs.length, 2);
  for (const bulb of bulbs)
    assert.equal(bulb.getExtension('KHR_lights_punctual').getName(), 'lamp');
  const listed = rings.map((primitive) =>
    primitive
      .getExtension('KHR_materials_variants')
      .listMappings()
      .map((mapping) => mapping.listVariants()[0]),
  );
  assert.deepEqual(listed.map(namesOf), [
    ['red', 'blue'],
    ['blue', 'green'],
  ]);
  assert.equal(listed[0][1], listed[1][0], 'one choice of blue for both');
});

test('things around the origin go side by side; parts of a scene stay where they are', async () => {
  const boxes = (document) =>
    document
      .getRoot()
      .getDefaultScene()
      .listChildren()
      .map((node) => node.getTranslation());
  const at = (x) => {
    const document = emptyDocument();
    addMesh(document, 'ball', primitiveOf(document, sphere(4))).node.setTranslation([x, 0, 0]);
    return document;
  };
  const [none, shifted] = boxes(await joined({ 'a.glb': at(0), 'b.glb': at(0.5) }));
  assert.deepEqual(none, [0, 0, 0]);
  assert.ok(shifted[0] > 1.5 && shifted[0] < 2, 'a gap, but no more than that');
  assert.deepEqual(shifted.slice(1), [0, 0]);
  const stay = [
    [0, 0, 0],
    [0, 0, 0],
  ];
  assert.deepEqual(boxes(await joined({ 'a.glb': at(0), 'b.glb': at(5) })), stay);
  assert.deepEqual(boxes(await joined({ 'a.glb': richGltf().glb(), 'b.glb': at(0) })), stay);
});

test('a damaged file is named', async () => {
  await assert.rejects(
    joined({ 'good.glb': balls(), 'bad.glb': new Uint8Array(Buffer.from('nonsense')) }),
    /^Error: bad\.glb is not a GLB/,
  );
});

test('GLBs share one atlas, and the export is one GLB with everything else in them', async (t) => {
  const page = await openPage(t);
  const original = emptyDocument();
  addMesh(original, 'box', primitiveOf(original, sphere(3)));
  const packed = await withMeshopt(quantize(original));
  // Compression begins triangles at other corners.
  const box = await codecIo.readBinary(packed);
  box.disposeExtension('EXT_meshopt_compression');
  const files = { 'balls.glb': balls(), 'ring.glb': ring(['red']), 'box.glb': box };
  const expected = await reread(await joined(files));
  const bytes = {};
  for (const [name, document] of Object.entries(files))
    bytes[name] = document === box ? packed : await io.writeBinary(document);
  await dropFiles(page, bytes);
  await page.getByRole('button', { name: 'One atlas' }).click();
  await page.waitForFunction(
    () => document.querySelector('#source').textContent === 'balls-and-2-more.glb',
  );
  await settled(page);
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  const { name, path } = await exportMesh(page);
  assert.equal(name, 'balls-and-2-more-uv.glb');
  const document = await io.readBinary(readFileSync(path));
  await assertValidFile(document);
  // The texture of the ring needs the first set.
  assertSameButTexcoord(document, expected, 'TEXCOORD_1');
  assert.deepEqual(flaws(atlasOf(primitivesOf(document), { texcoord: 1 })), []);
  const root = document.getRoot();
  assert.deepEqual(namesOf(root.getDefaultScene().listChildren()), ['balls', 'ring', 'box']);
  assert.deepEqual(namesOf(root.listNodes()), namesOf(expected.getRoot().listNodes()));
  assert.deepEqual(namesOf(root.listMaterials()), namesOf(expected.getRoot().listMaterials()));
  assert.deepEqual(namesOf(root.listAnimations()), ['hop']);
  assert.equal(root.listTextures().length, 1);
});

test('an OBJ beside a GLB is a mesh of the joined GLB, which keeps the rest of the GLB', async (t) => {
  const page = await openPage(t);
  const cube = objText(voxels([[[true]]], 1));
  await dropFiles(page, { 'cube.obj': cube, 'ring.glb': await io.writeBinary(ring(['red'])) });
  await page.getByRole('button', { name: 'One atlas' }).waitFor();
  assert.match(
    await textOf(page, '#notice'),
    /cube\.obj is open\. In one atlas, cube\.obj keeps its shape only\./,
  );
  await page.getByRole('button', { name: 'One atlas' }).click();
  await page.waitForFunction(
    () => document.querySelector('#source').textContent === 'cube-and-1-more.glb',
  );
  await settled(page);
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  const document = await io.readBinary(readFileSync((await exportMesh(page)).path));
  await assertValidFile(document);
  const root = document.getRoot();
  const [first, second] = root.getDefaultScene().listChildren();
  assert.deepEqual(namesOf([first, second]), ['cube', 'ring']);
  assert.ok(second.getTranslation()[0] > 0, 'beside each other');
  assert.ok(namesOf(root.listMaterials()).includes('lacquer'));
  assert.equal(root.listTextures().length, 1);
  const shapes = primitivesOf(document);
  assert.equal(shapes.length, 2);
  const [box] = first.listChildren()[0].getMesh().listPrimitives();
  assert.equal(box.getIndices().getCount(), 36);
  assert.deepEqual(flaws(atlasOf(shapes, { texcoord: 1 })), []);
});
