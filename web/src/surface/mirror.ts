import { edgeBetween, type SurfaceGraph } from './surface-graph';

/** Of the size of the mesh: images of vertices may be off by as much. */
const NEAR = 1e-3;
/** Of all places, the share that needs an image. */
const ENOUGH = 0.5;

/** The mirror image of each place across the plane of a mesh; -1 where there is none. */
export type MirrorMap = Int32Array;

/**
 * Across the plane through the middle of the mesh, or through the origin, along two axes, that has most images;
 * null if none has enough. `positions`: xyz per vertex.
 */
export function mirrorMap({ places }: SurfaceGraph, positions: Float64Array): MirrorMap | null {
  const used = [...new Set(places)];
  const box = [0, 1, 2].map((d) => {
    const along = used.map((v) => positions[3 * v + d]);
    return [Math.min, Math.max].map((end) => along.reduce((a, b) => end(a, b), along[0] ?? 0));
  });
  const near = NEAR * Math.max(...box.map(([low, high]) => high - low));
  if (!(near > 0)) return null;
  const nearest = nearestPlace(used, positions, near);
  let best: { map: MirrorMap; images: number } | null = null;
  for (const [d, [low, high]] of box.entries())
    for (const middle of new Set([(low + high) / 2, 0])) {
      const map = new Int32Array(places.length).fill(-1);
      let images = 0;
      for (const v of used) {
        const image = [...positions.subarray(3 * v, 3 * v + 3)];
        image[d] = 2 * middle - image[d];
        map[v] = nearest(image);
        images += Number(map[v] >= 0);
      }
      if (images >= ENOUGH * used.length && images > (best?.images ?? 0)) best = { map, images };
    }
  return best?.map ?? null;
}

/** Edges and their images. */
export function withImages(graph: SurfaceGraph, map: MirrorMap, edges: number[]): number[] {
  const { ends } = graph;
  const images = edges.map((edge) => {
    const [a, b] = [map[ends[2 * edge]], map[ends[2 * edge + 1]]];
    return a < 0 || b < 0 ? -1 : edgeBetween(graph, a, b);
  });
  return [...new Set([...edges, ...images.filter((edge) => edge >= 0)])];
}

/** Finds the vertex within a distance of a point, among those in the cells around it; -1 if there is none. */
function nearestPlace(vertices: number[], positions: Float64Array, near: number) {
  const cells = new Map<string, number[]>();
  const cellOf = (point: ArrayLike<number>, at = 0) =>
    [0, 1, 2].map((d) => Math.floor(point[at + d] / near));
  for (const v of vertices) {
    const name = String(cellOf(positions, 3 * v));
    const cell = cells.get(name);
    if (cell) cell.push(v);
    else cells.set(name, [v]);
  }
  return (point: number[]): number => {
    const [x, y, z] = cellOf(point);
    let [nearest, least] = [-1, near];
    for (const i of [x - 1, x, x + 1])
      for (const j of [y - 1, y, y + 1])
        for (const k of [z - 1, z, z + 1])
          for (const v of cells.get(String([i, j, k])) ?? []) {
            const away = [0, 1, 2].map((d) => positions[3 * v + d] - point[d]);
            const distance = Math.hypot(...away);
            if (distance <= least) [nearest, least] = [v, distance];
          }
    return nearest;
  };
}
