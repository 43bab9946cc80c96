import { edgeBetween, type SurfaceGraph } from './surface-graph';

/** Of the size of the mesh: images of places may be off by as much. */
const NEAR = 1e-3;
/** Cells in which places are looked for have so many times that size. */
const CELL = 16;
/** Of the places that are tried, the share that needs an image; a part of a mesh may have none. */
const ENOUGH = 0.5;
const TRIED = 1000;

/** The mirror image of a place; -1 if there is none. */
export type Mirror = (place: number) => number;

/**
 * Across the plane that has most images: through the middle of the mesh or the origin, along two axes. Null if none
 * has enough. `positions`: xyz per vertex.
 */
export function mirrorOf({ places }: SurfaceGraph, positions: Float64Array): Mirror | null {
  const used = [...new Set(places)];
  const box = [0, 1, 2].map((d) => {
    const along = used.map((v) => positions[3 * v + d]);
    const [low, high] = [Math.min, Math.max].map((end) => along.reduce((a, b) => end(a, b)));
    return { low, high };
  });
  const near = NEAR * Math.max(...box.map(({ low, high }) => high - low));
  if (!(near > 0)) return null;
  const nearest = nearestPlace(used, positions, near);
  const step = Math.ceil(used.length / TRIED);
  const tried = used.filter((_, i) => i % step === 0);
  let [best, most]: [Mirror | null, number] = [null, 0];
  for (const [d, { low, high }] of box.entries())
    for (const middle of new Set([(low + high) / 2, 0])) {
      const mirror = (v: number) => {
        const image = [...positions.subarray(3 * v, 3 * v + 3)];
        image[d] = 2 * middle - image[d];
        return nearest(image);
      };
      const images = tried.filter((v) => mirror(v) >= 0).length;
      if (images > most) [best, most] = [mirror, images];
    }
  return most >= ENOUGH * tried.length ? best : null;
}

/** Edges and their images. */
export function withImages(graph: SurfaceGraph, mirror: Mirror, edges: number[]): number[] {
  const images = edges.map((edge) => {
    const [a, b] = [...graph.ends.subarray(2 * edge, 2 * edge + 2)].map(mirror);
    return a < 0 || b < 0 ? -1 : edgeBetween(graph, a, b);
  });
  return [...new Set([...edges, ...images.filter((edge) => edge >= 0)])];
}

/** Finds the vertex within a distance of a point; -1 if there is none. */
function nearestPlace(vertices: number[], positions: Float64Array, near: number) {
  const cells = new Map<string, number[]>();
  const along = (x: number) => Math.floor(x / (CELL * near));
  for (const v of vertices) {
    const name = [...positions.subarray(3 * v, 3 * v + 3)].map(along).join();
    const cell = cells.get(name);
    if (cell) cell.push(v);
    else cells.set(name, [v]);
  }
  /** Where something as near as that may be: mostly one cell. */
  const around = (x: number) => new Set([along(x - near), along(x + near)]);
  return (point: readonly number[]): number => {
    const [x, y, z] = point.map(around);
    let [nearest, least] = [-1, near];
    for (const i of x)
      for (const j of y)
        for (const k of z)
          for (const v of cells.get(`${i},${j},${k}`) ?? []) {
            const distance = Math.hypot(...point.map((at, d) => at - positions[3 * v + d]));
            if (distance <= least) [nearest, least] = [v, distance];
          }
    return nearest;
  };
}
