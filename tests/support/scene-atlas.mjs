// Judges the atlas of a scene by the triangles that its objects have, with none of the program's
// code.

import { judge, turn } from './exact-atlas.mjs';

const minus = (a, b) => a.map((x, d) => x - b[d]);

export function areaInSpace([a, b, c]) {
  const [u, v] = [minus(b, a), minus(c, a)];
  const normal = [0, 1, 2].map(
    (d) => u[(d + 1) % 3] * v[(d + 2) % 3] - u[(d + 2) % 3] * v[(d + 1) % 3],
  );
  return Math.hypot(...normal) / 2;
}

const areaInAtlas = ([a, b, c]) =>
  ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;

/** `resolution`: the side of a square, or a width and a height. */
const sidesOf = (resolution) => (Array.isArray(resolution) ? resolution : [resolution, resolution]);

/** Per object, the texels per unit of length in the world; it may be mirrored as a whole. */
export function densitiesOf(triangles, resolution) {
  const [width, height] = sidesOf(resolution);
  const sums = new Map();
  for (const { object, places, uv } of triangles) {
    const [flat, solid] = sums.get(object) ?? [0, 0];
    sums.set(object, [flat + areaInAtlas(uv), solid + areaInSpace(places)]);
  }
  return new Map(
    [...sums].map(([object, [flat, solid]]) => [
      object,
      Math.sqrt(width * height) * Math.sqrt(Math.abs(flat) / solid),
    ]),
  );
}

/**
 * By how much squares on the surface become rectangles in texels: the ratio of the sides, as a mean
 * over the surface. Triangles of a million times that count for nothing.
 */
export function meanShear(triangles, resolution) {
  const sides = sidesOf(resolution);
  let [sum, all] = [0, 0];
  for (const { places, uv } of triangles) {
    const area = areaInSpace(places);
    const [a, b, c] = uv.map((point) => point.map((x, d) => x * sides[d]));
    const flat = Math.abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    if (!(area > 0) || !(flat > 0)) continue;
    // Cotangents give the integral of the squared gradient.
    let energy = 0;
    for (const k of [0, 1, 2]) {
      const [i, j] = [(k + 1) % 3, (k + 2) % 3];
      const [p, q] = [minus(places[i], places[k]), minus(places[j], places[k])];
      const dot = p.reduce((total, x, d) => total + x * q[d], 0);
      const edge = minus([a, b, c][i], [a, b, c][j]);
      energy += ((dot / (2 * area)) * (edge[0] ** 2 + edge[1] ** 2)) / 2;
    }
    const mean = Math.max(energy / (2 * flat), 1); // (ratio + 1 / ratio) / 2
    const ratio = mean + Math.sqrt(mean ** 2 - 1);
    if (!(ratio < 1e6)) continue;
    sum += area * ratio;
    all += area;
  }
  return sum / all;
}

/** The chart of each triangle: those with a texcoord in common are in one. */
export function chartsOf(triangles) {
  const parent = triangles.map((_, i) => i);
  const find = (i) => {
    let root = i;
    while (parent[root] !== root) root = parent[root];
    parent[i] = root;
    return root;
  };
  const first = new Map();
  for (const [i, { uv }] of triangles.entries())
    for (const point of uv) {
      const key = point.join();
      if (first.has(key)) parent[find(i)] = find(first.get(key));
      else first.set(key, i);
    }
  return triangles.map((_, i) => find(i));
}

/** Whether a triangle touches the closed unit square at a texel; all in texels. */
function touches(triangle, x, y) {
  const square = [
    [x, y],
    [x + 1, y],
    [x + 1, y + 1],
    [x, y + 1],
  ];
  return [0, 1, 2].every((k) =>
    square.some((corner) => turn(triangle[k], triangle[(k + 1) % 3], corner) >= 0),
  );
}

/** Calls `see(x, y)` for all texels that a triangle touches. */
export function forTexels(uv, resolution, see) {
  const sides = sidesOf(resolution);
  const inTexels = uv.map((point) => point.map((x, d) => x * sides[d]));
  const last = (x, d) => Math.min(Math.floor(x), sides[d] - 1);
  // A border belongs to the texels on both of its sides.
  const first = (x) => Math.max(0, Math.ceil(x) - 1);
  const [us, vs] = [0, 1].map((d) => inTexels.map((point) => point[d]));
  for (let y = first(Math.min(...vs)); y <= last(Math.max(...vs), 1); ++y)
    for (let x = first(Math.min(...us)); x <= last(Math.max(...us), 0); ++x)
      if (touches(inTexels, x, y)) see(x, y);
}

