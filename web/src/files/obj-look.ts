import { byteOf } from '../colors/srgb';
import { sourceCorners } from '../mesh/source-corners';
import { BLENDED, type MaterialLook, OPAQUE, Wrap } from '../model/appearance';
import { CornerWriter, tintOf } from './corner-looks';
import { fileNamed, nameOf } from './missing-files';
import { type MtlMaterial, readMtl } from './mtl';
import { NO_TEXCOORD, type ObjCorners, readObjCorners } from './obj-corners';
import type { LookMesh, StoredImage, StoredLook } from './stored-look';
import { ranged } from './vertex-colors';

/** Null if the file has neither materials nor colours. */
export async function readObjLook(
  file: File,
  others: File[],
  mesh: LookMesh,
): Promise<StoredLook | null> {
  const obj = readObjCorners(await file.text());
  const usesMaterials = obj.names.length > 1;
  if (!usesMaterials && !obj.colors) return null;
  const missing: string[] = [];
  const found = usesMaterials ? await materialsOf(obj.libraries, others, missing) : new Map();
  const mtls = obj.names.map((name) => found.get(name));
  const images: StoredImage[] = [];
  const materials = mtls.map((mtl) => lookOf(mtl, imageOf(mtl, others, images, missing)));
  return { corners: cornersOf(obj, mtls, mesh), materials, images, missing };
}

/** The first library that has a material counts. */
async function materialsOf(
  lines: string[],
  others: File[],
  missing: string[],
): Promise<Map<string, MtlMaterial>> {
  const found = new Map<string, MtlMaterial>();
  for (const library of lines.flatMap((line) => librariesOf(line, others))) {
    const file = fileNamed(library, others);
    if (!file) missing.push(nameOf(library));
    else
      for (const [name, material] of readMtl(await file.text()))
        if (!found.has(name)) found.set(name, material);
  }
  return found;
}

/** A name may contain blanks, and a line may have several names. */
export function librariesOf(line: string, others: File[]): string[] {
  const words = line.split(/\s+/);
  return words.some((word) => fileNamed(word, others)) ? words : [line];
}

/** The number of a material's image, which is added if it is new. */
function imageOf(
  mtl: MtlMaterial | undefined,
  others: File[],
  images: StoredImage[],
  missing: string[],
): number | null {
  if (!mtl?.map) return null;
  const file = fileNamed(mtl.map, others);
  if (!file) {
    missing.push(nameOf(mtl.map));
    return null;
  }
  const known = images.findIndex(({ bytes }) => bytes === file);
  if (known >= 0) return known;
  return images.push({ name: file.name, bytes: file, isPixelated: false }) - 1;
}

function lookOf(mtl: MtlMaterial | undefined, image: number | null): MaterialLook {
  const wrap = mtl?.isClamped ? Wrap.Clamp : Wrap.Repeat;
  const isTranslucent = mtl !== undefined && (mtl.hasAlpha || mtl.opacity < 1);
  return {
    image,
    wrap: [wrap, wrap],
    isPixelated: false,
    cutoff: isTranslucent ? BLENDED : OPAQUE,
    isUnlit: false,
  };
}

function cornersOf(
  obj: ObjCorners,
  mtls: (MtlMaterial | undefined)[],
  mesh: LookMesh,
): CornerWriter {
  const corners = new CornerWriter(mesh.indices.length);
  const source = sourceCorners(mesh, obj);
  const colors = obj.colors && ranged(obj.colors);
  for (let c = 0; c < mesh.indices.length; ++c) {
    const triangle = Math.floor(c / 3);
    const material = obj.materials[mesh.faces ? mesh.faces[triangle] : triangle] ?? 0;
    const mtl = mtls[material];
    const [u, v] = placeOf(obj, source[c], mtl);
    corners.set(c, { u, v, material, tint: tintAt(mtl, colors, mesh.indices[c]) });
  }
  return corners;
}

function placeOf(
  { texcoords, texcoordOf }: ObjCorners,
  corner: number,
  mtl: MtlMaterial | undefined,
): [number, number] {
  const t = texcoordOf[corner] ?? NO_TEXCOORD;
  if (t === NO_TEXCOORD) return [0, 0];
  const { scale, offset } = mtl ?? { scale: [1, 1], offset: [0, 0] };
  const [u, v] = [texcoords[2 * t], texcoords[2 * t + 1]];
  return [scale[0] * u + offset[0], 1 - (scale[1] * v + offset[1])];
}

/** An image replaces the material's colour: many programs write black or grey next to one. */
function tintAt(mtl: MtlMaterial | undefined, colors: number[] | null, vertex: number): number {
  const base = mtl && !mtl.map ? mtl.diffuse : [1, 1, 1];
  const [red, green, blue] = base.map((each, d) => {
    const own = colors?.[3 * vertex + d] ?? 1;
    return byteOf(each * (Number.isFinite(own) ? own : 1));
  });
  return tintOf(red, green, blue, byteOf(mtl?.opacity ?? 1));
}
