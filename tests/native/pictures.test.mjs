// Pictures of the atlas: --layout as SVG and PNG, --scale, --heat-map.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { islandsOf } from '../support/islands.mjs';
import { parsePng } from '../support/png.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { TRIANGLE } from '../support/small-meshes.mjs';
import * as surfaces from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { parseXml } from '../support/xml.mjs';

const UNWRAP = ['unwrap', 'in.obj', '-o', 'out.obj', '--report', 'r.json'];

/** Unwraps a text and reads the output. */
async function unwrapped(at, text, ...options) {
  writeFileSync(at('in.obj'), text);
  const { code, stderr } = await runAbflat([...UNWRAP, ...options], { cwd: at() });
  assert.deepEqual([code, stderr], [0, '']);
  const out = readFileSync(at('out.obj'), 'utf8');
  const uv = [...out.matchAll(/^vt (\S+) (\S+)/gm)].map(([, u, v]) => [Number(u), Number(v)]);
  const faces = [...out.matchAll(/^f (.*)/gm)].map(([, words]) =>
    words.split(' ').map((word) => Number(word.split('/')[1]) - 1),
  );
  return { out, uv, faces, report: JSON.parse(readFileSync(at('r.json'), 'utf8')) };
}

const distanceToLine = ([x, y], [ax, ay], [bx, by]) =>
  ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / Math.hypot(bx - ax, by - ay);

test('pixels of a known triangle: inside, outline, outside', async (t) => {
  const at = tempFolder(t);
  const { uv, faces } = await unwrapped(at, TRIANGLE, '--layout', 'l.png', '--resolution', '200');
  const png = parsePng(readFileSync(at('l.png')));
  assert.deepEqual([png.width, png.height], [200, 200]);
  // v goes up, rows go down.
  const corners = faces[0].map((i) => [200 * uv[i][0], 200 * (1 - uv[i][1])]);
  const ink = [0x1b, 0x24, 0x30, 255];
  let inside = 0;
  let outline = 0;
  for (let y = 0; y < 200; y++)
    for (let x = 0; x < 200; x++) {
      const pixel = png.at(x, y);
      // Upside down, so the inside is where all distances are negative.
      const d = corners.map((a, i) => distanceToLine([x + 0.5, y + 0.5], a, corners[(i + 1) % 3]));
      const most = Math.max(...d);
      if (most < -2) {
        inside++;
        assert.equal(pixel[3], 255);
        assert.ok(
          pixel.slice(0, 3).every((c) => c > 90),
          `pale at ${x},${y}: ${pixel}`,
        );
        assert.ok(Math.max(...pixel.slice(0, 3)) > 180);
      } else if (Math.abs(most) < 0.4) {
        const isNearCorner = corners.some(([a, b]) => Math.hypot(a - x, b - y) < 4);
        if (!isNearCorner) assert.deepEqual(pixel, ink, `outline at ${x},${y}`);
        outline++;
      } else if (most > 3) {
        assert.equal(pixel[3], 0, `transparent at ${x},${y}`);
      }
    }
  const area = Math.abs(
    distanceToLine(corners[2], corners[0], corners[1]) *
      Math.hypot(corners[1][0] - corners[0][0], corners[1][1] - corners[0][1]),
  );
  assert.ok(inside > 0.3 * area && outline > 100);
});

test('every face shows the colour of its chart, and charts differ', async (t) => {
  const at = tempFolder(t);
  const text = surfaces.objText(surfaces.boxArray(2));
  const { out, uv, faces, report } = await unwrapped(
    at,
    text,
    ...['--layout', 'l.png', '--seams', 'sharp=60', '--resolution', '512'],
  );
  const png = parsePng(readFileSync(at('l.png')));
  const islands = islandsOf(out);
  const colours = new Map();
  for (const [f, face] of faces.entries()) {
    const corners = face.map((i) => uv[i]);
    const [x, y] = [0, 1].map((d) => corners.reduce((sum, p) => sum + p[d], 0) / corners.length);
    const colour = `${png.at(Math.floor(512 * x), Math.floor(512 * (1 - y)))}`;
    assert.equal(colours.get(islands[f]) ?? colour, colour);
    colours.set(islands[f], colour);
  }
  assert.equal(colours.size, report.charts.length);
  assert.equal(new Set(colours.values()).size, colours.size);
});

