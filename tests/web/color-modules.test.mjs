// The colours of charts: distinguishable for everyone, and different where charts meet.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { loadModule as load } from './modules.mjs';

/**
 * Machado, Oliveira, Fernandes 2009, severity 1: linear sRGB as seen by people who lack one kind of
 * cone.
 */
const VISIONS = {
  all: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  protanopia: [
    0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998,
  ],
  deuteranopia: [
    0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.01182, 0.04294, 0.968881,
  ],
  tritanopia: [
    1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.3039,
  ],
};

/** In OKLab, where about 0.02 is the smallest visible difference. */
const LEAST_DISTANCE = 0.09;
/** From WCAG, for lines and shapes. */
const LEAST_CONTRAST = 3;

/** The custom properties of a theme. */
function tokens(theme) {
  const text = readFileSync(join(ROOT, 'web/src/css/tokens.css'), 'utf8');
  const [dark, light] = text.split(':root[data-theme="light"]');
  const all = (part) => [...part.matchAll(/--([\w-]+):\s*(#[0-9a-f]+);/g)];
  const found = [...all(dark), ...(theme === 'light' ? all(light) : [])];
  return new Map(found.map(([, name, color]) => [name, color]));
}

function linear(color) {
  const digits = color.length === 4 ? color.replace(/[0-9a-f]/g, '$&$&') : color;
  return [1, 3, 5].map((i) => {
    const x = Number.parseInt(digits.slice(i, i + 2), 16) / 255;
    return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
  });
}

const times = (m, [x, y, z]) => [0, 3, 6].map((i) => m[i] * x + m[i + 1] * y + m[i + 2] * z);

function oklab(rgb) {
  const toCones = [
    0.4122214708, 0.5363325363, 0.0514459929, 0.2119034982, 0.6806995451, 0.1073969566,
    0.0883024619, 0.2817188376, 0.6299787005,
  ];
  const toLab = [
    0.2104542553, 0.793617785, -0.0040720468, 1.9779984951, -2.428592205, 0.4505937099,
    0.0259040371, 0.7827717662, -0.808675766,
  ];
  return times(toLab, times(toCones, rgb).map(Math.cbrt));
}

function contrast(a, b) {
  const [low, high] = [a, b]
    .map((color) => times([0.2126, 0.7152, 0.0722, 0, 0, 0, 0, 0, 0], linear(color))[0])
    .sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
}

async function chartTokens(theme) {
  const { CHART_COLORS } = await load('colors/chart-colors');
  const all = tokens(theme);
  return Array.from({ length: CHART_COLORS }, (_, i) => all.get(`chart-${i}`));
}

for (const theme of ['dark', 'light']) {
  for (const [name, vision] of Object.entries(VISIONS))
    test(`${theme}: any two chart colours differ, vision with ${name === 'all' ? 'all cones' : name}`, async () => {
      const seen = (await chartTokens(theme)).map((color) =>
        oklab(times(vision, linear(color)).map((x) => Math.min(1, Math.max(0, x)))),
      );
      for (const [i, a] of seen.entries())
        for (const [j, b] of seen.slice(0, i).entries()) {
          const distance = Math.hypot(...a.map((x, d) => x - b[d]));
          assert.ok(
            distance >= LEAST_DISTANCE,
            `chart-${j} and chart-${i}: ${distance.toFixed(3)}`,
          );
        }
    });

  test(`${theme}: seams stand out from every chart and from the colours of distortion`, async () => {
    const all = tokens(theme);
    const below = [...(await chartTokens(theme)), ...[0, 1, 2, 3].map((i) => all.get(`ramp-${i}`))];
    for (const color of below) {
      const found = contrast(all.get('seam'), color);
      assert.ok(found >= LEAST_CONTRAST, `${color}: ${found.toFixed(2)}`);
    }
  });
}

/**
 * A grid of n x n squares of two triangles each; every block of `size` x `size` squares is a chart
 * with its own vertices, laid out as it is.
 */
function patchwork(n, size, height = () => 0) {
  const positions = [];
  const uv = [];
  const indices = [];
  const chartOfTriangle = [];
  const across = Math.ceil(n / size);
  for (let y = 0; y < n; ++y)
    for (let x = 0; x < n; ++x) {
      const first = positions.length / 3;
      for (const [i, j] of [
        [x, y],
        [x + 1, y],
        [x + 1, y + 1],
        [x, y + 1],
      ]) {
        positions.push(i, j, height(i, j));
        // Leaves a gap between charts.
        uv.push((i + 2 * Math.floor(x / size)) / (3 * n), (j + 2 * Math.floor(y / size)) / (3 * n));
      }
      indices.push(first, first + 1, first + 2, first, first + 2, first + 3);
      const chart = Math.floor(y / size) * across + Math.floor(x / size);
      chartOfTriangle.push(chart, chart);
    }
  return {
    positions: Float64Array.from(positions),
    uv: Float64Array.from(uv),
    indices: Uint32Array.from(indices),
    chartOfTriangle: Uint32Array.from(chartOfTriangle),
    vertexMap: Uint32Array.from(positions.slice(0, positions.length / 3), (_, v) => v),
    chartCount: across * across,
  };
}

test('charts that meet differ in colour, also where they only touch; the same atlas has the same colours', async () => {
  const { atlasPicture } = await load('drawing/picture');
  const { chartCount, ...atlas } = patchwork(24, 3);
  const picture = () => atlasPicture(atlas, { tiles: 1, chartCount }, atlas);
  const { chartColors } = picture();
  assert.equal(chartColors.length, 64);
  for (let y = 0; y < 8; ++y)
    for (let x = 0; x < 8; ++x)
      for (const [i, j] of [
        [x + 1, y],
        [x, y + 1],
        [x + 1, y + 1],
        [x - 1, y + 1],
      ])
        if (i >= 0 && i < 8 && j < 8)
          assert.notEqual(
            chartColors[8 * y + x],
            chartColors[8 * j + i],
            `${x},${y} and ${i},${j}`,
          );
  assert.deepEqual(picture().chartColors, chartColors);
});

test('charts side by side in the layout differ in colour although they do not meet in 3D', async () => {
  const { atlasPicture } = await load('drawing/picture');
  // Twelve triangles far from each other, in a row in the layout.
  const count = 12;
  const rows = (size, row) => Float64Array.from({ length: 3 * size * count }, (_, i) => row(i));
  const corner = (i) => [0, 1, 0, 0, 0, 1][i % 6];
  const uv = rows(
    2,
    (i) => (i % 2 === 0 ? Math.floor(i / 6) / count : 0) + corner(i) / (count + 1),
  );
  const positions = rows(3, (i) =>
    i % 3 === 2 ? Math.floor(i / 9) : corner(2 * (Math.floor(i / 3) % 3) + (i % 3)),
  );
  const indices = Uint32Array.from({ length: 3 * count }, (_, c) => c);
  const chartOfTriangle = Uint32Array.from({ length: count }, (_, f) => f);
  const atlas = { uv, indices, vertexMap: indices, chartOfTriangle, positions };
  const { chartColors } = atlasPicture(
    atlas,
    { tiles: 1, chartCount: count },
    { positions, indices },
  );
  for (let i = 1; i < count; ++i) assert.notEqual(chartColors[i], chartColors[i - 1]);
});

test('many charts that touch in one point are coloured at once', async () => {
  const { chartColors } = await load('colors/chart-colors');
  const count = 30_000;
  const indices = Uint32Array.from({ length: 3 * count }, (_, c) => c);
  const found = chartColors({
    indices,
    chartOfTriangle: Uint32Array.from({ length: count }, (_, f) => f),
    chartCount: count,
    edges: Uint32Array.from({ length: 6 * count }, (_, i) => {
      const c = i >> 1;
      return i % 2 === 0 ? c : c % 3 === 2 ? c - 2 : c + 1;
    }),
    places: indices.map((c) => (c % 3 === 0 ? 0 : c)),
    uv: Float64Array.from({ length: 6 * count }, () => 0.5),
  });
  assert.equal(found.length, count);
  assert.ok(found.every((color) => color >= 0));
});

test('colours that the views read from the style sheet have six digits', () => {
  const text = (path) => readFileSync(join(ROOT, 'web/src', path), 'utf8');
  const named = [...text('colors/palette.ts').matchAll(/color\('([\w-]+)'\)/g)].map(
    ([, name]) => name,
  );
  assert.ok(named.length > 10);
  const read = new RegExp(
    `^\\s*--(${named.join('|')}|(?:chart|ramp)-\\d+|overlapping|outside|empty|stacked): (.*);`,
    'gm',
  );
  const values = [...text('css/tokens.css').matchAll(read)];
  assert.ok(values.length > 2 * named.length, 'in both themes');
  for (const [, name, value] of values) assert.match(value, /^#[0-9a-f]{6}$/, name);
});
