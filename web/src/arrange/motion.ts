// How charts are moved by hand: turned, scaled alike in all directions, and shifted.

/** Maps (u, v) to (a u - b v + x, b u + a v + y). */
export interface Motion {
  a: number;
  b: number;
  x: number;
  y: number;
}

export const STILL: Motion = { a: 1, b: 0, x: 0, y: 0 };

export type Point = [number, number];

export const moved = ({ a, b, x, y }: Motion, [u, v]: Point): Point => [
  a * u - b * v + x,
  b * u + a * v + y,
];

export const shifted = (x: number, y: number): Motion => ({ ...STILL, x, y });

/** Turns by an angle in radians, counterclockwise, and scales; `middle` stays where it is. */
export function turned(middle: Point, angle: number, scale = 1): Motion {
  const [a, b] = [scale * cosine(angle), scale * cosine(angle - Math.PI / 2)];
  const [u, v] = middle;
  return { a, b, x: u - a * u + b * v, y: v - b * u - a * v };
}

/** Exact for right angles, so that what is straight stays so. */
function cosine(angle: number): number {
  const quarters = angle / (Math.PI / 2);
  const whole = Math.round(quarters);
  if (Math.abs(quarters - whole) > 1e-12) return Math.cos(angle);
  return [1, 0, -1, 0][((whole % 4) + 4) % 4];
}

/** First `first`, then `second`. */
export function after(first: Motion, second: Motion): Motion {
  const [x, y] = moved(second, [first.x, first.y]);
  return {
    a: second.a * first.a - second.b * first.b,
    b: second.b * first.a + second.a * first.b,
    x,
    y,
  };
}

/** The same motion where a point p of the plane is what was unit p + middle before. */
export function inPlane({ a, b, x, y }: Motion, middle: Point, unit: number): Motion {
  const [u, v] = middle;
  return { a, b, x: (a * u - b * v + x - u) / unit, y: (b * u + a * v + y - v) / unit };
}

export const isStill = ({ a, b, x, y }: Motion): boolean =>
  a === 1 && b === 0 && x === 0 && y === 0;