/** Total length of the lines of a path of integers, and its points. */
function walk(d) {
  const points = [];
  let [x, y] = [0, 0];
  let start = [0, 0];
  let length = 0;
  for (const [, command, numbers] of d.matchAll(/([mlz])([^mlz]*)/g)) {
    if (command === 'z') {
      length += Math.hypot(start[0] - x, start[1] - y);
      [x, y] = start;
      continue;
    }
    const values = (numbers.match(/-?\d+/g) ?? []).map(Number);
    for (let i = 0; i < values.length; i += 2) {
      x += values[i];
      y += values[i + 1];
      if (command === 'm') start = [x, y];
      else length += Math.hypot(values[i], values[i + 1]);
      points.push([x, y]);
    }
  }
  return { points, length };
}

const elementsOf = (elements, name) => elements.filter((element) => element.name === name);

test('SVG: a group per chart, each edge once, to true scale on request', async (t) => {
  const at = tempFolder(t);
  // A box of 30 x 20 x 10 units: flat sides preserve all lengths.
  const size = [30, 20, 10];
  const { positions, faces } = surfaces.boxArray(1);
  const low = [0, 1, 2].map((d) => Math.min(...positions.map((p) => p[d])));
  const high = [0, 1, 2].map((d) => Math.max(...positions.map((p) => p[d])));
  const box = {
    positions: positions.map((p) => p.map((x, d) => ((x - low[d]) / (high[d] - low[d])) * size[d])),
    faces,
  };
  const text = surfaces.objText(box);
  const { report } = await unwrapped(
    at,
    text,
    ...['--seams', 'sharp=60', '--layout', 'l.svg', '--scale', '2.5'],
  );
  const svg = parseXml(readFileSync(at('l.svg')));
  const root = elementsOf(svg, 'svg')[0];
  assert.equal(root.attributes.width, root.attributes.height);
  assert.match(root.attributes.width, /mm$/);
  const millimetres = Number.parseFloat(root.attributes.width) / 100000;
  const groups = elementsOf(svg, 'g');
  assert.equal(groups.length, report.charts.length);
  assert.equal(groups.length, 6);
  const perimeters = elementsOf(svg, 'path')
    .filter((path) => path.attributes.class === 'outline')
    .map((path) => path.attributes.d)
    .map((d) => walk(d).length * millimetres)
    .sort((a, b) => a - b);
  for (const [i, wanted] of [60, 60, 80, 80, 100, 100].entries())
    assert.ok(Math.abs(perimeters[i] - 2.5 * wanted) < 0.05, `${perimeters}`);
  await unwrapped(at, text, '--layout', 'l.svg', '--resolution', '300');
  assert.equal(
    Number(elementsOf(parseXml(readFileSync(at('l.svg'))), 'svg')[0].attributes.width),
    300,
  );
});

test('SVG: inner edges and outlines together are the edges of the faces', async (t) => {
  const at = tempFolder(t);
  const { uv, faces } = await unwrapped(
    at,
    surfaces.objText(surfaces.torus()),
    '--layout',
    'l.svg',
  );
  const edges = new Map();
  for (const face of faces)
    for (const [i, a] of face.entries()) {
      const b = face[(i + 1) % face.length];
      const key = `${Math.min(a, b)} ${Math.max(a, b)}`;
      edges.set(key, { count: (edges.get(key)?.count ?? 0) + 1, a, b });
    }
  const lengthOf = (count) =>
    [...edges.values()]
      .filter((e) => e.count === count)
      .reduce((sum, { a, b }) => sum + Math.hypot(uv[a][0] - uv[b][0], uv[a][1] - uv[b][1]), 0);
  const paths = elementsOf(parseXml(readFileSync(at('l.svg'))), 'path');
  for (const [kind, count] of [
    ['outline', 1],
    ['edges', 2],
  ]) {
    const drawn = paths
      .filter((p) => p.attributes.class === kind)
      .reduce((sum, p) => sum + walk(p.attributes.d).length / 100000, 0);
    const wanted = lengthOf(count);
    assert.ok(Math.abs(drawn - wanted) < 1e-3 * wanted, `${kind}: ${drawn} for ${wanted}`);
  }
});

