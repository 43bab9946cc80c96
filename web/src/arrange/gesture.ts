import { MOVING } from '../words/selection';
import { type Motion, type Point, shifted, turned } from './motion';

export type GestureKind = 'move' | 'turn' | 'scale';

/** What the pointer and the keys ask of the selected charts; all in uv. */
export interface Gesture {
  kind: GestureKind;
  /** Charts turn about it and grow from it. */
  middle: Point;
  /** Where the pointer was at first, and where it is. */
  from: Point;
  to: Point;
  /** Only along u (0) or v (1). */
  axis: 0 | 1 | null;
  /** By arrow keys: texels, degrees or percent. */
  nudge: Point;
  /** As typed; in uv, degrees or as a factor. */
  typed: string;
  /** Whether to keep to steps: whole texels, 5 degrees, tenths. */
  snaps: boolean;
  /** The length of a texel, and of a step of moves. */
  texel: number;
  step: number;
}

const DEGREE = Math.PI / 180;
const STEPS = { angle: 5 * DEGREE, scale: 0.1 };
const LEAST_SCALE = 0.01;

/** The motion that a gesture asks for. */
export function motionOf(gesture: Gesture): Motion {
  const { kind, middle } = gesture;
  if (kind === 'move') return shifted(...shiftOf(gesture));
  if (kind === 'turn') return turned(middle, angleOf(gesture));
  return turned(middle, 0, scaleOf(gesture));
}

function shiftOf({ from, to, axis, nudge, typed, snaps, texel, step }: Gesture): Point {
  const number = numberIn(typed);
  const along = (d: 0 | 1) => {
    if (number !== null) return d === (axis ?? 0) ? number : 0;
    if (axis !== null && axis !== d) return 0;
    const by = to[d] - from[d];
    return (snaps ? rounded(by, step) : by) + nudge[d] * texel;
  };
  return [along(0), along(1)];
}

/** In radians, counterclockwise. */
function angleOf({ middle, from, to, nudge, typed, snaps }: Gesture): number {
  const number = numberIn(typed);
  if (number !== null) return number * DEGREE;
  const at = ([u, v]: Point) => Math.atan2(v - middle[1], u - middle[0]);
  const by = at(to) - at(from);
  const angle = Math.atan2(Math.sin(by), Math.cos(by));
  return (snaps ? rounded(angle, STEPS.angle) : angle) + (nudge[1] - nudge[0]) * DEGREE;
}

function scaleOf({ middle, from, to, nudge, typed, snaps }: Gesture): number {
  const number = numberIn(typed);
  // A scale of nothing or less would fold the chart away.
  if (number !== null) return number > 0 ? number : 1;
  const distance = ([u, v]: Point) => Math.hypot(u - middle[0], v - middle[1]);
  const by = distance(from) > 0 ? distance(to) / distance(from) : 1;
  const scale = (snaps ? rounded(by, STEPS.scale) : by) + (nudge[0] + nudge[1]) / 100;
  return Math.max(LEAST_SCALE, scale);
}

const rounded = (x: number, step: number) => step * Math.round(x / step);

const numberIn = (typed: string) =>
  typed !== '' && Number.isFinite(Number(typed)) ? Number(typed) : null;

/** "Move u 0.125, v −0.5 (128, −512 texels)", "Turn 45°", "Scale ×1.5". */
export function textOf(gesture: Gesture): string {
  const { kind, axis, texel, typed } = gesture;
  const as = typed === '' || numberIn(typed) !== null ? '' : MOVING.typed(typed);
  if (kind === 'turn') return MOVING.turn(signed(angleOf(gesture) / DEGREE, 1)) + as;
  if (kind === 'scale') return MOVING.scale(signed(scaleOf(gesture), 3)) + as;
  const shift = shiftOf(gesture);
  const names = ['u', 'v'].map((name, d) => MOVING.along(name, signed(shift[d], 4)));
  const texels = shift.map((x) => signed(x / texel, 1));
  const only = <T>(pair: T[]) => (axis === null ? pair : [pair[axis]]).join(', ');
  return MOVING.move(only(names), only(texels)) + as;
}

/** With a true minus sign and at most so many decimals. */
const signed = (x: number, decimals: number) =>
  String(Number(x.toFixed(decimals))).replace('-', '\u2212');

/** The gesture after a key; null if the key means nothing to it. */
export function withKey(gesture: Gesture, key: string, isLarge: boolean): Gesture | null {
  const { axis, typed, nudge } = gesture;
  if (/^[0-9.-]$/.test(key)) return { ...gesture, typed: typed + key };
  if (key === 'Backspace') return { ...gesture, typed: typed.slice(0, -1) };
  const along = { x: 0, y: 1 }[key.toLowerCase()];
  if (along !== undefined && gesture.kind === 'move')
    return { ...gesture, axis: axis === along ? null : (along as 0 | 1) };
  const arrows: Record<string, Point> = {
    ArrowLeft: [-1, 0],
    ArrowRight: [1, 0],
    ArrowUp: [0, 1],
    ArrowDown: [0, -1],
  };
  if (!Object.hasOwn(arrows, key)) return null;
  const size = isLarge ? 10 : 1;
  const [u, v] = arrows[key];
  return { ...gesture, nudge: [nudge[0] + size * u, nudge[1] + size * v] };
}

/** The least power of two times a texel that spans at least so many pixels on screen. */
export function stepOf(texel: number, pixelsPerUv: number, leastPixels = 8): number {
  const texels = Math.max(1, leastPixels / (texel * pixelsPerUv));
  return texel * 2 ** Math.ceil(Math.log2(texels) - 1e-9);
}
