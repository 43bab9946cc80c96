import { type ChartArrays, isChart } from './charts';
import type { Point } from './motion';
import { closeMotion, hasSameSides, type Shape, shapesOf, sidesOf } from './stack';

/** The charts with the outline of one of some charts, which may be turned, mirrored, and of another size. */
export function sameShapes(arrays: ChartArrays, charts: Iterable<number>): Set<number> {
  const wanted = new Set(charts);
  const all = Uint32Array.from([...new Set(arrays.chartOfTriangle)].filter(isChart));
  const shapes = shapesOf(arrays, all);
  const models = shapes.filter(({ chart }) => wanted.has(chart));
  const alike = shapes.filter((shape) => models.some((model) => isAlike(shape, model)));
  return new Set([...wanted, ...alike.map(({ chart }) => chart)]);
}

function isAlike(a: Shape, b: Shape): boolean {
  const { length } = a.outline;
  if (length < 3 || length !== b.outline.length || a.triangles.length !== b.triangles.length)
    return false;
  return isTurned(a.outline, b.outline) || isTurned(mirrored(a.outline), b.outline);
}

/** Whether one outline, turned and scaled, is the other. */
function isTurned(from: Point[], to: Point[]): boolean {
  const [sides, others] = [sidesOf(from), sidesOf(to)];
  return from.some(
    (_, shift) => hasSameSides(sides, others, shift) && closeMotion(from, to, shift) !== null,
  );
}

/** In the order that runs counterclockwise again. */
const mirrored = (outline: Point[]): Point[] => outline.map(([x, y]): Point => [-x, y]).reverse();
