// Pictures of a mesh with its seams, and of its layout, each chart in a colour.

import { cross, dot, lengthOf } from '../../support/charted-layout.mjs';
import { Canvas, write } from './canvas.mjs';

const INK = [20, 20, 20];
const FRAME = [170, 170, 170];
/** Azimuth and elevation in degrees, from four sides; two of them from below. */
const SIDES = [
  [30, 25],
  [120, -25],
  [210, 25],
  [300, -25],
];
/** Share of the picture that is left free on each side. */
const MARGIN = 0.04;
/** How far lines are drawn in front of the surface, relative to its size. */
const IN_FRONT = 0.004;
/** Above this, edges of faces would cover the charts. */
const MOST_EDGES_SHOWN = 4000;

/** Far from its neighbours' for any number of charts. */
function colorOf(chart) {
  const hue = (chart * 0.61803398875) % 1;
  const light = 0.62 + 0.12 * ((chart * 0.381966) % 1);
  return [0, 1 / 3, 2 / 3].map((shift) => {
    const wave = Math.abs(((((hue + shift) % 1) + 1) % 1) - 0.5) * 6 - 1;
    return 255 * (light + (Math.min(1, Math.max(0, wave)) - 0.5) * 0.5);
  });
}

const shaded = (color, factor) => color.map((x) => Math.min(255, Math.round(x * factor)));

function frameOf([azimuth, elevation], up) {
  const [a, e] = [azimuth, elevation].map((degrees) => (degrees * Math.PI) / 180);
  const ahead = up[2] === 1 ? [0, -1, 0] : [0, 0, 1];
  const side = cross(up, ahead);
  const around = ahead.map((x, d) => x * Math.cos(a) + side[d] * Math.sin(a));
  const toward = around.map((x, d) => x * Math.cos(e) + up[d] * Math.sin(e));
  const right = cross(up, toward).map((x, _, all) => x / lengthOf(all));
  return { toward, right, above: cross(toward, right) };
}

/** Maps points to a square of `size`, so that all of `points` fit. */
function fitted(points, size) {
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  for (const p of points)
    for (const d of [0, 1]) {
      low[d] = Math.min(low[d], p[d]);
      high[d] = Math.max(high[d], p[d]);
    }
  const extent = Math.max(high[0] - low[0], high[1] - low[1]);
  const scale = extent > 0 ? ((1 - 2 * MARGIN) * size) / extent : 1;
  const middle = low.map((x, d) => (x + high[d]) / 2);
  const map = (p) => [
    size / 2 + scale * (p[0] - middle[0]),
    size / 2 - scale * (p[1] - middle[1]),
    p[2] ?? 0,
  ];
  return { map, extent };
}

/** The surface from one side, seams on it. */
function view({ triangles, cuts, borders }, size, side, up) {
  const { toward, right, above } = frameOf(side, up);
  const seen = (p) => [dot(p, right), dot(p, above), dot(p, toward)];
  const { map, extent } = fitted(
    triangles.flatMap(({ xyz }) => xyz.map(seen)),
    2 * size,
  );
  const canvas = new Canvas(2 * size, 2 * size);
  for (const { xyz, normal, chart } of triangles) {
    const light = Math.abs(dot(normal, toward)) * 0.4 + 0.6 + 0.1 * dot(normal, above);
    canvas.triangle(
      xyz.map((p) => map(seen(p))),
      shaded(colorOf(chart), light),
    );
  }
  const edge = (ends, color, width) => {
    const lifted = ends.map((p) => {
      const [x, y, z] = map(seen(p));
      return [x, y, z + IN_FRONT * extent];
    });
    canvas.line(lifted, color, width);
  };
  for (const { xyz } of borders) edge(xyz, [20, 60, 200], 3);
  for (const { a, b } of cuts) edge([a, b], [190, 0, 0], 5);
  return canvas.halved();
}

const UNIT_SQUARE = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
];

/** The layout in the unit square, and around it if it leaves that. */
function layout({ triangles, rims }, size) {
  const { map } = fitted([...UNIT_SQUARE, ...triangles.flatMap(({ uv }) => uv)], 2 * size);
  const canvas = new Canvas(2 * size, 2 * size);
  for (const { uv, chart } of triangles) canvas.triangle(uv.map(map), colorOf(chart));
  if (triangles.length <= MOST_EDGES_SHOWN)
    for (const { uv, chart } of triangles)
      for (const i of [0, 1, 2])
        canvas.line([uv[i], uv[(i + 1) % 3]].map(map), shaded(colorOf(chart), 0.8));
  for (const { uv } of rims) canvas.line(uv.map(map), INK, 2);
  for (const [i, corner] of UNIT_SQUARE.entries())
    canvas.line([corner, UNIT_SQUARE[(i + 1) % 4]].map(map), FRAME, 2);
  return canvas.halved();
}

/** For each of `layouts` (from chartedLayout): the surface from four sides, beside the layout. */
export function sheet(layouts, up, size = 300) {
  const canvas = new Canvas(4 * size * layouts.length, 2 * size);
  for (const [k, charted] of layouts.entries()) {
    for (const [i, side] of SIDES.entries())
      canvas.paste(view(charted, size, side, up), 4 * k * size + (i % 2) * size, (i >> 1) * size);
    canvas.paste(layout(charted, 2 * size), (4 * k + 2) * size, 0);
  }
  return canvas;
}

/** What the montage shows of a layout, with its name. */
export function tile(charted, name, up, size = 160) {
  const canvas = new Canvas(2 * size, size + 14);
  canvas.paste(view(charted, size, SIDES[0], up), 0, 14);
  canvas.paste(layout(charted, size), size, 14);
  write(canvas, name.slice(0, size / 4), 2, 2);
  return canvas;
}

/** All tiles, as many side by side as below each other. */
export function montage(tiles) {
  const [{ width, height }] = tiles;
  const columns = Math.min(
    tiles.length,
    Math.max(1, Math.round(Math.sqrt((tiles.length * height * 1.6) / width))),
  );
  const canvas = new Canvas(columns * width, Math.ceil(tiles.length / columns) * height);
  for (const [i, each] of tiles.entries())
    canvas.paste(each, (i % columns) * width, Math.floor(i / columns) * height);
  return canvas;
}
