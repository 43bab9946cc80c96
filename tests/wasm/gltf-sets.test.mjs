// Which texcoord set of a document is written, and which primitives keep theirs.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Logger } from '@gltf-transform/core';
import {
  KHRMaterialsClearcoat,
  KHRMaterialsVariants,
  KHRTextureTransform,
} from '@gltf-transform/extensions';
import { createAbflat } from 'abflat';
import { documentMesh, freeTexcoord, sampledTexcoords, setTexcoords, unwrap } from 'abflat/gltf';
import { addMesh, emptyDocument, primitiveOf, primitivesOf, randomRows } from '../support/gltf.mjs';
import { sphere, torus } from '../support/surfaces.mjs';
import { rowsOf } from './support/character.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

/** A document whose logger writes to `said`. */
function listening(document) {
  const said = [];
  const write = (level) => (text) => said.push([level, text]);
  const logger = {
    debug: () => 0,
    info: write('info'),
    warn: write('warn'),
    error: write('error'),
  };
  document.setLogger(Object.assign(Object.create(Logger.prototype), logger));
  return said;
}

/**
 * A ball with the texcoord sets `sets`, whose material has a base colour texture that samples the
 * set `sampled`.
 */
function painted({ sets = [0], sampled } = {}) {
  const document = emptyDocument();
  const ball = primitiveOf(document, sphere(5));
  for (const set of sets)
    ball.setAttribute(
      `TEXCOORD_${set}`,
      randomRows(document, 'VEC2', Float32Array, rowsOf(ball), { seed: set + 1 }),
    );
  const material = document.createMaterial('paint');
  if (sampled !== undefined) {
    material.setBaseColorTexture(document.createTexture('colours'));
    material.getBaseColorTextureInfo().setTexCoord(sampled);
  }
  addMesh(document, 'ball', ball.setMaterial(material));
  return { document, ball, material };
}

const rowsOfSet = (primitive, set) => [...primitive.getAttribute(`TEXCOORD_${set}`).getArray()];

test('primitives that have the set keep it, and the others get an atlas', async () => {
  const document = emptyDocument();
  const said = listening(document);
  const primitives = [sphere(5), torus(12, 6)].map((each) => primitiveOf(document, each));
  addMesh(document, 'both', ...primitives);
  const given = randomRows(document, 'VEC2', Float32Array, rowsOf(primitives[0]));
  primitives[0].setAttribute('TEXCOORD_0', given);
  const atlases = [];
  const onAtlas = (atlas) => atlases.push(atlas);
  await document.transform(unwrap(abflat, { onAtlas }));
  assert.equal(primitives[0].getAttribute('TEXCOORD_0'), given);
  assert.deepEqual(
    atlases.map(({ parts, texcoord }) => [parts.map(({ primitive }) => primitive), texcoord]),
    [[[primitives[1]], 0]],
  );
  assert.deepEqual(
    said.map(([level]) => level),
    ['info'],
  );
  // Again: nothing is left to do, and that is reported.
  await document.transform(unwrap(abflat, { onAtlas }));
  assert.equal(atlases.length, 1);
  assert.match(
    said.at(-1).join(),
    /^warn,.*2 of 2 primitives already have TEXCOORD_0.*overwrite: true/,
  );
  await document.transform(unwrap(abflat, { onAtlas, overwrite: true }));
  assert.equal(atlases[1].parts.length, 2);
  assert.notEqual(primitives[0].getAttribute('TEXCOORD_0'), given);
});

test('what is fixed keeps its coordinates and takes part', async () => {
  const document = emptyDocument();
  addMesh(document, 'ring', primitiveOf(document, torus(16, 8)));
  await document.transform(unwrap(abflat));
  const painted = rowsOfSet(primitivesOf(document)[0], 0);
  addMesh(document, 'ball', primitiveOf(document, sphere(6)));
  const atlases = [];
  await document.transform(
    unwrap(abflat, { fixedFaces: 'uv', onAtlas: (atlas) => atlases.push(atlas) }),
  );
  assert.deepEqual(rowsOfSet(primitivesOf(document)[0], 0), painted);
  assert.equal(atlases[0].parts.length, 2);
});

