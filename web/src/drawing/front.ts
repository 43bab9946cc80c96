/** A surface whose facing is at least this clear is first seen from the side it faces. */
const CLEAR_FACING = 0.4;
/** The steepest first view of a surface that faces up or down. */
const STEEPEST = (40 * Math.PI) / 180;
/**
 * A surface that faces mostly up or down, such as a car without its floor, has its front where
 * other surfaces have it.
 */
const LEVEL = 0.6;
const USUAL_AROUND = Math.PI / 7;
/** The direction from which other surfaces are first seen. */
const USUAL = unit([0.42, 0.2, 1]);

export type Direction = [number, number, number];

/**
 * Unit vector from a mesh to the point from which it is first seen, `otherwise` if it does not
 * clearly face one way; y is up.
 */
export function frontOf(
  { direction, clarity }: { direction: Direction; clarity: number },
  otherwise: Direction = USUAL,
): Direction {
  if (clarity < CLEAR_FACING) return otherwise;
  const [x, y, z] = direction;
  const asin = Math.asin(Math.min(1, Math.max(-1, y)));
  const elevation = Math.min(STEEPEST, Math.max(-STEEPEST, asin));
  const around = Math.hypot(x, z) > LEVEL ? Math.atan2(x, z) : USUAL_AROUND;
  const away = Math.cos(elevation);
  return [away * Math.sin(around), Math.sin(elevation), away * Math.cos(around)];
}

/** The axes to the right and up for an eye at `front`, which is not vertical. */
export function axesOf(front: Direction): Record<'front' | 'right' | 'top', Direction> {
  const [x, y, z] = front;
  const right = unit([z, 0, -x]);
  const top: Direction = [y * right[2], z * right[0] - x * right[2], -y * right[0]];
  return { front, right, top };
}

function unit([x, y, z]: Direction): Direction {
  const length = Math.hypot(x, y, z);
  return [x / length, y / length, z / length];
}
