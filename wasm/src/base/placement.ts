// Where a mesh is put, and how large that makes it.

/** Column-major, 4 x 4. */
export type Matrix = ArrayLike<number>;

export interface Placement {
  /** Undefined if vertices stay where they are. */
  matrix?: Matrix;
  /** Corners run clockwise when seen from outside. */
  isMirrored: boolean;
}

/** How the places of one mesh use it. */
export interface Usage {
  /** Where it is largest, the first of several. */
  placement: Placement;
  places: number;
  /** How much larger areas become, squared; 0 if all places flatten the mesh. */
  areaScale: number;
  /** The places make it differently large. */
  hasScales: boolean;
}

export const AS_IT_IS: Placement = { isMirrored: false };

/** The usage with one more place. `matrix`: undefined if vertices stay where they are. */
export function usedAt(matrix: Matrix | undefined, before?: Usage): Usage {
  const volume = matrix ? determinant(matrix) : 1;
  const isFlat = volume === 0 || !Number.isFinite(volume);
  const placement = matrix && !isFlat ? { matrix, isMirrored: volume < 0 } : AS_IT_IS;
  const areaScale = isFlat ? 0 : areaScaleOf(placement.matrix);
  const now = { placement, places: 1, areaScale, hasScales: false };
  if (!before) return now;
  const hasScales =
    before.hasScales ||
    (before.areaScale > 0 && areaScale > 0 && !isScaledAlike(before.placement, placement));
  const both = { places: before.places + 1, hasScales };
  // Places that differ by rounding only count as equally large.
  const isLarger = areaScale > before.areaScale * (1 + 1e-6);
  return isLarger ? { ...now, ...both } : { ...before, ...both };
}

/** The mean over all directions, up to a constant factor. */
function areaScaleOf(m: Matrix = IDENTITY): number {
  const column = (i: number) => [m[4 * i], m[4 * i + 1], m[4 * i + 2]] as Point;
  const [x, y, z] = [column(0), column(1), column(2)];
  return [cross(x, y), cross(y, z), cross(z, x)].reduce((sum, c) => sum + dot(c, c), 0);
}

function isScaledAlike(a: Placement, b: Placement): boolean {
  const [before, now] = [scalesOf(a.matrix), scalesOf(b.matrix)];
  const largest = Math.max(...before, ...now);
  // Well above the rounding of exporters.
  return before.every((x, i) => Math.abs(x - (now[i] as number)) <= 1e-3 * largest);
}

/** Scalar products of the axes: what is left of a placement without position and rotation. */
function scalesOf(m: Matrix = IDENTITY): number[] {
  const axes = [0, 4, 8].map((i) => [m[i], m[i + 1], m[i + 2]] as Point);
  return axes.flatMap((a) => axes.map((b) => dot(a, b)));
}

type Point = [number, number, number];

const IDENTITY: Matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

const dot = (a: Point, b: Point) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Point, b: Point): Point => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

function determinant(m: Matrix): number {
  return (
    m[0] * (m[5] * m[10] - m[6] * m[9]) -
    m[4] * (m[1] * m[10] - m[2] * m[9]) +
    m[8] * (m[1] * m[6] - m[2] * m[5])
  );
}

/** Writes the point to where it is placed. */
export function put(
  [x = 0, y = 0, z = 0]: number[],
  m: Matrix | undefined,
  to: Float64Array,
  at: number,
) {
  for (let d = 0; d < 3; ++d)
    to[at + d] = m
      ? (m[d] as number) * x +
        (m[4 + d] as number) * y +
        (m[8 + d] as number) * z +
        (m[12 + d] as number)
      : ([x, y, z][d] as number);
}

/**
 * Writes a normal as it is on the placed surface, by the cofactors of the matrix. It faces outwards
 * as before, even where the placement mirrors.
 */
export function putNormal(
  normal: number[],
  { matrix: m, isMirrored }: Placement,
  to: Float64Array,
  at: number,
): void {
  if (!m) {
    to.set(normal, at);
    return;
  }
  const [x, y, z] = [0, 4, 8].map((i) => [m[i], m[i + 1], m[i + 2]] as Point) as [
    Point,
    Point,
    Point,
  ];
  const sign = isMirrored ? -1 : 1;
  [cross(y, z), cross(z, x), cross(x, y)].forEach((column, k) => {
    for (let d = 0; d < 3; ++d)
      (to[at + d] as number) += sign * (column[d] as number) * (normal[k] as number);
  });
}

/** Of triangles. */
export function areaOf(positions: Float64Array, indices: Uint32Array): number {
  const at = (corner: number, d: number) =>
    positions[3 * (indices[corner] as number) + d] as number;
  let sum = 0;
  for (let c = 0; c < indices.length; c += 3) {
    const [u, v] = [1, 2].map((k) => [0, 1, 2].map((d) => at(c + k, d) - at(c, d))) as [
      Point,
      Point,
    ];
    sum += Math.hypot(...cross(u, v));
  }
  return sum / 2;
}
