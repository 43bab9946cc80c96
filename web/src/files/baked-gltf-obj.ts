// A baked glTF as an OBJ, in an archive with its materials and their new images.

import type { Material } from '@gltf-transform/core';
import type { Abflat } from 'abflat';
import { type BakedTexture, bakeLayout, type DocumentMesh, documentMesh } from 'abflat/gltf';
import { strToU8, zipSync } from 'fflate';
import { srgbOf } from '../colors/srgb';
import type { BakeSettings } from '../model/bake-settings';
import type { GltfFiles, LayoutArrays } from '../model/model';
import { BAKED_OBJ } from '../words/baked-obj';
import type { BakedGltf } from './baked-gltf';
import { gltfIo, openGltf } from './gltf-source';
import { greyOf } from './image-channels';
import { decodeKtx2 } from './ktx2';

type Layout = Pick<LayoutArrays, 'uv' | 'indices'>;

/** `name`: of the files, without an ending. */
export async function bakeGltfAsObj(
  abflat: Pick<Abflat, 'bake'>,
  { file, others }: GltfFiles,
  layout: Layout,
  { side, ...atlas }: BakeSettings,
  name: string,
  onProgress: (fraction: number) => void,
): Promise<BakedGltf> {
  const { source } = await openGltf(file, others);
  const mesh = documentMesh(await gltfIo().readJSON(source));
  const names = mesh.parts.map(({ primitive }) => primitive.getMaterial()?.getName() ?? '');
  const olds = mesh.parts.map(({ primitive }) => primitive.getMaterial());
  const options = { ...atlas, bakeResolution: side, onProgress, decode: decodeKtx2 };
  const { baked, notes } = await bakeLayout(abflat, mesh, layout, options);
  const looks = new Map<Material | null, MtlLook>();
  mesh.parts.forEach(({ primitive }, i) => {
    const old = olds[i] as Material | null;
    const material = primitive.getMaterial() as Material;
    if (!looks.has(old)) looks.set(old, { name: names[i] as string, material });
  });
  settleNames([...looks.values()]);
  const { files, keywords } = await imagesOf(baked, name);
  files[`${name}.mtl`] = strToU8([...looks.values()].map((look) => mtlOf(look, keywords)).join(''));
  const nameOf = (part: number) => looks.get(olds[part] as Material | null)?.name as string;
  files[`${name}.obj`] = strToU8(objOf(mesh, layout, name, nameOf));
  const archive = zipSync(files, { level: 6 }) as Uint8Array<ArrayBuffer>;
  const lost = baked.some(({ maps }) => maps.includes('occlusion')) ? [BAKED_OBJ.noOcclusion] : [];
  return {
    file: new Blob([archive], { type: 'application/zip' }),
    images: baked.map(({ maps, side }) => ({ maps: maps.filter(isHeld), side })).filter(hasMaps),
    notes: [...notes, ...lost],
  };
}

const isHeld = (map: string) => map !== 'occlusion';
const hasMaps = ({ maps }: { maps: string[] }) => maps.length > 0;

interface MtlLook {
  name: string;
  material: Material;
}

/** Names that programs read back: without blanks, and each of its own. */
function settleNames(looks: MtlLook[]): void {
  const taken = new Set<string>();
  for (const look of looks) {
    const wanted = look.name.replace(/[\s\p{Cc}#\\]/gu, '_') || 'material';
    look.name = wanted;
    for (let k = 2; taken.has(look.name); ++k) look.name = `${wanted}_${k}`;
    taken.add(look.name);
  }
}

/** The files, and the name of each by the keyword of its map. */
async function imagesOf(baked: BakedTexture[], name: string) {
  const files: Record<string, Uint8Array> = {};
  const keywords = new Map<string, string>();
  const put = (keyword: string, map: string, bytes: Uint8Array) => {
    keywords.set(keyword, `${name}-${map}.png`);
    files[`${name}-${map}.png`] = bytes;
  };
  for (const { maps, texture } of baked) {
    const bytes = texture.getImage() as Uint8Array<ArrayBuffer>;
    const grey = async (channel: 1 | 2) =>
      new Uint8Array(await (await greyOf(new Blob([bytes]), channel)).arrayBuffer());
    if (maps.includes('baseColor')) put('map_Kd', 'diffuse', bytes);
    if (maps.includes('emissive')) put('map_Ke', 'emissive', bytes);
    // Blender reads the one, programs with normal maps of their own the other.
    if (maps.includes('normal'))
      for (const keyword of ['map_Bump -bm 1', 'norm']) put(keyword, 'normal', bytes);
    if (!maps.includes('metallicRoughness')) continue;
    put('map_Pr', 'roughness', await grey(1));
    put('map_Pm', 'metallic', await grey(2));
  }
  return { files, keywords };
}

const numbers = (keyword: string, values: number[]) =>
  [keyword, ...values.map((x) => Math.round(1e6 * x) / 1e6)].join(' ');

function mtlOf({ name, material }: MtlLook, keywords: Map<string, string>): string {
  const [r = 1, g = 1, b = 1, alpha = 1] = material.getBaseColorFactor();
  const isOpaque = material.getAlphaMode() === 'OPAQUE';
  const colour = keywords.get('map_Kd');
  // Programs take the alpha of such an image.
  const maps = [...keywords, ...(colour && !isOpaque ? [['map_d', colour]] : [])];
  const lines = [
    `newmtl ${name}`,
    numbers('Kd', [r, g, b].map(srgbOf)),
    // What glTF takes for granted.
    ...['Ks 0.5 0.5 0.5', 'Ni 1.5', 'illum 2'],
    numbers('Ke', material.getEmissiveFactor().map(srgbOf)),
    numbers('d', [isOpaque ? 1 : alpha]),
    numbers('Pr', [material.getRoughnessFactor()]),
    numbers('Pm', [material.getMetallicFactor()]),
    ...maps.map(([keyword, file]) => `${keyword} ${file}`),
  ];
  return `${lines.join('\n')}\n`;
}

function rows(keyword: string, values: ArrayLike<number>, width: number): string[] {
  const out: string[] = [];
  for (let i = 0; i < values.length; i += width)
    out.push([keyword, ...Array.from({ length: width }, (_, d) => values[i + d])].join(' '));
  return out;
}

function objOf(
  { positions, normals, indices, parts }: DocumentMesh,
  layout: Layout,
  name: string,
  materialOf: (part: number) => string,
): string {
  const lines = [`mtllib ${name}.mtl`, ...rows('v', positions, 3), ...rows('vt', layout.uv, 2)];
  if (normals) lines.push(...rows('vn', normals, 3));
  const corner = (c: number) => {
    const v = (indices[c] as number) + 1;
    const uv = (layout.indices[c] as number) + 1;
    return normals ? `${v}/${uv}/${v}` : `${v}/${uv}`;
  };
  parts.forEach(({ firstTriangle, triangleCount }, part) => {
    lines.push(`usemtl ${materialOf(part)}`);
    for (let c = 3 * firstTriangle; c < 3 * (firstTriangle + triangleCount); c += 3)
      lines.push(`f ${corner(c)} ${corner(c + 1)} ${corner(c + 2)}`);
  });
  return `${lines.join('\n')}\n`;
}
