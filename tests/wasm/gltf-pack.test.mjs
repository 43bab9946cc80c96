// The transform that packs the layout of a document.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { pack } from 'abflat/gltf';
import {
  accessor,
  addMesh,
  assertValidFile,
  emptyDocument,
  io,
  primitiveOf,
  primitivesOf,
  trianglesOf,
} from '../support/gltf.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { sphere, torus } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

/** Texcoords by projection along z, `scale` times as large. */
function projected(document, surface, scale) {
  const uv = surface.positions.flatMap(([x, y]) => [scale * x, scale * y]);
  return accessor(document, 'VEC2', Float32Array.from(uv));
}

function mapped(document, surface, scale, set = 0) {
  const primitive = primitiveOf(document, surface);
  return primitive.setAttribute(`TEXCOORD_${set}`, projected(document, surface, scale));
}

const arrayOf = (primitive, set) => primitive.getAttribute(`TEXCOORD_${set}`)?.getArray();
const areIn = (array) => array.every((x) => x >= 0 && x <= 1);

test('the same coordinates as from the program', async (t) => {
  const document = emptyDocument();
  addMesh(document, 'ball', mapped(document, sphere(5), 0.3));
  const { node } = addMesh(document, 'ring', mapped(document, torus(12, 8), 2));
  node.setScale([-1, 2, 1]);
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), await io.writeBinary(document));
  const { code, stderr } = await runAbflat(['pack', 'in.glb', '-o', 'out.glb', '-q'], {
    cwd: at(),
  });
  assert.deepEqual([code, stderr], [0, '']);
  const native = await io.readBinary(readFileSync(at('out.glb')));
  const edited = await io.readBinary(readFileSync(at('in.glb')));
  await edited.transform(pack(abflat));
  const cornersOf = (packed) =>
    primitivesOf(packed).map((primitive) =>
      trianglesOf(primitive).map((corners) =>
        corners.map((v) => [...arrayOf(primitive, 0).slice(2 * v, 2 * v + 2)]),
      ),
    );
  assert.deepEqual(cornersOf(edited), cornersOf(native));
  await assertValidFile(edited);
});

test('the set of a texture stays, and primitives without a layout stay as they are', async () => {
  const document = emptyDocument();
  const ball = mapped(document, sphere(4), 3);
  const bare = primitiveOf(document, torus(8, 6));
  const material = document.createMaterial().setBaseColorTexture(document.createTexture());
  addMesh(document, 'both', ball.setMaterial(material), bare);
  const before = Float32Array.from(arrayOf(ball, 0));
  const atlases = [];
  await document.transform(pack(abflat, { onAtlas: (atlas) => atlases.push(atlas) }));
  assert.deepEqual(
    atlases.map(({ texcoord, parts }) => [texcoord, parts.length]),
    [[1, 1]],
  );
  assert.deepEqual(arrayOf(ball, 0), before);
  assert.ok(areIn(arrayOf(ball, 1)));
  assert.deepEqual(bare.listSemantics(), ['POSITION']);
  await document.transform(pack(abflat, { texcoord: 0 }));
  assert.ok(areIn(arrayOf(ball, 0)));
});

test('primitives that share positions keep layouts of their own', async () => {
  const document = emptyDocument();
  const ball = sphere(4);
  const first = mapped(document, ball, 1);
  const second = first.clone().setAttribute('TEXCOORD_0', projected(document, ball, 4));
  addMesh(document, 'two', first, second);
  const result = await new Promise((resolve, reject) => {
    document
      .transform(pack(abflat, { rotate: 'none', onAtlas: (atlas) => resolve(atlas.result) }))
      .catch(reject);
  });
  assert.equal(result.report.islands, 2);
  const extentOf = (array) => Math.max(...array) - Math.min(...array);
  const [small, large] = [first, second].map((primitive) => {
    const us = arrayOf(primitive, 0).filter((_, i) => i % 2 === 0);
    return extentOf([...us]);
  });
  assert.ok(Math.abs(large / small - 4) < 1e-3, `${large} ${small}`);
});

test('one atlas per primitive; refusals leave the document as it was', async () => {
  const document = emptyDocument();
  addMesh(document, 'a', mapped(document, sphere(4), 1, 2));
  addMesh(document, 'b', mapped(document, torus(8, 6), 1, 2));
  const counts = [];
  await document.transform(
    pack(abflat, {
      readTexcoord: 2,
      groupBy: 'primitive',
      onAtlas: ({ texcoord, result }) => counts.push([texcoord, result.report.islands]),
    }),
  );
  assert.deepEqual(counts, [
    [2, 1],
    [2, 1],
  ]);
  await assert.rejects(document.transform(pack(abflat, { readTexcoord: 5 })), {
    code: 'NoTexcoords',
  });
  for (const options of [{ readTexcoord: -1 }, { texcoord: 'first' }, { groupBy: 'node' }])
    assert.throws(() => pack(abflat, options), { code: 'InvalidOption' });
  await assert.rejects(document.transform(pack(abflat, { readTexcoord: 2, padding: -1 })), {
    code: 'InvalidOption',
  });
});
