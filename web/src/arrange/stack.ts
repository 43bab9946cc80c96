import { type ChartArrays, pointOf, trianglesOf } from './charts';
import type { Motion, Point } from './motion';
import type { Motions } from './move-charts';

/** Relative to the size of a chart: outlines closer than that are the same. */
const SAME = 2e-3;

interface Shape {
  chart: number;
  triangles: number;
  /** Corners of the outline, in order. */
  outline: Point[];
}

/**
 * Puts charts of the same shape on top of each other: each on the first that it fits. Charts that
 * are only to be put under others are listed in `fixed`, others stay if nothing fits.
 */
export function stacked(arrays: ChartArrays, charts: Uint32Array, fixed: Uint32Array): Motions {
  const bases = shapesOf(arrays, fixed);
  const found: [number, Motion][] = [];
  for (const shape of shapesOf(arrays, charts)) {
    const motion = firstOf(bases, (base) => fit(shape, base));
    if (motion) found.push([shape.chart, motion]);
    else bases.push(shape);
  }
  return {
    charts: Uint32Array.from(found, ([chart]) => chart),
    motions: found.map(([, motion]) => motion),
  };
}

function firstOf<T, R>(all: T[], find: (each: T) => R | null): R | null {
  for (const each of all) {
    const found = find(each);
    if (found !== null) return found;
  }
  return null;
}

function shapesOf(arrays: ChartArrays, charts: Uint32Array): Shape[] {
  const triangles = trianglesOf(arrays.chartOfTriangle, charts);
  return [...charts].map((chart) => {
    const own = triangles.get(chart) ?? [];
    const outline = outlineOf(arrays.indices, own).map((v) => pointOf(arrays.uv, v));
    return { chart, triangles: own.length, outline };
  });
}

/** The vertices around some triangles that form a disk. */
function outlineOf(indices: Uint32Array, triangles: number[]): number[] {
  const next = new Map<number, number>();
  const inner = new Set<string>();
  const sides = triangles.flatMap((f) =>
    [0, 1, 2].map((k) => [indices[3 * f + k], indices[3 * f + ((k + 1) % 3)]] as const),
  );
  for (const [from, to] of sides) inner.add(`${to} ${from}`);
  for (const [from, to] of sides) if (!inner.has(`${from} ${to}`)) next.set(from, to);
  const [first] = next.keys();
  const outline: number[] = [];
  for (let v = first; v !== undefined && outline.length < next.size; v = next.get(v) as number)
    outline.push(v);
  return outline;
}

/** The motion that takes a shape onto a base with the least turn; null if they differ. */
function fit(shape: Shape, base: Shape): Motion | null {
  const count = shape.outline.length;
  if (count < 3 || count !== base.outline.length || shape.triangles !== base.triangles) return null;
  const [from, to] = [sidesOf(shape.outline), sidesOf(base.outline)];
  let best: Motion | null = null;
  for (let shift = 0; shift < count; ++shift) {
    if (!hasSameSides(from, to, shift)) continue;
    const motion = bestMotion(shape.outline, base.outline, shift);
    if (motion && turnOf(motion) < (best ? turnOf(best) : Infinity)) best = motion;
  }
  return best;
}

const turnOf = ({ a, b }: Motion) => Math.abs(Math.atan2(b, a));

/** The lengths of an outline's sides, as shares of the longest. */
function sidesOf(outline: Point[]): Float64Array {
  const lengths = Float64Array.from(outline, ([x, y], i) => {
    const [toX, toY] = outline[(i + 1) % outline.length];
    return Math.hypot(toX - x, toY - y);
  });
  const longest = lengths.reduce((most, length) => Math.max(most, length), 0);
  return lengths.map((length) => length / longest);
}

function hasSameSides(a: Float64Array, b: Float64Array, shift: number): boolean {
  for (let i = 0; i < a.length; ++i)
    if (Math.abs(a[i] - b[(i + shift) % b.length]) > 0.02) return false;
  return true;
}

/** The least squares fit of one outline to the other; null if it leaves too much between them. */
function bestMotion(from: Point[], to: Point[], shift: number): Motion | null {
  const count = from.length;
  const target = (i: number) => to[(i + shift) % count];
  const mean = (points: Point[]): Point => [
    points.reduce((sum, [x]) => sum + x, 0) / count,
    points.reduce((sum, [, y]) => sum + y, 0) / count,
  ];
  const [[fx, fy], [tx, ty]] = [mean(from), mean(to)];
  let [dot, cross, square] = [0, 0, 0];
  from.forEach(([x, y], i) => {
    const [u, v] = [x - fx, y - fy];
    const [p, q] = [target(i)[0] - tx, target(i)[1] - ty];
    dot += u * p + v * q;
    cross += u * q - v * p;
    square += u * u + v * v;
  });
  const [a, b] = [dot / square, cross / square];
  const motion = { a, b, x: tx - a * fx + b * fy, y: ty - b * fx - a * fy };
  const size = Math.hypot(a, b) * Math.sqrt(square / count);
  const isFar = from.some(([x, y], i) => {
    const [p, q] = target(i);
    return Math.hypot(a * x - b * y + motion.x - p, b * x + a * y + motion.y - q) > SAME * size;
  });
  return isFar || !(size > 0) ? null : motion;
}
