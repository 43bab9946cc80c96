import { Document } from '@gltf-transform/core';
import type { LayoutArrays } from '../model/model';
import { GLTF } from '../words/gltf';
import { gltfIo } from './gltf-source';
import { originOf, relativeTo } from './origin';

/**
 * A mesh that comes from no glTF, with its layout if it has one: positions, UVs, triangles and a
 * material, all called `name`.
 */
export async function newGlb(
  name: string,
  { uv, indices }: Pick<LayoutArrays, 'indices'> & Partial<Pick<LayoutArrays, 'uv'>>,
  positions: Float64Array,
): Promise<Blob> {
  if (!positions.every((x) => Number.isFinite(Math.fround(x)))) throw new Error(GLTF.tooLarge);
  const offset = originOf(positions, indices);
  const document = documentOf(name, uv, indices, relativeTo(offset, positions));
  if (offset.some((x) => x !== 0)) document.getRoot().listNodes()[0]?.setTranslation(offset);
  const bytes = await gltfIo().writeBinary(document);
  return new Blob([bytes as Uint8Array<ArrayBuffer>], { type: 'model/gltf-binary' });
}

function documentOf(
  name: string,
  uv: Float64Array | undefined,
  indices: Uint32Array,
  positions: Float32Array<ArrayBuffer>,
): Document {
  const document = new Document();
  const buffer = document.createBuffer();
  const accessor = () => document.createAccessor().setBuffer(buffer);
  const isSmall = positions.length / 3 < 2 ** 16; // the largest index would restart a primitive
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', accessor().setType('VEC3').setArray(positions))
    .setIndices(accessor().setArray(isSmall ? new Uint16Array(indices) : new Uint32Array(indices)))
    .setMaterial(document.createMaterial(name).setMetallicFactor(0));
  if (uv)
    primitive.setAttribute('TEXCOORD_0', accessor().setType('VEC2').setArray(texcoordsOf(uv)));
  const node = document.createNode(name).setMesh(document.createMesh(name).addPrimitive(primitive));
  document.createScene().addChild(node);
  return document;
}

/** That of glTF points down. */
const texcoordsOf = (uv: Float64Array) =>
  Float32Array.from(uv, (x, i) => (i % 2 === 0 ? x : 1 - x));
