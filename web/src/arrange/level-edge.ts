import { type Motion, type Point, turned } from './motion';

const QUARTER = Math.PI / 2;

/** Turns about the middle between two points so that the line through them is level or upright, whichever is nearer. */
export function levelled([x0, y0]: Point, [x1, y1]: Point): Motion {
  const angle = Math.atan2(y1 - y0, x1 - x0);
  const nearest = QUARTER * Math.round(angle / QUARTER);
  return turned([(x0 + x1) / 2, (y0 + y1) / 2], nearest - angle);
}
