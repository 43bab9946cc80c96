import type { ChartMesh } from './chart-mesh';
import { pointOf } from './charts';
import { moved, type Point, turned } from './motion';
import type { OwnMesh } from './own-mesh';
import { distance } from './quad-grid';
import { angleOfSmallestBox } from './straighten';

/** Corners of an outline turn by at least this, in radians. */
const SHARP = 0.9;
/** An outline without four such corners is nearly a rectangle if it fills this share of its box. */
const FULL = 0.8;

/** The vertices of an outline and their places on a rectangle. */
export type Places = Map<number, Point>;

/** A rectangle for the outline of a chart, whose sides are as long as on the surface; null if it resembles none. */
export function rectangleFor(
  { positions, texcoords }: ChartMesh,
  { loop }: OwnMesh,
): Places | null {
  const corners = loop.length >= 4 ? cornersOf(loop, texcoords) : null;
  if (!corners) return null;
  const sides = corners.map((from, i) => {
    const to = corners[(i + 1) % 4];
    return loop
      .slice(from, to > from ? to + 1 : undefined)
      .concat(to > from ? [] : loop.slice(0, to + 1));
  });
  const lengths = sides.map((side) => lengthOf(side, positions));
  const width = (lengths[0] + lengths[2]) / 2;
  const height = (lengths[1] + lengths[3]) / 2;
  const ends: Point[] = [
    [0, 0],
    [width, 0],
    [width, height],
    [0, height],
  ];
  const places: Places = new Map();
  sides.forEach((side, i) => {
    const [[x0, y0], [x1, y1]] = [ends[i], ends[(i + 1) % 4]];
    let along = 0;
    side.forEach((v, k) => {
      if (k > 0) along += distance(positions, side[k - 1], v) / lengths[i];
      if (k + 1 < side.length) places.set(v, [x0 + along * (x1 - x0), y0 + along * (y1 - y0)]);
    });
  });
  return places;
}

/** The places of four corners in the loop, in its order; null if there are none that stand out. */
function cornersOf(loop: readonly number[], uv: Float64Array): number[] | null {
  const points = loop.map((v) => pointOf(uv, v));
  const at = (i: number) => points[(i + points.length) % points.length];
  const sharp = points.flatMap((point, i) => {
    const before = Math.atan2(point[1] - at(i - 1)[1], point[0] - at(i - 1)[0]);
    const after = Math.atan2(at(i + 1)[1] - point[1], at(i + 1)[0] - point[0]);
    const turn = Math.atan2(Math.sin(after - before), Math.cos(after - before));
    return turn > SHARP ? i : [];
  });
  return sharp.length === 4 ? sharp : nearCorners(points);
}

/** The points nearest to the corners of the smallest box around them. */
function nearCorners(points: readonly Point[]): number[] | null {
  const [x, y] = [0, 1].map((d) => Float64Array.from(points, (point) => point[d]));
  const turn = turned([0, 0], -angleOfSmallestBox(x, y));
  const upright = points.map((point) => moved(turn, point));
  const [left, bottom] = [0, 1].map((d) => upright.reduce((a, p) => Math.min(a, p[d]), Infinity));
  const [right, top] = [0, 1].map((d) => upright.reduce((a, p) => Math.max(a, p[d]), -Infinity));
  if (Math.abs(areaIn(upright)) < FULL * (right - left) * (top - bottom)) return null;
  const found = [
    [left, bottom],
    [right, bottom],
    [right, top],
    [left, top],
  ].map(([u, v]) => {
    const distances = upright.map(([p, q]) => Math.hypot(p - u, q - v));
    return distances.indexOf(distances.reduce((a, b) => Math.min(a, b)));
  });
  if (new Set(found).size < 4) return null;
  // In the order of the loop, wherever it begins.
  const inOrder = [...found].sort((a, b) => a - b);
  const start = inOrder.indexOf(found[0]);
  const isAround = found.every((each, i) => each === inOrder[(start + i) % 4]);
  return isAround ? inOrder : null;
}

const areaIn = (points: readonly Point[]): number =>
  points.reduce((sum, [x, y], i) => {
    const [x1, y1] = points[(i + 1) % points.length];
    return sum + (x * y1 - x1 * y) / 2;
  }, 0);

const lengthOf = (side: readonly number[], positions: Float64Array): number =>
  side.slice(1).reduce((sum, v, i) => sum + distance(positions, side[i], v), 0);
