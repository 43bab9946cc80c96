// The charts of a layout and the edges between them, found only from places and texcoords.

import { cutPolygon } from './exact-atlas.mjs';

export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const lengthOf = (a) => Math.hypot(...a);
const scaled = (a, factor) => a.map((x) => x * factor);

/** Corners of one place belong to one chart if their texcoords differ by less than this. */
const SAME_TEXCOORD = 1e-6;

/** Vertices at the same place, to single precision, as one. */
function placesOf(positions) {
  const numbers = new Map();
  return positions.map((p) => {
    const key = p.map(Math.fround).join();
    if (!numbers.has(key)) numbers.set(key, numbers.size);
    return numbers.get(key);
  });
}

/** Corner numbers of the triangles of a polygon: a fan if that turns no triangle over. */
function cutFace(points) {
  const fan = points.slice(2).map((_, i) => [0, i + 1, i + 2]);
  if (points.length === 3) return fan;
  const areas = fan.map((t) => doubledArea(t.map((i) => points[i])));
  const whole = areas.reduce((sum, n) => sum.map((x, d) => x + n[d]), [0, 0, 0]);
  if (areas.every((n) => dot(n, whole) >= 0)) return fan;
  const across = minus(points[1], points[0]);
  const [x, y] = [across, cross(whole, across)].map((v) => scaled(v, 1 / lengthOf(v)));
  return cutPolygon(points.map((p) => [dot(p, x), dot(p, y)])).triangles;
}

const doubledArea = ([a, b, c]) => cross(minus(b, a), minus(c, a));

function trianglesOf({ positions, texcoords, faces }) {
  const places = placesOf(positions);
  const out = [];
  for (const [face, corners] of faces.entries())
    for (const cut of cutFace(corners.map(([v]) => positions[v]))) {
      const three = cut.map((i) => corners[i]);
      const xyz = three.map(([v]) => positions[v]);
      const uv = three.map(([, t]) => texcoords[t]);
      const [[u0, v0], [u1, v1], [u2, v2]] = uv;
      const n = doubledArea(xyz);
      const area = lengthOf(n) / 2;
      out.push({
        face,
        places: three.map(([v]) => places[v]),
        xyz,
        uv,
        area,
        normal: area > 0 ? scaled(n, 0.5 / area) : [0, 0, 0],
        uvArea: Math.abs((u1 - u0) * (v2 - v0) - (v1 - v0) * (u2 - u0)) / 2,
      });
    }
  return { triangles: out, placeCount: new Set(places).size };
}

/** All sides of triangles, by edge; each side runs from the lower place to the higher one. */
function sidesByEdge({ triangles, placeCount }) {
  const edges = new Map();
  for (const [triangle, { places, xyz, uv }] of triangles.entries())
    for (let i = 0; i < 3; i++) {
      let [a, b] = [i, (i + 1) % 3];
      if (places[a] === places[b]) continue;
      if (places[a] > places[b]) [a, b] = [b, a];
      const key = places[a] * placeCount + places[b];
      const side = { triangle, xyz: [xyz[a], xyz[b]], uv: [uv[a], uv[b]] };
      if (edges.has(key)) edges.get(key).push(side);
      else edges.set(key, [side]);
    }
  return edges.values();
}

const areJoined = (s, t) =>
  s.uv.every((p, end) => p.every((x, d) => Math.abs(x - t.uv[end][d]) < SAME_TEXCOORD));

/** Union of sets of triangles: `find` and `join`. */
function sets(count) {
  const parent = Array.from({ length: count }, (_, i) => i);
  const find = (i) => {
    let x = i;
    while (parent[x] !== x) {
      parent[x] = parent[parent[x]];
      x = parent[x];
    }
    return x;
  };
  return { find, join: (i, j) => (parent[find(i)] = find(j)) };
}

/** By how many degrees the surface bends between two triangles. */
const bendBetween = (s, t) =>
  (Math.acos(Math.max(-1, Math.min(1, dot(s.normal, t.normal)))) * 180) / Math.PI;

/**
 * `triangles`, each with the number of its `chart`; `charts`, their count; `cuts`, edges { a, b,
 * bend, length, sides } between charts or within one, of two sides or more; `borders` and `rims`,
 * the sides at the edge of the surface, and all sides where a chart ends.
 */
export function chartedLayout(layout) {
  const { triangles, placeCount } = trianglesOf(layout);
  const { find, join } = sets(triangles.length);
  const [cuts, borders, rims] = [[], [], []];
  for (const sides of sidesByEdge({ triangles, placeCount })) {
    const joined = new Set();
    for (const [i, s] of sides.entries())
      for (const t of sides.slice(i + 1))
        if (areJoined(s, t)) {
          join(s.triangle, t.triangle);
          joined.add(s).add(t);
        }
    const open = sides.filter((side) => !joined.has(side));
    rims.push(...open);
    if (open.length === 1) borders.push(open[0]);
    if (open.length < 2) continue;
    const [a, b] = open[0].xyz;
    const bend = bendBetween(...open.slice(0, 2).map((side) => triangles[side.triangle]));
    cuts.push({ a, b, bend, length: lengthOf(minus(b, a)), sides: open });
  }
  const numbers = new Map();
  for (const [i, triangle] of triangles.entries()) {
    const root = find(i);
    if (!numbers.has(root)) numbers.set(root, numbers.size);
    triangle.chart = numbers.get(root);
  }
  return { triangles, charts: numbers.size, cuts, borders, rims };
}
