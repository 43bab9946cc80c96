// Random polygons that touch themselves: with holes on bridges, holes that touch the outline, spikes
// inside and outside, pieces that meet in a corner or hang on a bridge, one within the other, and
// corners listed twice. No edge crosses another, so each bounds an inside in its plane.

import { Random } from './random-surfaces.mjs';

/** Polygons lie in a square of this size. */
export const EXTENT = 12;
/** Between things that do not touch, so that no float decides what the polygon is. */
const GAP = 0.04;
const LEAST_ANGLE = 0.12;
const TRIES = 60;

const minus = (a, b) => [a[0] - b[0], a[1] - b[1]];
const cross = (a, b) => a[0] * b[1] - a[1] * b[0];
const turnOf = (a, b, c) => cross(minus(b, a), minus(c, a));
const angleOf = (from, to) => Math.atan2(to[1] - from[1], to[0] - from[0]);
/** From 0 to a full turn. */
const positive = (angle) => ((angle % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);

function distanceToSegment(p, [a, b]) {
  const d = minus(b, a);
  const along = (minus(p, a)[0] * d[0] + minus(p, a)[1] * d[1]) / (d[0] ** 2 + d[1] ** 2);
  const t = Math.max(0, Math.min(1, along));
  return Math.hypot(p[0] - a[0] - t * d[0], p[1] - a[1] - t * d[1]);
}

function isNear([a, b], [c, d]) {
  if (turnOf(a, b, c) * turnOf(a, b, d) < 0 && turnOf(c, d, a) * turnOf(c, d, b) < 0) return true;
  const distances = [
    distanceToSegment(a, [c, d]),
    distanceToSegment(b, [c, d]),
    distanceToSegment(c, [a, b]),
    distanceToSegment(d, [a, b]),
  ];
  return Math.min(...distances) < GAP;
}

const isIn = (p, ring) =>
  ring.filter(([x, y], i) => {
    const [u, v] = ring.at(i - 1);
    return y > p[1] !== v > p[1] && p[0] < x + ((p[1] - y) / (v - y)) * (u - x);
  }).length %
    2 ===
  1;

class TouchingPolygon {
  points = [];
  /** The way around: indices of points. */
  walk = [];
  /** Rings that are holes or pieces, in the order in which the walk takes them. */
  rings = [];
  kinds = new Set();
  spikes = [];
  #random;

  constructor(random) {
    this.#random = random;
    const n = 3 + random.below(8);
    const ring = this.#ring([EXTENT / 2, EXTENT / 2], EXTENT / 4, n);
    this.walk = ring.map((p) => this.#add(p));
    this.rings.push({ corners: [...this.walk], isHole: false });
  }

  #add(point) {
    return this.points.push(point) - 1;
  }

  /** Counter-clockwise around its centre. */
  #ring(centre, size, n = 3 + this.#random.below(5)) {
    const first = this.#random.between(0, 2 * Math.PI);
    return Array.from({ length: n }, (_, k) => {
      const angle = first + (2 * Math.PI * (k + this.#random.between(-0.25, 0.25))) / n;
      const r = size * this.#random.between(0.7, 1);
      return [centre[0] + r * Math.cos(angle), centre[1] + r * Math.sin(angle)];
    });
  }

  #segments() {
    return this.walk.map((v, i) => [this.walk.at(i - 1), v]);
  }

  /** Whether edges from place v fit: they start there, or are away from all others. */
  #isFree(v, edges) {
    const from = this.points[v];
    const isAtStart = ([a, b]) => a === from || b === from;
    return this.#segments().every((s) => {
      const segment = s.map((k) => this.points[k]);
      return edges.every((edge) => {
        if (!s.includes(v) || !isAtStart(edge)) return !isNear(segment, edge);
        const end = (pair) => (pair[0] === from ? pair[1] : pair[0]);
        const angle = positive(angleOf(from, end(segment)) - angleOf(from, end(edge)));
        return Math.min(angle, 2 * Math.PI - angle) > LEAST_ANGLE;
      });
    });
  }

  /**
   * Whether a direction at corner i of the walk leads to its inside, on the left, or to the
   * outside, on the right, with no other visit of the same place in between.
   */
  #isOnSide(i, angle, isInside) {
    const at = (k) => this.walk.at(k % this.walk.length);
    const [before, v, after] = [at(i - 1), at(i), at(i + 1)];
    if (before === after) return this.spikes.some((s) => s.tip === v && s.isInside === isInside);
    const turnTo = (w) => positive(angleOf(this.points[v], this.points[w]) - angle);
    const ends = this.walk.flatMap((w, k) => (w === v ? [at(k - 1), at(k + 1)] : []));
    ends.sort((a, b) => turnTo(a) - turnTo(b));
    const [next, last] = [ends[0], ends.at(-1)];
    // Between two edges walked there and back, both sides look the same.
    const isDoubled = (w) => ends.filter((end) => end === w).length > 1;
    if (isDoubled(next) && isDoubled(last)) return false;
    return isInside ? next === before && last === after : next === after && last === before;
  }

  #insert(i, corners) {
    this.walk.splice(i + 1, 0, ...corners);
  }

  /** A ring with no point in it; reversed if it is a hole. */
  #addRing(ring, isHole) {
    const corners = ring.map((p) => this.#add(p));
    this.rings.push({ corners, isHole });
    return isHole ? corners.toReversed() : corners;
  }

  #isEmpty(ring) {
    return !this.points.some((p) => !ring.includes(p) && isIn(p, ring));
  }

  /** A hole, or a piece outside, on a bridge. */
  bridged(isHole) {
    const i = this.#random.below(this.walk.length);
    const v = this.walk[i];
    const from = this.points[v];
    const centre = [0, 1].map(() => this.#random.between(0, EXTENT));
    const ring = this.#ring(centre, this.#random.between(0.3, 1.5));
    const to = ring[this.#random.below(ring.length)];
    const edges = ring.map((p, k) => [ring.at(k - 1), p]);
    const bridge = [from, to];
    if (edges.some((e) => !e.includes(to) && isNear(e, bridge)) || isIn(from, ring)) return false;
    const crossing = edges.filter((e) => e.includes(to)).map((e) => (e[0] === to ? e[1] : e[0]));
    if (isIn(middle(from, to), ring) || crossing.some((p) => isSharp(to, p, from))) return false;
    if (!this.#isOnSide(i, angleOf(from, to), isHole)) return false;
    if (!this.#isFree(v, [bridge]) || !this.#isFree(v, edges) || !this.#isEmpty(ring)) return false;
    const corners = this.#addRing(ring, isHole);
    const start = corners.findIndex((k) => this.points[k] === to);
    const around = [...corners.slice(start), ...corners.slice(0, start)];
    this.#insert(i, [...around, around[0], v]);
    this.kinds.add(isHole ? 'keyhole' : 'bridge');
    return true;
  }

  /** A hole, or a piece outside, that touches the way at one of its corners. */
  touching(isHole) {
    const i = this.#random.below(this.walk.length);
    const v = this.walk[i];
    const from = this.points[v];
    const [angle, size] = [this.#random.between(0, 7), this.#random.between(0.4, 1.5)];
    if (!this.#isOnSide(i, angle, isHole)) return false;
    const ring = this.#ring(
      [from[0] + size * Math.cos(angle), from[1] + size * Math.sin(angle)],
      size,
    );
    const nearest = ring.reduce((a, b) =>
      Math.hypot(...minus(a, from)) < Math.hypot(...minus(b, from)) ? a : b,
    );
    const start = ring.indexOf(nearest);
    const open = [...ring.slice(start + 1), ...ring.slice(0, start)];
    const whole = [from, ...open];
    const isRound = whole.every((p, k) => {
      const [a, b] = [whole.at(k - 1), whole[(k + 1) % whole.length]];
      return turnOf(a, p, b) > 0 && !isSharp(p, a, b);
    });
    if (!isRound || whole.some((p, k) => Math.hypot(...minus(p, whole.at(k - 1))) < 0.2))
      return false;
    const edges = whole.map((p, k) => [whole.at(k - 1), p]);
    const isOnSide = open.every((p) => this.#isOnSide(i, angleOf(from, p), isHole));
    if (!isOnSide || !this.#isFree(v, edges) || !this.#isEmpty(whole)) return false;
    const corners = this.#addRing(open, isHole);
    this.rings.at(-1).corners = [v, ...(isHole ? corners.toReversed() : corners)];
    this.#insert(i, [...corners, v]);
    this.kinds.add(isHole ? 'touching hole' : 'figure eight');
    return true;
  }

  spike(isInside) {
    const i = this.#random.below(this.walk.length);
    const v = this.walk[i];
    const from = this.points[v];
    const [angle, length] = [this.#random.between(0, 7), this.#random.between(0.3, 3)];
    const tip = [from[0] + length * Math.cos(angle), from[1] + length * Math.sin(angle)];
    if (!this.#isOnSide(i, angle, isInside) || !this.#isFree(v, [[from, tip]])) return false;
    const k = this.#add(tip);
    this.spikes.push({ tip: k, base: v, isInside });
    this.#insert(i, [k, v]);
    this.kinds.add(isInside ? 'spike' : 'spike outside');
    return true;
  }

  repeated() {
    const i = this.#random.below(this.walk.length);
    this.#insert(i, Array(1 + this.#random.below(2)).fill(this.walk[i]));
    this.kinds.add('repeated corner');
    return true;
  }
}

const middle = (a, b) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
function isSharp(at, a, b) {
  const angle = positive(angleOf(at, a) - angleOf(at, b));
  return Math.min(angle, 2 * Math.PI - angle) < LEAST_ANGLE;
}

function randomPolygon(random) {
  const out = new TouchingPolygon(random);
  const steps = [
    () => out.bridged(true),
    () => out.bridged(false),
    () => out.touching(true),
    () => out.touching(false),
    () => out.spike(true),
    () => out.spike(false),
  ];
  for (let left = 1 + random.below(6); left > 0; left--) {
    const step = random.pick(steps);
    for (let i = 0; i < TRIES && !step(); i++);
  }
  if (random.chance(0.3)) out.repeated();
  const start = random.below(out.walk.length);
  out.walk = [...out.walk.slice(start), ...out.walk.slice(0, start)];
  return out;
}

/** A rotation and a move, as a function of a point in the plane and a height above it. */
function randomPlace(random) {
  const [a, b, c] = [0, 1, 2].map(() => random.between(0, 2 * Math.PI));
  const turn = (p, i, j, angle) => {
    const out = [...p];
    out[i] = Math.cos(angle) * p[i] - Math.sin(angle) * p[j];
    out[j] = Math.sin(angle) * p[i] + Math.cos(angle) * p[j];
    return out;
  };
  const scale = random.pick([1, 1, 0.2, 5]);
  const move = [0, 1, 2].map(() => random.between(-20, 20));
  const isFlat = random.chance(0.3);
  return ([x, y], height = 0) => {
    const p = [x, y, height];
    const turned = isFlat ? p : turn(turn(turn(p, 0, 1, a), 1, 2, b), 2, 0, c);
    return turned.map((v, d) => scale * (v + move[d]));
  };
}

/** Faces beside the polygon: in its holes, below its edges, or beside them in its plane. */
function glue(random, polygon, first, place, mesh) {
  const { points, walk } = polygon;
  const way = random.pick(['none', 'none', 'fill', 'walls', 'both']);
  if (way === 'fill' || way === 'both')
    for (const { corners, isHole } of polygon.rings)
      if (isHole && random.chance(0.7) && isBare(corners, walk))
        mesh.faces.push(corners.map((k) => first + k));
  if (way !== 'walls' && way !== 'both') return way;
  const below = mesh.positions.length;
  for (const p of points) mesh.positions.push(place(p, -2));
  const edges = walk.map((v, i) => [walk.at(i - 1), v]).filter(([a, b]) => a !== b);
  for (const [a, b] of edges) {
    const isBridge = edges.some(([c, d]) => a === d && b === c);
    if (!isBridge && random.chance(0.9))
      mesh.faces.push([first + b, first + a, below + a, below + b]);
  }
  return way;
}

/** Whether the way visits a ring's corners only to go around it. */
const isBare = (corners, walk) =>
  corners.filter((k) => walk.filter((v, i) => v === k && walk.at(i - 1) !== k).length > 1).length <=
  1;

/**
 * A mesh of some such polygons, as { positions, faces, polygons }; `polygons` are { face, points,
 * walk, rings, spikes, kinds, isAlone }, with points in their own plane.
 */
export function touchingPolygons(seed) {
  const random = new Random(seed);
  const mesh = { positions: [], faces: [], polygons: [] };
  for (let count = 1 + random.below(5); count > 0; count--) {
    const polygon = randomPolygon(random);
    const place = randomPlace(random);
    const isBent = random.chance(0.15);
    const first = mesh.positions.length;
    for (const p of polygon.points)
      mesh.positions.push(place(p, isBent ? 0.005 * random.next() : 0));
    const face = mesh.faces.push(polygon.walk.map((k) => first + k)) - 1;
    const way = glue(random, polygon, first, place, mesh);
    const { points, walk, rings, spikes, kinds } = polygon;
    const isAlone = way === 'none' && !isBent;
    mesh.polygons.push({ face, points, walk, rings, spikes, kinds, isAlone });
  }
  return mesh;
}
