// The command line program and the glTF-Transform helper see the same mesh in a file, and give it the same layout.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { unwrap } from 'abflat/gltf';
import {
  addMesh,
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

/** TEXCOORD_0 of each corner of each triangle. */
const layoutOf = (document) =>
  primitivesOf(document).map((primitive) => {
    const uv = primitive.getAttribute('TEXCOORD_0').getArray();
    return trianglesOf(primitive).map((triangle) =>
      triangle.map((v) => [uv[2 * v], uv[2 * v + 1]]),
    );
  });

/** The atlas of a document from both, in scene coordinates with v upwards. */
async function bothLayouts(t, document) {
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), await io.writeBinary(document));
  const args = ['unwrap', 'in.glb', '-o', 'out.glb', '--report', 'r.json', '-q'];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.deepEqual([code, stderr], [0, '']);
  const native = await io.readBinary(readFileSync(at('out.glb')));
  const edited = await io.readBinary(readFileSync(at('in.glb')));
  const atlases = [];
  await edited.transform(
    unwrap(abflat, { groupBy: 'scene', onAtlas: (atlas) => atlases.push(atlas) }),
  );
  return {
    native: layoutOf(native),
    package: layoutOf(edited),
    notes: [JSON.parse(readFileSync(at('r.json'))).notes, atlases[0].result.report.notes],
  };
}

const areaOf = ([a, b, c]) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

function instance(document, mesh, scale, translation) {
  const node = document.createNode().setMesh(mesh).setScale(scale).setTranslation(translation);
  document.getRoot().listScenes()[0].addChild(node);
}

test('mirrored nodes: no triangle is mirrored when seen', async (t) => {
  for (const scale of [
    [-1, 1, 1],
    [1, -2, 1],
    [-1, -1, -1],
    [-1, -1, 1],
  ]) {
    const document = emptyDocument();
    addMesh(document, 'ring', primitiveOf(document, torus(12, 8))).node.setScale(scale);
    addMesh(document, 'ball', primitiveOf(document, sphere(4))).node.setTranslation([9, 0, 0]);
    const layouts = await bothLayouts(t, document);
    assert.deepEqual(layouts.package, layouts.native);
    const isMirrored = scale.reduce((product, x) => product * x, 1) < 0;
    // In a file v points down, and triangles run as they do without the node.
    for (const [p, triangles] of layouts.native.entries())
      for (const triangle of triangles)
        assert.equal(areaOf(triangle) > 0, isMirrored && p === 0, `${scale} ${triangle}`);
  }
});

test('instances: the same node counts, and the notes are the same', async (t) => {
  for (const scales of [
    [
      [1, 1, 1],
      [-1, 1, 1],
    ],
    [
      [1, 1, 1],
      [-2, 2, 2],
    ],
    [
      [20, 0.25, 20],
      [2, 2, 2],
      [0.5, 4, 0.5],
    ],
    [
      [0, 1, 1],
      [1, 1, 1],
    ],
  ]) {
    const document = emptyDocument();
    const { mesh, node } = addMesh(document, 'ball', primitiveOf(document, sphere(4)));
    addMesh(document, 'ring', primitiveOf(document, torus(12, 8))).node.setTranslation([0, 99, 0]);
    node.setScale(scales[0]);
    for (const [i, scale] of scales.slice(1).entries())
      instance(document, mesh, scale, [50 * i + 50, 0, 0]);
    const layouts = await bothLayouts(t, document);
    assert.deepEqual(layouts.package, layouts.native);
    const named = layouts.notes[0].map((note) => note.replace('own-texels', 'ownTexels'));
    assert.deepEqual(layouts.notes[1], named);
    assert.match(layouts.notes[0][0], new RegExp(`^${scales.length} nodes share 1 mesh`));
  }
});
