// Surfaces as generators and scanners leave them: what they are made of, and that they unwrap.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { dirtyMesh, KINDS_OF_DIRT } from '../support/dirty-meshes.mjs';
import { isInstrumented } from '../support/run-abflat.mjs';
import { unwrapJudged } from '../support/unwrap-judged.mjs';

const FACES = 3000;
const UNWRAPPED = isInstrumented ? 900 : FACES;

/** How many edges have one face, two, three, ...: `[undefined, ones, twos, ...]`. */
function edgesByFaces({ faces }) {
  const count = new Map();
  for (const face of faces)
    for (const [k, a] of face.entries()) {
      const b = face[(k + 1) % 3];
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      count.set(key, (count.get(key) ?? 0) + 1);
    }
  const out = [];
  for (const n of count.values()) out[n] = (out[n] ?? 0) + 1;
  return out;
}

test('each kind of dirt is what it says', () => {
  const clean = dirtyMesh(FACES, 'clean');
  assert.ok(edgesByFaces(clean)[2] > 0.999 * 1.5 * clean.faces.length);
  assert.ok(Math.abs(clean.faces.length / FACES - 1) < 0.1);
  assert.deepEqual(dirtyMesh(FACES, 'staircase').faces, clean.faces);
  const fins = edgesByFaces(dirtyMesh(FACES, 'fins'));
  assert.ok(fins[3] > 50 && fins[4] > 50);
  assert.ok(edgesByFaces(dirtyMesh(FACES, 'sheets'))[3] > 10);
  assert.ok(edgesByFaces(dirtyMesh(FACES, 'duplicates'))[3] > 100);
  const specks = dirtyMesh(FACES, 'specks');
  assert.equal(specks.faces.length - clean.faces.length, 8 * Math.ceil(clean.faces.length / 400));
});

for (const kind of [...KINDS_OF_DIRT, 'all'])
  test(`dirt of kind ${kind} unwraps`, async (t) => {
    const { report } = await unwrapJudged(t, dirtyMesh(UNWRAPPED, kind), '--resolution', '512');
    assert.ok(report.valid);
  });

/** The vertices, texcoords and faces of an OBJ, as [vertex, texcoord] per corner. */
function parsed(text) {
  const out = { v: [], vt: [], f: [] };
  for (const line of text.split('\n')) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'f') out.f.push(rest.map((c) => c.split('/').map((i) => i - 1)));
    else out[word]?.push(rest.map(Number));
  }
  return out;
}

const lengthOf = (a, b) => Math.hypot(...a.map((x, d) => x - b[d]));

/**
 * Of the charts with faces of the figure, which are the first `faces`: their number, and the length
 * of their outlines over the root of the figure's area.
 */
function figureCharts(text, faces) {
  const { v, f } = parsed(text);
  const across = new Map();
  for (const [i, face] of f.entries())
    for (const [k, a] of face.entries()) across.set(`${a} ${face[(k + 1) % 3]}`, i);
  const parent = f.map((_, i) => i);
  const rootOf = (i) => {
    while (parent[i] !== i) i = parent[i] = parent[parent[i]];
    return i;
  };
  let [outline, area] = [0, 0];
  for (const [i, face] of f.entries()) {
    const [a, b, c] = face.map(([at]) => v[at]);
    const [x, y, z] = [lengthOf(a, b), lengthOf(b, c), lengthOf(c, a)];
    const s = (x + y + z) / 2;
    if (i < faces) area += Math.sqrt(Math.max(0, s * (s - x) * (s - y) * (s - z)));
    for (const [k, p] of face.entries()) {
      const q = face[(k + 1) % 3];
      const beyond = across.get(`${q} ${p}`);
      if (beyond !== undefined) parent[rootOf(i)] = rootOf(beyond);
      else if (i < faces) outline += lengthOf(v[p[0]], v[q[0]]);
    }
  }
  const charts = new Set(f.slice(0, faces).map((_, i) => rootOf(i))).size;
  return { charts, outline: outline / Math.sqrt(area) };
}

/** What measures quality runs nothing with sanitizers that other tests do not. */
const ofQuality = {
  skip: isInstrumented && 'measures quality, which takes minutes with sanitizers',
};

/** What has been measured, by kind and resolution. */
const known = new Map();

/** Charts, seams and how full the tile is, for one kind of dirt on the same figure. */
async function measured(t, kind, resolution = 512) {
  const key = `${kind} ${resolution}`;
  if (!known.has(key)) known.set(key, await measure(t, kind, resolution));
  return known.get(key);
}

