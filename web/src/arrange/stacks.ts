import type { Stack, Stacks } from '../model/stacks';
import {
  type Box,
  boxOf,
  type ChartArrays,
  isChart,
  pointOf,
  trianglesOf,
  verticesOf,
} from './charts';
import { type Motion, moved, type Point } from './motion';

/**
 * Finds the stacks of an atlas. Outlines are compared bit by bit in single precision, to which moved
 * charts are rounded: charts that merely overlap are no stack.
 */
export function stacksOf(arrays: ChartArrays): Stacks {
  const charts = Uint32Array.from([...new Set(arrays.chartOfTriangle)].filter(isChart)).sort();
  const vertices = verticesOf(arrays, charts);
  const sameBox = grouped(charts, (chart) => nameOf(boxOf(arrays.uv, vertices.get(chart) ?? [])));
  const triangles = trianglesOf(arrays.chartOfTriangle, Uint32Array.from(sameBox.flat()));
  const own = (chart: number) => triangles.get(chart) ?? [];
  const stacks = sameBox.flatMap((some) =>
    grouped(some, (chart) =>
      outlineOf(arrays, own(chart))
        .map(([from, to]) => `${rounded(arrays, from)} ${rounded(arrays, to)}`)
        .sort()
        .join(),
    ),
  );
  const repeated = stacks.reduce(
    (sum, stack) =>
      sum + (stack.length - 1) * own(stack[0]).reduce((area, f) => area + areaOf(arrays, f), 0),
    0,
  );
  return { stacks, repeated };
}

const nameOf = ({ low, high }: Box) => [...low, ...high].map(Math.fround).join();

/** Those with the same name, where there are several. */
export function grouped(charts: Iterable<number>, name: (chart: number) => string): number[][] {
  const groups = new Map<string, number[]>();
  for (const chart of charts) {
    const own = name(chart);
    groups.set(own, [...(groups.get(own) ?? []), chart]);
  }
  return [...groups.values()].filter(({ length }) => length > 1);
}

/** The edges around some triangles, in their direction. */
export function outlineOf({ indices }: Pick<ChartArrays, 'indices'>, triangles: number[]) {
  const sides = triangles.flatMap((f) =>
    [0, 1, 2].map((k) => [indices[3 * f + k], indices[3 * f + ((k + 1) % 3)]] as const),
  );
  const inner = new Set(sides.map(([from, to]) => `${to} ${from}`));
  return sides.filter(([from, to]) => !inner.has(`${from} ${to}`));
}

/** In uv; negative if it is flipped. */
export function areaOf({ uv, indices }: Pick<ChartArrays, 'uv' | 'indices'>, f: number): number {
  const [[x, y], [x1, y1], [x2, y2]] = [0, 1, 2].map((k) => pointOf(uv, indices[3 * f + k]));
  return ((x1 - x) * (y2 - y) - (x2 - x) * (y1 - y)) / 2;
}

/**
 * The coordinates with each chart of a stack in tiles of its own, `rows` above those of the chart
 * below, so that each can be checked beside all other charts. Null if not every coordinate can be
 * moved there without being rounded.
 */
export function apart(arrays: ChartArrays, stacks: Stack[], rows: number): Float64Array | null {
  const uv = arrays.uv.slice();
  const vertices = verticesOf(arrays, Uint32Array.from(stacks.flat()));
  for (const stack of stacks)
    for (const [layer, chart] of stack.entries())
      for (const v of vertices.get(chart) ?? []) {
        uv[2 * v + 1] += layer * rows;
        if (uv[2 * v + 1] - layer * rows !== arrays.uv[2 * v + 1]) return null;
      }
  return uv;
}

/**
 * The coordinates with stacks as they were `before`, wherever their lowest charts are now; the
 * triangles are the same in both. Null if a chart of a stack has become another one.
 */
export function restacked(
  before: ChartArrays,
  now: ChartArrays,
  stacks: Stack[],
): Float64Array | null {
  const uv = now.uv.slice();
  const triangles = trianglesOf(before.chartOfTriangle, Uint32Array.from(stacks.flat()));
  const sizes = new Map<number, number>();
  for (const chart of now.chartOfTriangle) sizes.set(chart, (sizes.get(chart) ?? 0) + 1);
  const isWhole = (own: number[]) => {
    const chart = now.chartOfTriangle[own[0]];
    return sizes.get(chart) === own.length && own.every((f) => now.chartOfTriangle[f] === chart);
  };
  const own = (chart: number) => triangles.get(chart) ?? [];
  if (!stacks.flat().every((chart) => isWhole(own(chart)))) return null;
  for (const [lowest, ...others] of stacks) {
    const motion = motionOf(before, now, own(lowest));
    const places = new Map<string, Point>();
    for (const c of cornersOf(own(lowest)))
      places.set(String(pointOf(before.uv, before.indices[c])), rounded(now, now.indices[c]));
    for (const c of cornersOf(own(lowest)))
      uv.set(rounded(now, now.indices[c]), 2 * now.indices[c]);
    for (const c of others.flatMap((chart) => cornersOf(own(chart)))) {
      const at = pointOf(before.uv, before.indices[c]);
      const [x, y] = places.get(String(at)) ?? moved(motion, at).map(Math.fround);
      uv.set([x, y], 2 * now.indices[c]);
    }
  }
  return uv;
}

const rounded = ({ uv }: ChartArrays, v: number) => pointOf(uv, v).map(Math.fround) as Point;

const cornersOf = (triangles: number[]) => triangles.flatMap((f) => [3 * f, 3 * f + 1, 3 * f + 2]);

/** How a chart has been moved: the least squares fit over its corners. */
function motionOf(before: ChartArrays, now: ChartArrays, triangles: number[]): Motion {
  const corners = cornersOf(triangles);
  const from = corners.map((c) => pointOf(before.uv, before.indices[c]));
  const to = corners.map((c) => pointOf(now.uv, now.indices[c]));
  return bestMotion(from, to);
}

/** The least squares fit of some points to others. */
export function bestMotion(from: Point[], to: Point[]): Motion {
  const mean = (points: Point[]): Point => [
    points.reduce((sum, [x]) => sum + x, 0) / points.length,
    points.reduce((sum, [, y]) => sum + y, 0) / points.length,
  ];
  const [[fx, fy], [tx, ty]] = [mean(from), mean(to)];
  let [dot, cross, square] = [0, 0, 0];
  from.forEach(([x, y], i) => {
    const [u, v] = [x - fx, y - fy];
    const [p, q] = [to[i][0] - tx, to[i][1] - ty];
    dot += u * p + v * q;
    cross += u * q - v * p;
    square += u * u + v * v;
  });
  const [a, b] = [dot / square, cross / square];
  return { a, b, x: tx - a * fx + b * fy, y: ty - b * fx - a * fy };
}