test('the heat map is white where nothing is stretched, and red and blue where it is', async (t) => {
  const at = tempFolder(t);
  const map = ['--heat-map', 'h.png', '--resolution', '256'];
  // Outlines are dark.
  const colours = () => {
    const png = parsePng(readFileSync(at('h.png')));
    const all = [];
    for (let y = 0; y < 256; y++)
      for (let x = 0; x < 256; x++) {
        const pixel = png.at(x, y);
        const isDark = Math.max(...pixel.slice(0, 3)) < 0x98;
        if (pixel[3] === 255 && !isDark) all.push(pixel.slice(0, 3));
      }
    return all;
  };
  await unwrapped(at, surfaces.objText(surfaces.boxArray(1)), '--seams', 'sharp=60', ...map);
  const flat = colours();
  assert.ok(flat.filter((c) => c.every((x) => x === 0xf7)).length > 0.9 * flat.length);
  for (const [r, , b] of flat) assert.ok(Math.abs(r - b) < 24, 'white, mixed with ink at outlines');
  // A dome that is a disk, so it is enlarged in some places and shrunk in others.
  const { positions, faces } = surfaces.sphere(8);
  const dome = faces.filter((face) => face.some((v) => positions[v][2] > -0.2));
  await unwrapped(at, surfaces.objText({ positions, faces: dome }), '--seams', 'none', ...map);
  const seen = colours();
  assert.ok(seen.some(([r, , b]) => r > b + 60));
  assert.ok(seen.some(([r, , b]) => b > r + 60));
  assert.ok(seen.every(([r, g, b]) => [r, g, b].every((c) => c >= 0x18 && c <= 0xf7)));
});

test('pictures of a mesh with every defect cover what the atlas covers', async (t) => {
  const at = tempFolder(t);
  const { report } = await unwrapped(
    at,
    surfaces.objText(surfaces.defects()),
    ...['--heat-map', 'h.png', '--layout', 'l.svg', '--resolution', '512', '--padding', '8'],
  );
  const png = parsePng(readFileSync(at('h.png')));
  let cover = 0;
  for (let y = 0; y < 512; y++) for (let x = 0; x < 512; x++) cover += png.at(x, y)[3] / 255;
  const elements = parseXml(readFileSync(at('l.svg')));
  assert.equal(elementsOf(elements, 'g').length, report.charts.length);
  const outline = elements
    .filter((element) => element.attributes.class === 'outline')
    .reduce((sum, element) => sum + (walk(element.attributes.d).length / 100000) * 512, 0);
  // Half of a line two pixels wide lies outside; more at corners, less where two lines meet.
  const beyond = cover - report.atlas.utilization * 512 ** 2;
  assert.ok(beyond > 0.5 * outline && beyond < 1.3 * outline, `${beyond} along ${outline}`);
});

test('a run that goes wrong leaves no picture; wrong names and sizes are told first', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), TRIANGLE);
  for (const [options, wanted] of [
    [['--layout', 'l.jpg'], /--layout: use a name that ends in \.svg or \.png, not 'l\.jpg'/],
    [['--heat-map', 'l.svg'], /--heat-map: use a name that ends in \.png/],
    [['--layout', 'l.png', '--scale', '2'], /--scale: needs an SVG/],
    [['--layout', 'l.svg', '--scale', '0'], /--scale: must be a number above 0/],
    [['--layout', 'l.png', '--resolution', '20000'], /--layout: a PNG has at most 16384/],
    [['--layout', 'x.png', '--heat-map', './x.png'], /--heat-map: is the same file as --layout/],
    [['--write-seams', 'r.json'], /--write-seams: is the same file as --report/],
    [['--seams', 'file=e.svg', '--layout', 'e.svg'], /--layout: would replace the file of --seams/],
  ]) {
    const { code, stderr } = await runAbflat([...UNWRAP, ...options], { cwd: at() });
    assert.deepEqual([code, wanted.test(stderr)], [2, true], stderr);
  }
  const bad = ['--layout', 'l.png', '--heat-map', 'none/h.png'];
  const { code } = await runAbflat([...UNWRAP, ...bad], { cwd: at() });
  assert.equal(code, 5);
  for (const name of ['l.png', 'l.jpg', 'l.svg', 'out.obj'])
    assert.equal(existsSync(at(name)), false);
});