/** The fewest free texels between two charts, in the direction in which there are more; at most `most`. */
export function leastGap(triangles, resolution, most) {
  const charts = chartsOf(triangles);
  const [width, height] = sidesOf(resolution);
  const owner = new Int32Array(width * height).fill(-1);
  let least = most;
  for (const [i, { uv }] of triangles.entries())
    forTexels(uv, resolution, (x, y) => {
      const at = y * width + x;
      if (owner[at] >= 0 && owner[at] !== charts[i]) least = -1;
      owner[at] = charts[i];
    });
  const ownerAt = (x, y) =>
    x >= 0 && y >= 0 && x < width && y < height ? owner[y * width + x] : -1;
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const own = ownerAt(x, y);
      if (own < 0) continue;
      for (let dy = 0; dy <= least; ++dy)
        for (let dx = -least; dx <= least; ++dx) {
          const other = ownerAt(x + dx, y + dy);
          if (other < 0 || other === own) continue;
          least = Math.min(least, Math.max(Math.abs(dx), dy) - 1);
        }
    }
  return least;
}

/** Objects that have a chart in common with another one. */
export function mingled(triangles) {
  const objectOf = new Map();
  const found = new Set();
  for (const [i, chart] of chartsOf(triangles).entries()) {
    const { object } = triangles[i];
    if (!objectOf.has(chart)) objectOf.set(chart, object);
    if (objectOf.get(chart) !== object) found.add(object).add(objectOf.get(chart));
  }
  return [...found];
}

/**
 * By how much the density of an object may be off if each of its charts was stretched by half a texel
 * at most, across and up; as a share.
 */
function mostSnapped(triangles, resolution) {
  const charts = chartsOf(triangles);
  const sides = sidesOf(resolution);
  const boxes = new Map();
  const areas = new Map();
  for (const [i, { uv }] of triangles.entries()) {
    const chart = charts[i];
    const { low, high } = boxes.get(chart) ?? { low: [1, 1], high: [0, 0] };
    for (const point of uv)
      for (const d of [0, 1]) {
        low[d] = Math.min(low[d], point[d]);
        high[d] = Math.max(high[d], point[d]);
      }
    boxes.set(chart, { low, high });
    areas.set(chart, (areas.get(chart) ?? 0) + Math.abs(areaInAtlas(uv)));
  }
  const sums = new Map();
  const seen = new Set();
  for (const [i, { object }] of triangles.entries()) {
    if (seen.has(charts[i])) continue;
    seen.add(charts[i]);
    const { low, high } = boxes.get(charts[i]);
    const length = (d) => (high[d] - low[d]) * sides[d];
    const area = areas.get(charts[i]);
    const off = [0, 1].reduce((sum, d) => sum + 0.5 / length(d), 0);
    const [all, stretched] = sums.get(object) ?? [0, 0];
    sums.set(object, [all + area, stretched + area * off]);
  }
  // Of the area; a density is its root.
  return new Map([...sums].map(([object, [all, stretched]]) => [object, stretched / all / 2]));
}

/**
 * What is wrong with triangles `{ object, places, uv }`, corners in the order in which they are seen
 * from outside, v upwards: sentences. `snapToTexels`: charts are stretched a little.
 */
export function complaintsAbout(triangles, wanted) {
  const { resolution, padding, texelDensity, snapToTexels = false } = wanted;
  const snapped = snapToTexels ? mostSnapped(triangles, resolution) : new Map();
  const isThin = ({ places }) => areaInSpace(places) < 1e-12;
  const { flipped, flat, outside, overlaps } = judge(
    triangles.map(({ uv }) => uv),
    { mayBeFlat: (i) => isThin(triangles[i]) },
  );
  const found = Object.entries({ flipped, flat, outside, overlaps })
    .filter(([, list]) => list.length > 0)
    .map(([what, list]) => `${what}: ${list.slice(0, 5).join(' ')}`);
  const shared = mingled(triangles);
  if (shared.length > 0) found.push(`objects share charts: ${shared}`);
  for (const [object, density] of densitiesOf(triangles, resolution))
    if (!(Math.abs(density / texelDensity - 1) < 0.01 + (snapped.get(object) ?? 0)))
      found.push(`${object} has ${density} texels per unit, not ${texelDensity}`);
  const gap = leastGap(triangles, resolution, padding);
  if (gap < padding) found.push(`charts are ${gap} texels apart, not ${padding}`);
  return found;
}
