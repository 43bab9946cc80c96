// The images that the materials of an OBJ use, and the colours of its vertices or those of a PLY.

import { meshFileOf } from '../base/mesh-files';
import type { DisplayMesh } from '../mesh/mesh';
import type { BakeSettings } from '../model/bake-settings';
import type { LayoutArrays } from '../model/model';
import { BAKED_OBJ } from '../words/baked-obj';
import { looksLikeNormals } from './image-channels';
import { fileNamed, nameOf } from './missing-files';
import { type MtlLine, type MtlMap, mtlLines } from './mtl-maps';
import { noCorners, type ObjCorners, readObjCorners } from './obj-corners';
import { type ObjShape, objShape } from './obj-document';
import { librariesOf } from './obj-look';
import { plyColors, ranged, type VertexColors } from './vertex-colors';

export interface ObjToBake {
  file: File;
  others: File[];
  mesh: DisplayMesh;
  layout: Pick<LayoutArrays, 'uv' | 'indices' | 'vertexMap'>;
  settings: BakeSettings;
  /** Of the files, without an ending. */
  name: string;
  /** The OBJ with the new layout, to be packed with its images; null: a GLB is wanted. */
  written: string | null;
}

/** How a map of a material uses an image. */
export interface Use {
  map: MtlMap;
  image: File;
}

/** The materials of an OBJ, and the images that they use. */
export class ObjImages {
  readonly notes: string[] = [];
  private readonly kinds = new Map<File, Promise<boolean>>();

  private constructor(
    readonly shape: ObjShape,
    readonly names: string[],
    readonly materials: Map<string, MtlLine[]>,
    private readonly others: File[],
  ) {}

  static async read({ file, others, mesh, layout, written }: ObjToBake): Promise<ObjImages> {
    const { obj, colors } = await cornersIn(file);
    const libraries = obj.libraries.flatMap((line) => librariesOf(line, others));
    const files = libraries.map((path) => fileNamed(path, others));
    const texts = await Promise.all(
      files.filter((each) => each !== undefined).map((f) => f.text()),
    );
    const materials = mtlLines(texts, obj.names);
    // Images beside an OBJ are for a mesh that keeps its colours.
    const shape = objShape(obj, written === null ? colors : null, mesh, layout);
    const found = new ObjImages(shape, obj.names, materials, others);
    const missing = libraries.filter((_, i) => !files[i]).map(nameOf);
    if (missing.length > 0) found.notes.push(BAKED_OBJ.missing(missing));
    found.noteMaps();
    return found;
  }

  mapsOf(material: number): MtlMap[] {
    const lines = this.materials.get(this.names[material] ?? '') ?? [];
    return lines.flatMap(({ map }) => (map ? [map] : []));
  }

  imageOf(map: MtlMap): File | undefined {
    return map.name ? fileNamed(map.path, this.others) : undefined;
  }

  /** Bumps may be normals or heights. */
  async isNormalMap({ name }: MtlMap, image: File): Promise<boolean> {
    if (name === 'normal') return true;
    if (name !== 'bump') return false;
    const known = this.kinds.get(image) ?? looksLikeNormals(image);
    this.kinds.set(image, known);
    return known;
  }

  /** The first use of a map by a material. */
  async useOf(material: number, name: string): Promise<Use | undefined> {
    for (const map of this.mapsOf(material)) {
      const image = this.imageOf(map);
      if (!image) continue;
      const own = (await this.isNormalMap(map, image)) ? 'normal' : map.name;
      if (own === name) return { map, image };
    }
    return undefined;
  }

  private noteMaps(): void {
    const maps = this.names.flatMap((_, material) => this.mapsOf(material));
    const absent = maps.filter((map) => map.name && !this.imageOf(map));
    const unknown = maps.filter((map) => !map.name);
    const once = (words: string[]) => [...new Set(words)];
    if (absent.length > 0)
      this.notes.push(BAKED_OBJ.missing(once(absent.map(({ path }) => nameOf(path)))));
    if (unknown.length > 0)
      this.notes.push(BAKED_OBJ.unknown(once(unknown.map(({ keyword }) => keyword))));
  }
}

/** Of a PLY, colours alone are baked. */
async function cornersIn(file: File): Promise<{ obj: ObjCorners; colors: VertexColors | null }> {
  if (meshFileOf(file.name)?.format === 'ply')
    return { obj: noCorners(), colors: plyColors(new Uint8Array(await file.arrayBuffer())) };
  const obj = readObjCorners(await file.text());
  return { obj, colors: obj.colors && ranged(obj.colors) };
}
