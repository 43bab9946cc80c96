// An OBJ as a glTF document with the UVs that its images are for, so that it can be baked as one.

import { Document, type Material, type Texture } from '@gltf-transform/core';
import { KHRTextureTransform } from '@gltf-transform/extensions';
import { linearOf } from '../colors/srgb';
import type { DisplayMesh } from '../mesh/mesh';
import { sourceCorners } from '../mesh/source-corners';
import type { LayoutArrays } from '../model/model';
import type { MapPlacement } from './mtl';
import { NO_TEXCOORD, type ObjCorners } from './obj-corners';
import { type Offset, originOf, relativeTo } from './origin';
import type { VertexColors } from './vertex-colors';

/** Where the textures of a layout's triangles were: as the OBJ has them, material by material. */
export interface ObjShape {
  /** What `bakeLayout` is given: triangles in the order of the document. */
  layout: Pick<LayoutArrays, 'uv' | 'indices'>;
  offset: Offset;
  parts: ObjPart[];
}

interface ObjPart {
  /** Number of the material in the OBJ. */
  material: number;
  positions: Float32Array<ArrayBuffer>;
  normals: Float32Array<ArrayBuffer> | null;
  texcoords: Float32Array<ArrayBuffer>;
  /** Linear. */
  colors: Float32Array<ArrayBuffer> | null;
  indices: Uint32Array<ArrayBuffer>;
}

/** The triangles are those of the layout: polygons may be cut in several ways. */
export function objShape(
  obj: ObjCorners,
  colors: VertexColors | null,
  mesh: DisplayMesh,
  { uv, indices, vertexMap }: Pick<LayoutArrays, 'uv' | 'indices' | 'vertexMap'>,
): ObjShape {
  const vertices = indices.map((v) => vertexMap[v] as number);
  const corners = sourceCorners({ indices: vertices, faces: mesh.faces }, obj);
  const offset = originOf(mesh.positions, mesh.indices);
  const positions = relativeTo(offset, mesh.positions);
  const trianglesOf = new Map<number, number[]>();
  for (let t = 0; t < indices.length / 3; ++t) {
    const material = obj.materials[mesh.faces ? (mesh.faces[t] as number) : t] ?? 0;
    const known = trianglesOf.get(material) ?? [];
    if (known.length === 0) trianglesOf.set(material, known);
    known.push(t);
  }
  const own = [...trianglesOf].sort(([a], [b]) => a - b);
  const cornersOf = (triangles: number[]) =>
    triangles.flatMap((t) => [3 * t, 3 * t + 1, 3 * t + 2]);
  return {
    layout: {
      uv,
      indices: Uint32Array.from(
        own.flatMap(([, triangles]) => cornersOf(triangles)),
        (c) => indices[c] as number,
      ),
    },
    offset,
    parts: own.map(([material, triangles]) =>
      partOf(material, cornersOf(triangles), { obj, colors, positions, vertices, corners }),
    ),
  };
}

interface Sources {
  obj: ObjCorners;
  colors: VertexColors | null;
  positions: Float32Array;
  vertices: Uint32Array;
  corners: Int32Array;
}

/** A vertex for each position, texcoord and normal that are together. */
function partOf(
  material: number,
  of: number[],
  { obj, colors, positions, vertices, corners }: Sources,
): ObjPart {
  const numbers = new Map<string, number>();
  const [xyz, normals, texcoords, own]: number[][] = [[], [], [], []];
  const hasNormals = of.every((c) => obj.normalOf[corners[c] as number] !== undefined);
  const indices = of.map((c) => {
    const corner = corners[c] as number;
    const v = vertices[c] as number;
    const t = obj.texcoordOf[corner] ?? NO_TEXCOORD;
    const n = (hasNormals && obj.normalOf[corner]) || 0;
    const key = `${v} ${t} ${n}`;
    const known = numbers.get(key);
    if (known !== undefined) return known;
    const number = numbers.size;
    numbers.set(key, number);
    xyz.push(...positions.subarray(3 * v, 3 * v + 3));
    texcoords.push(t < 0 ? 0 : obj.texcoords[2 * t], t < 0 ? 0 : 1 - obj.texcoords[2 * t + 1]);
    if (hasNormals) normals.push(...unit(obj.normals.slice(3 * n, 3 * n + 3)));
    if (colors) own.push(...[0, 1, 2].map((d) => linearOr1(colors[3 * v + d])));
    return number;
  });
  return {
    material,
    positions: Float32Array.from(xyz),
    normals: hasNormals ? Float32Array.from(normals) : null,
    texcoords: Float32Array.from(texcoords),
    colors: colors && Float32Array.from(own),
    indices: Uint32Array.from(indices),
  };
}

/** 1 where there is none, which changes no texture. */
const linearOr1 = (color: number | undefined = Number.NaN) =>
  Number.isFinite(color) ? linearOf(Math.min(1, Math.max(0, color))) : 1;

function unit(normal: number[]): number[] {
  const length = Math.hypot(...normal);
  return length > 0 ? normal.map((x) => x / length) : [0, 0, 1];
}

/** `materialOf` makes the material with a number of the OBJ. */
export function documentOf(
  name: string,
  { offset, parts }: ObjShape,
  materialOf: (document: Document, material: number) => Material,
): Document {
  const document = new Document();
  const buffer = document.createBuffer();
  const accessor = () => document.createAccessor().setBuffer(buffer);
  const mesh = document.createMesh(name);
  for (const { material, positions, normals, texcoords, colors, indices } of parts) {
    const primitive = document
      .createPrimitive()
      .setAttribute('POSITION', accessor().setType('VEC3').setArray(positions))
      .setAttribute('TEXCOORD_0', accessor().setType('VEC2').setArray(texcoords))
      .setIndices(accessor().setArray(indices))
      .setMaterial(materialOf(document, material));
    if (normals) primitive.setAttribute('NORMAL', accessor().setType('VEC3').setArray(normals));
    if (colors) primitive.setAttribute('COLOR_0', accessor().setType('VEC3').setArray(colors));
    mesh.addPrimitive(primitive);
  }
  const node = document.createNode(name).setMesh(mesh).setTranslation(offset);
  document.createScene().addChild(node);
  return document;
}

const SLOTS = {
  baseColor: ['setBaseColorTexture', 'getBaseColorTextureInfo'],
  metallicRoughness: ['setMetallicRoughnessTexture', 'getMetallicRoughnessTextureInfo'],
  normal: ['setNormalTexture', 'getNormalTextureInfo'],
  emissive: ['setEmissiveTexture', 'getEmissiveTextureInfo'],
  occlusion: ['setOcclusionTexture', 'getOcclusionTextureInfo'],
} as const;

export type Slot = keyof typeof SLOTS;

const CLAMP = 33071;

/** Gives a material a texture, placed as the line of the OBJ's material says. */
export function putTexture(
  document: Document,
  material: Material,
  slot: Slot,
  texture: Texture,
  { scale, offset, isClamped }: MapPlacement,
): void {
  const [set, get] = SLOTS[slot];
  material[set](texture);
  const info = material[get]();
  if (isClamped) info?.setWrapS(CLAMP).setWrapT(CLAMP);
  const [[u, v], [x, y]] = [scale, offset];
  if (u === 1 && v === 1 && x === 0 && y === 0) return;
  const transform = document
    .createExtension(KHRTextureTransform)
    .createTransform()
    .setScale([u, v])
    // From v upwards to v downwards.
    .setOffset([x, 1 - v - y]);
  info?.setExtension('KHR_texture_transform', transform);
}
