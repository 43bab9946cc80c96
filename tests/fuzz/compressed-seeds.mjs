// glTF files in every compression. Separate from the other seeds because it needs npm packages.

import { COMPRESSIONS, compressed, io } from '../support/compressed-gltf.mjs';
import { addMesh, emptyDocument, primitiveOf, randomRows } from '../support/gltf.mjs';
import { sphere } from '../support/surfaces.mjs';

/** A small ball with attributes that compressions treat specially. */
async function ballGlb(how) {
  const document = emptyDocument();
  const surface = sphere(1);
  const count = surface.positions.length;
  const primitive = primitiveOf(document, surface)
    .setAttribute('NORMAL', randomRows(document, 'VEC3', Float32Array, count))
    .setAttribute('TEXCOORD_0', randomRows(document, 'VEC2', Float32Array, count))
    .setAttribute('JOINTS_0', randomRows(document, 'VEC4', Uint8Array, count));
  addMesh(document, 'ball', primitive);
  return compressed(Buffer.from(await io.writeBinary(document)), how);
}

export const compressedSeeds = () => Promise.all(Object.keys(COMPRESSIONS).map(ballGlb));
