import { byteOf } from '../colors/srgb';
import { OPAQUE, Wrap } from '../model/appearance';
import { CornerWriter, tintOf } from './corner-looks';
import { type PlyNumbers, plyVertexNumbers } from './ply-vertices';
import type { LookMesh, StoredLook } from './stored-look';

/** Under the names that programs use. */
const COLORS = [
  ['red', 'green', 'blue'],
  ['diffuse_red', 'diffuse_green', 'diffuse_blue'],
  ['r', 'g', 'b'],
];

/** Colours of vertices; null if they have none. */
export async function readPlyLook(file: File, mesh: LookMesh): Promise<StoredLook | null> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  for (const names of COLORS) {
    const numbers = plyVertexNumbers(bytes, names);
    if (!numbers) continue;
    const material = {
      image: null,
      wrap: [Wrap.Repeat, Wrap.Repeat] as [Wrap, Wrap],
      isPixelated: false,
      cutoff: OPAQUE,
      isUnlit: false,
    };
    return { corners: cornersOf(mesh, numbers), materials: [material], images: [], missing: [] };
  }
  return null;
}

/** Integers are fractions of the largest value of their type; floats above 1 mean 0 to 255. */
function cornersOf({ indices }: LookMesh, { values, largest }: PlyNumbers): CornerWriter {
  const isByte = largest === 1 && values.some((each) => each > 1);
  const scale = 1 / (isByte ? 255 : largest);
  const corners = new CornerWriter(indices.length);
  for (let c = 0; c < indices.length; ++c) {
    const [red, green, blue] = [0, 1, 2].map((d) => byteOf(scale * values[3 * indices[c] + d]));
    corners.set(c, { u: 0, v: 0, material: 0, tint: tintOf(red, green, blue, 255) });
  }
  return corners;
}
