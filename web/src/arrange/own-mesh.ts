import { edgesOfOne } from '../mesh/outline-edges';
import { weld } from '../mesh/weld';
import type { ChartMesh } from './chart-mesh';
import { pointOf } from './charts';
import { areaOf } from './stacks';

/** A chart whose vertices at the same point of uv are one: the first of them. */
export interface OwnMesh {
  indices: Uint32Array;
  /** Its outline, counterclockwise, and those of its holes, clockwise. */
  loop: number[];
  holes: number[][];
  /** That vertex, for each vertex of the chart. */
  same: Uint32Array;
}

/** Null if an outline touches itself. */
export function ownMesh({ texcoords, indices }: ChartMesh): OwnMesh | null {
  const same = weld(texcoords, 2);
  const own = indices.map((v) => same[v]);
  const loops = loopsOf(edgesOfOne(indices, same));
  if (!loops || loops.length === 0) return null;
  const areas = loops.map((loop) => areaWithin(loop, texcoords));
  const outer = areas.indexOf(areas.reduce((a, b) => Math.max(a, b)));
  const holes = loops.filter((_, i) => i !== outer);
  return { indices: own, loop: loops[outer], holes, same };
}

/** The loops of edges, two vertices each. */
function loopsOf(ends: Uint32Array): number[][] | null {
  const next = new Map<number, number>();
  for (let i = 0; i < ends.length; i += 2) next.set(ends[i], ends[i + 1]);
  if (next.size < ends.length / 2) return null;
  const loops: number[][] = [];
  for (let [start] = next.keys(); start !== undefined; [start] = next.keys()) {
    const loop: number[] = [];
    for (let v: number | undefined = start; v !== undefined; ) {
      const to = next.get(v);
      if (to !== undefined) loop.push(v);
      next.delete(v);
      v = to;
    }
    loops.push(loop);
  }
  return loops;
}

const areaWithin = (loop: readonly number[], uv: Float64Array): number =>
  loop.reduce((sum, v, i) => {
    const [[x0, y0], [x1, y1]] = [v, loop[(i + 1) % loop.length]].map((each) => pointOf(uv, each));
    return sum + (x0 * y1 - x1 * y0) / 2;
  }, 0);

/** Whether most of it runs clockwise in the layout. */
export function isMirrored({ texcoords: uv, indices }: ChartMesh): boolean {
  let sum = 0;
  for (let f = 0; 3 * f < indices.length; ++f) sum += areaOf({ uv, indices }, f);
  return sum < 0;
}

/** The mirror image of a layout; that of it is the layout again. */
export const mirrored = (uv: Float64Array): Float64Array =>
  uv.map((x, i) => (i % 2 === 0 ? -x : x));

/** The chart with its holes filled by triangles around their middles, which are vertices behind all others. */
export function filled(
  { positions }: Pick<ChartMesh, 'positions'>,
  { indices, holes }: OwnMesh,
): { positions: Float64Array; indices: Uint32Array } {
  const count = positions.length / 3;
  const middles = holes.map((hole) =>
    [0, 1, 2].map((d) => hole.reduce((sum, v) => sum + positions[3 * v + d], 0) / hole.length),
  );
  const fans = holes.map((hole, i) =>
    hole.map((from, k) => [hole[(k + 1) % hole.length], from, count + i]),
  );
  return {
    positions: joined(Float64Array, positions, middles.flat()),
    indices: joined(Uint32Array, indices, fans.flat(2)),
  };
}

function joined<T extends Float64Array | Uint32Array>(
  Kind: new (length: number) => T,
  first: T,
  more: number[],
): T {
  const all = new Kind(first.length + more.length);
  all.set(first);
  all.set(more, first.length);
  return all;
}