async function measure(t, kind, resolution) {
  const clean = dirtyMesh(20_000, 'clean').faces.length;
  const args = ['--resolution', `${resolution}`];
  const { report, text } = await unwrapJudged(t, dirtyMesh(20_000, kind), ...args);
  return {
    report,
    text,
    figure: figureCharts(text, clean),
    charts: report.charts.length,
    joints: report.repair.nonManifoldEdges.length,
    utilization: report.atlas.utilization,
  };
}

for (const kind of [...KINDS_OF_DIRT, 'all'])
  test(
    `the figure costs hardly any more charts and seams with dirt of kind ${kind}`,
    ofQuality,
    async (t) => {
      const [clean, dirty] = [await measured(t, 'clean'), await measured(t, kind)];
      // All of it together costs a little more on so few faces.
      const share = kind === 'all' ? 1.5 : 1;
      const told = `${JSON.stringify(dirty.figure)} and ${JSON.stringify(clean.figure)}`;
      assert.ok(dirty.figure.charts <= 2 * share * clean.figure.charts, told);
      assert.ok(dirty.figure.outline <= 1.5 * share * clean.figure.outline, told);
    },
  );

test('a surface goes on below its fins', ofQuality, async (t) => {
  const { charts, joints } = await measured(t, 'fins');
  assert.ok(charts < joints / 4, `${charts} charts, ${joints} edges of more than two faces`);
});

test('specks find a place between the charts', ofQuality, async (t) => {
  const [clean, specks] = [await measured(t, 'clean'), await measured(t, 'specks')];
  assert.ok(specks.utilization > 0.7 * clean.utilization);
});

test('specks of a few texels stay in one piece', ofQuality, async (t) => {
  const { charts, figure } = await measured(t, 'specks', 256);
  const specks = Math.ceil(dirtyMesh(20_000, 'clean').faces.length / 400);
  const ofSpecks = charts - figure.charts;
  assert.ok(ofSpecks <= 1.25 * specks, `${ofSpecks} charts of ${specks} specks`);
});

/** Mean symmetric Dirichlet energy / 4 of a chart's triangles, where it has its area in space. */
function stretchOf(corners, { v, vt }) {
  let [area, inUv, sum] = [0, 0, 0];
  const of = corners.map((face) => {
    const [a, b, c] = face.map(([p]) => v[p]);
    const [p, q, r] = face.map(([, u]) => vt[u]);
    // The triangle in its own plane, b along x.
    const [x, dot] = [lengthOf(a, b), b.reduce((s, _, d) => s + (b[d] - a[d]) * (c[d] - a[d]), 0)];
    const cx = dot / x;
    const cy = Math.sqrt(Math.max(0, lengthOf(a, c) ** 2 - cx * cx));
    const e = [q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1]];
    area += (x * cy) / 2;
    inUv += Math.abs(e[0] * e[3] - e[1] * e[2]) / 2;
    return { area: (x * cy) / 2, x, cx, cy, e };
  });
  const scale = Math.sqrt(area / inUv);
  for (const { area: own, x, cx, cy, e } of of) {
    const [j0, j1] = [(scale * e[0]) / x, (scale * e[1]) / x];
    const [j2, j3] = [(scale * e[2] - j0 * cx) / cy, (scale * e[3] - j1 * cx) / cy];
    const squares = j0 * j0 + j1 * j1 + j2 * j2 + j3 * j3;
    sum += (own * (squares + squares / (j0 * j3 - j1 * j2) ** 2)) / 4;
  }
  return sum / area;
}

test('stretch is told of the steps as they are', ofQuality, async (t) => {
  const { report, text } = await measured(t, 'staircase');
  assert.ok(report.notes.some((note) => note.includes('taken for smooth')));
  const obj = parsed(text);
  for (const chart of report.charts.filter(({ faces }) => faces > 1000)) {
    const own = stretchOf(facesLike(obj, chart.firstFace), obj);
    assert.ok(own > 1.1);
    assert.ok(Math.abs(chart.symmetricDirichlet / own - 1) < 0.01, `${own}`);
  }
});

/** The faces of the chart of one of them. */
function facesLike({ f }, first) {
  const across = new Map();
  for (const [i, face] of f.entries())
    for (const [k, a] of face.entries()) across.set(`${a} ${face[(k + 1) % 3]}`, i);
  const found = new Set([first]);
  for (const i of found)
    for (const [k, a] of f[i].entries()) {
      const beyond = across.get(`${f[i][(k + 1) % 3]} ${a}`);
      if (beyond !== undefined) found.add(beyond);
    }
  return [...found].map((i) => f[i]);
}
