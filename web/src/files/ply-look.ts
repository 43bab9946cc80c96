import { byteOf } from '../colors/srgb';
import { OPAQUE, Wrap } from '../model/appearance';
import { CornerWriter, tintOf } from './corner-looks';
import type { LookMesh, StoredLook } from './stored-look';
import { plyColors, type VertexColors } from './vertex-colors';

/** Colours of vertices; null if they have none. */
export async function readPlyLook(file: File, mesh: LookMesh): Promise<StoredLook | null> {
  const colors = plyColors(new Uint8Array(await file.arrayBuffer()));
  if (!colors) return null;
  const material = {
    image: null,
    wrap: [Wrap.Repeat, Wrap.Repeat] as [Wrap, Wrap],
    isPixelated: false,
    cutoff: OPAQUE,
    isUnlit: false,
  };
  return { corners: cornersOf(mesh, colors), materials: [material], images: [], missing: [] };
}

function cornersOf({ indices }: LookMesh, colors: VertexColors): CornerWriter {
  const corners = new CornerWriter(indices.length);
  for (let c = 0; c < indices.length; ++c) {
    const [red, green, blue] = [0, 1, 2].map((d) => byteOf(colors[3 * indices[c] + d]));
    corners.set(c, { u: 0, v: 0, material: 0, tint: tintOf(red, green, blue, 255) });
  }
  return corners;
}
