import type { Abflat, MeshInput } from 'abflat';
import { copied } from '../base/buffers';
import { tilesOfFile } from '../mesh/own-tiles';
import { cornerUv, type FileLayout } from '../model/arrangeable';
import type { PackChoices } from '../model/settings';

export interface PackingEvents {
  /** Work of abflat on the open mesh, beside its runs. */
  onMesh<T>(
    work: (abflat: Abflat, input: MeshInput, signal: AbortSignal) => Promise<T>,
  ): Promise<T>;
}

/** The coordinates with some islands packed around the others, each in the tile that it is in. */
export async function packedAround(
  { result, packed, gltf }: FileLayout,
  islands: ReadonlySet<number>,
  { tiles: _, ...choices }: PackChoices,
  { onMesh }: PackingEvents,
): Promise<Float64Array> {
  const { charts, atlas } = result.report;
  const { tiles: count } = packed.result.report;
  const corners = cornerUv(result);
  const made = await onMesh(async (abflat, input, signal) =>
    abflat.pack(await copied(gltf?.mesh ?? input), {
      ...choices,
      resolution: atlas.resolution,
      uv: corners,
      islands: Uint32Array.from(islands),
      ...(count > 1 && {
        tileOfIsland: tilesOfFile(corners, result.chartOfTriangle, charts.length),
      }),
      transfer: true,
      signal,
    }),
  );
  const uv = result.uv.slice();
  result.indices.forEach((v, c) => {
    for (const d of [0, 1]) uv[2 * v + d] = Math.fround(made.uv[2 * made.indices[c] + d]);
  });
  return uv;
}