test('the sets that textures sample', () => {
  const plain = painted();
  assert.deepEqual(sampledTexcoords([plain.ball]), []);
  assert.deepEqual(sampledTexcoords([painted({ sampled: 0 }).ball]), [0]);

  const { document, ball, material } = painted({ sampled: 2 });
  assert.deepEqual(sampledTexcoords([ball]), [2]);
  const texture = document.createTexture();
  material.setNormalTexture(texture).getNormalTextureInfo().setTexCoord(1);
  // A slot without a texture samples nothing.
  material.setOcclusionTexture(texture).getOcclusionTextureInfo().setTexCoord(7);
  material.setOcclusionTexture(null);
  assert.deepEqual(sampledTexcoords([ball]), [1, 2]);

  const coat = document.createExtension(KHRMaterialsClearcoat).createClearcoat();
  coat.setClearcoatTexture(texture).getClearcoatTextureInfo().setTexCoord(4);
  coat.setClearcoatNormalTexture(texture).getClearcoatNormalTextureInfo().setTexCoord(8);
  coat.setClearcoatNormalTexture(null);
  material.setExtension('KHR_materials_clearcoat', coat);
  assert.deepEqual(sampledTexcoords([ball]), [1, 2, 4]);

  const moved = document.createExtension(KHRTextureTransform).createTransform();
  material.getNormalTextureInfo().setExtension('KHR_texture_transform', moved);
  assert.deepEqual(sampledTexcoords([ball]), [1, 2, 4]);
  moved.setTexCoord(3);
  assert.deepEqual(sampledTexcoords([ball]), [2, 3, 4]);

  const variants = document.createExtension(KHRMaterialsVariants);
  const other = document.createMaterial('other').setEmissiveTexture(texture);
  const mapping = variants
    .createMapping()
    .setMaterial(other)
    .addVariant(variants.createVariant('night'));
  ball.setExtension('KHR_materials_variants', variants.createMappingList().addMapping(mapping));
  assert.deepEqual(sampledTexcoords([ball]), [0, 2, 3, 4]);
});

test('the free set: 0 where no texture samples it, otherwise the next one', () => {
  const cases = [
    [{ sets: [] }, 0],
    [{ sets: [0] }, 0],
    [{ sets: [0, 1], sampled: 1 }, 0],
    [{ sets: [0], sampled: 0 }, 1],
    [{ sets: [0, 1, 2], sampled: 0 }, 3],
    [{ sets: [], sampled: 0 }, 1],
  ];
  for (const [options, free] of cases)
    assert.equal(freeTexcoord(painted(options).document), free, JSON.stringify(options));
  // Of two primitives, the one with more sets counts.
  const { document } = painted({ sampled: 0 });
  addMesh(document, 'more', primitiveOf(document, sphere(3)));
  const [, second] = primitivesOf(document);
  for (const set of [0, 1])
    second.setAttribute(
      `TEXCOORD_${set}`,
      randomRows(document, 'VEC2', Float32Array, rowsOf(second)),
    );
  assert.equal(freeTexcoord(document), 2);
});

test('auto leaves what textures sample and takes what nothing does', async () => {
  const textured = painted({ sampled: 0 });
  const before = rowsOfSet(textured.ball, 0);
  let texcoord;
  const options = {
    texcoord: 'auto',
    onAtlas: (atlas) => {
      ({ texcoord } = atlas);
    },
  };
  await textured.document.transform(unwrap(abflat, options));
  assert.equal(texcoord, 1);
  assert.deepEqual(rowsOfSet(textured.ball, 0).slice(0, before.length), before);
  assert.ok(textured.ball.getAttribute('TEXCOORD_1'));

  const plain = painted();
  const unused = rowsOfSet(plain.ball, 0);
  await plain.document.transform(unwrap(abflat, options));
  assert.equal(texcoord, 0);
  assert.notDeepEqual(rowsOfSet(plain.ball, 0).slice(0, unused.length), unused);
  assert.equal(plain.ball.getAttribute('TEXCOORD_1'), null);
});

test('setTexcoords knows auto as well', async () => {
  const { document, ball } = painted({ sampled: 0 });
  const mesh = documentMesh(document);
  const layout = await abflat.unwrap(mesh, { roundsForGltf: true });
  setTexcoords(mesh, layout, { texcoord: 'auto' });
  assert.ok(ball.getAttribute('TEXCOORD_1'));
});

test('a document without triangles stays as it is', async () => {
  const document = emptyDocument();
  const lines = primitiveOf(document, sphere(3)).setMode(1);
  await document.transform(unwrap(abflat));
  addMesh(document, 'lines', lines);
  for (const groupBy of ['scene', 'mesh', 'primitive'])
    await document.transform(unwrap(abflat, { groupBy }));
  assert.deepEqual(lines.listSemantics(), ['POSITION']);

  const nothing = primitiveOf(document, { ...sphere(3), faces: [] });
  const ball = primitiveOf(document, sphere(3));
  addMesh(document, 'nothing', nothing, document.createPrimitive());
  addMesh(document, 'ball', ball);
  for (const groupBy of ['mesh', 'primitive', 'scene'])
    await document.transform(unwrap(abflat, { groupBy, overwrite: true }));
  assert.ok(ball.getAttribute('TEXCOORD_0'));
});
