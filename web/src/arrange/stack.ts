import { type ChartArrays, pointOf, trianglesOf } from './charts';
import { type Motion, moved, type Point } from './motion';
import { type Motions, movedUv } from './move-charts';
import { areaOf, bestMotion, outlineOf } from './stacks';

/** Relative to the size of a chart: outlines closer than that are the same. */
const SAME = 2e-3;

export interface Shape {
  chart: number;
  triangles: number[];
  /** Vertices of the outline, in order. */
  loop: number[];
  /** Their places. */
  outline: Point[];
}

/** How a chart is put on another one. */
interface Fit {
  motion: Motion;
  /** The vertices of its outline, each with the one whose place it takes. */
  onto: [number, number][];
}

/**
 * Puts charts of the same shape on top of each other: each on the first that it fits. Charts that
 * are only to be put under others are listed in `fixed`, others stay if nothing fits. Their outlines
 * are the same then, bit by bit.
 */
export function stacked(arrays: ChartArrays, charts: Uint32Array, fixed: Uint32Array): Motions {
  const bases = shapesOf(arrays, fixed);
  const used = new Set<Shape>();
  const found: [number, Fit][] = [];
  for (const shape of shapesOf(arrays, charts)) {
    const fitting = firstOf(bases, (base) => {
      const each = fit(arrays, shape, base);
      if (each) used.add(base);
      return each;
    });
    if (fitting) found.push([shape.chart, fitting]);
    else bases.push(shape);
  }
  return {
    charts: Uint32Array.from(found, ([chart]) => chart),
    motions: found.map(([, { motion }]) => motion),
    onto: Uint32Array.from(found.flatMap(([, { onto }]) => onto.flat())),
    below: used.size,
  };
}

function firstOf<T, R>(all: T[], find: (each: T) => R | null): R | null {
  for (const each of all) {
    const found = find(each);
    if (found !== null) return found;
  }
  return null;
}

export function shapesOf(arrays: ChartArrays, charts: Uint32Array): Shape[] {
  const triangles = trianglesOf(arrays.chartOfTriangle, charts);
  return [...charts].map((chart) => {
    const own = triangles.get(chart) ?? [];
    const loop = loopOf(arrays, own);
    return { chart, triangles: own, loop, outline: loop.map((v) => pointOf(arrays.uv, v)) };
  });
}

/** The vertices around some triangles that form a disk; none if they form something else. */
function loopOf(arrays: ChartArrays, triangles: number[]): number[] {
  const sides = outlineOf(arrays, triangles);
  const next = new Map(sides);
  if (next.size < sides.length) return [];
  const [first] = next.keys();
  const loop: number[] = [];
  for (let v = first; v !== undefined && loop.length < next.size; v = next.get(v) as number) {
    if (v === first && loop.length > 0) return [];
    loop.push(v);
  }
  return loop;
}

/** Takes a shape onto a base with the least turn; null if they differ. */
function fit(arrays: ChartArrays, shape: Shape, base: Shape): Fit | null {
  const count = shape.loop.length;
  if (count < 3 || count !== base.loop.length || shape.triangles.length !== base.triangles.length)
    return null;
  const [from, to] = [sidesOf(shape.outline), sidesOf(base.outline)];
  let best: Fit | null = null;
  for (let shift = 0; shift < count; ++shift) {
    if (!hasSameSides(from, to, shift)) continue;
    const motion = closeMotion(shape.outline, base.outline, shift);
    if (!motion || turnOf(motion) >= (best ? turnOf(best.motion) : Infinity)) continue;
    const onto = shape.loop.map((v, i): [number, number] => [v, base.loop[(i + shift) % count]]);
    if (!hasFlips(arrays, shape, { motion, onto })) best = { motion, onto };
  }
  return best;
}

/** Whether a triangle would be flipped where the outline is not exactly the same. */
function hasFlips(
  arrays: ChartArrays,
  { chart, triangles }: Shape,
  { motion, onto }: Fit,
): boolean {
  const charts = Uint32Array.of(chart);
  const uv = movedUv(arrays, { charts, motions: [motion], onto: Uint32Array.from(onto.flat()) });
  return triangles.some((f) => areaOf({ ...arrays, uv }, f) <= 0 && areaOf(arrays, f) > 0);
}

const turnOf = ({ a, b }: Motion) => Math.abs(Math.atan2(b, a));

/** The lengths of an outline's sides, as shares of the longest. */
export function sidesOf(outline: Point[]): Float64Array {
  const lengths = Float64Array.from(outline, ([x, y], i) => {
    const [toX, toY] = outline[(i + 1) % outline.length];
    return Math.hypot(toX - x, toY - y);
  });
  const longest = lengths.reduce((most, length) => Math.max(most, length), 0);
  return lengths.map((length) => length / longest);
}

export function hasSameSides(a: Float64Array, b: Float64Array, shift: number): boolean {
  for (let i = 0; i < a.length; ++i)
    if (Math.abs(a[i] - b[(i + shift) % b.length]) > 0.02) return false;
  return true;
}

/** The least squares fit of one outline to the other; null if it leaves too much between them. */
export function closeMotion(from: Point[], to: Point[], shift: number): Motion | null {
  const target = from.map((_, i) => to[(i + shift) % to.length]);
  const motion = bestMotion(from, target);
  const size = Math.hypot(motion.a, motion.b) * spreadOf(from);
  const isFar = from.some((point, i) => {
    const [x, y] = moved(motion, point);
    return Math.hypot(x - target[i][0], y - target[i][1]) > SAME * size;
  });
  return isFar || !(size > 0) ? null : motion;
}

/** The root mean square distance from their middle. */
function spreadOf(points: Point[]): number {
  const mean = [0, 1].map((d) => points.reduce((sum, point) => sum + point[d], 0) / points.length);
  const square = points.reduce((sum, [x, y]) => sum + (x - mean[0]) ** 2 + (y - mean[1]) ** 2, 0);
  return Math.sqrt(square / points.length);
}
