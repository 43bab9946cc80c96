// Writes meshes of three.js as a GLB that is lit by a light map alone.

import { Document, NodeIO } from '@gltf-transform/core';
import { KHRMaterialsUnlit } from '@gltf-transform/extensions';

/** Colours are those of the materials times the light: unlit, with the light map in TEXCOORD_1. */
export async function glbOf(meshes, png) {
  const document = new Document();
  document.createBuffer();
  const scene = document.createScene();
  const unlit = document.createExtension(KHRMaterialsUnlit);
  const light = document.createTexture('light map').setImage(png).setMimeType('image/png');
  for (const { mesh, geometry } of meshes) {
    const { r, g, b } = mesh.material.color;
    const material = document
      .createMaterial(mesh.name)
      .setBaseColorFactor([r, g, b, 1])
      .setBaseColorTexture(light)
      .setExtension('KHR_materials_unlit', unlit.createUnlit());
    material.getBaseColorTextureInfo().setTexCoord(1);
    const primitive = primitiveOf(document, geometry).setMaterial(material);
    const made = document.createMesh(mesh.name).addPrimitive(primitive);
    const node = document.createNode(mesh.name).setMesh(made);
    scene.addChild(node.setMatrix(mesh.matrixWorld.elements));
  }
  return new NodeIO().registerExtensions([KHRMaterialsUnlit]).writeBinary(document);
}

function primitiveOf(document, { attributes, index }) {
  const [buffer] = document.getRoot().listBuffers();
  const made = (type, array) =>
    document.createAccessor().setType(type).setArray(array.slice()).setBuffer(buffer);
  const { position, normal, uv, uv1 } = attributes;
  return document
    .createPrimitive()
    .setAttribute('POSITION', made('VEC3', position.array))
    .setAttribute('NORMAL', made('VEC3', normal.array))
    .setAttribute('TEXCOORD_0', made('VEC2', upwards(uv.array)))
    .setAttribute('TEXCOORD_1', made('VEC2', upwards(uv1.array)))
    .setIndices(made('SCALAR', index.array));
}

/** glTF measures v from the top. */
const upwards = (uv) => uv.map((x, i) => (i % 2 === 0 ? x : 1 - x));
