// A document with much that has to be kept.

import { accessor, addMesh, emptyDocument, primitiveOf, randomRows } from '../../support/gltf.mjs';
import { torus } from '../../support/surfaces.mjs';

export const rowsOf = (primitive) => primitive.getAttribute('POSITION').getCount();

/** Two materials on the halves of a ring, with everything that a character has. */
export function character() {
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
