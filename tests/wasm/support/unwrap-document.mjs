// What must hold whenever a document is unwrapped.

import assert from 'node:assert/strict';
import { unwrap } from 'abflat/gltf';
import {
  assertSameButTexcoord,
  assertValidFile,
  atlasOf,
  flaws,
  reread,
} from '../../support/gltf.mjs';

/**
 * Unwraps a whole document and checks everything that must hold for any; returns the document as
 * read back from its file, and the atlases.
 */
export async function unwrapDocument(abflat, document, { isMirrored, ...given } = {}) {
  const options = { overwrite: true, groupBy: 'scene', ...given };
  const { readTexcoord = 0, fixedFaces } = options;
  const { texcoord = fixedFaces === 'uv' ? readTexcoord : 0 } = options;
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
