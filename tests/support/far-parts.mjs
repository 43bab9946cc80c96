// Finds parts of one chart that come near each other in the atlas, though they are far apart in
// space, only by the numbers in the file: points along outlines, each compared with those around it.

import { chartsOf, parseObj } from './atlas.mjs';

/**
 * So many paddings apart in space and along the outline, in texels of the chart. The program
 * promises 4 and 16 between the points nearest to each other; points here are only near, and
 * stretched a little.
 */
const FAR = { inSpace: 6, along: 20 };

/**
 * For each chart with such a place, { chart, face, gap, apart, at }: a face there, the least gap in
 * texels, how far its sides are apart on the mesh, in texels, and where the gap is in uv.
 */
export function farParts(text, { resolution = 1024, padding = 2 } = {}, far = FAR) {
  if (padding === 0) return [];
  const mesh = parseObj(text);
  const { ofFace, count } = chartsOf(mesh);
  const outlines = outlinesOf(mesh, ofFace, count);
  const scales = scalesOf(mesh, ofFace, count, resolution);
  return outlines
    .map((edges, chart) => worstOf(samplesOf(edges, mesh, resolution, padding / 4), scales[chart]))
    .map((worst, chart) => worst && { chart, ...worst })
    .filter(Boolean);

  function worstOf(samples, scale) {
    let worst;
    forNear(samples, padding, (p, q, gap) => {
      if (!facesAway(p, q) || !facesAway(q, p)) return;
      const apart = scale * Math.hypot(...p.place.map((x, d) => x - q.place[d]));
      if (apart < far.inSpace * padding || lengthBetween(p, q) < far.along * padding) return;
      if (!(gap >= worst?.gap))
        worst = { face: p.face, gap, apart, at: p.at.map((x) => x / resolution) };
    });
    return worst;
  }
}

/** Per chart, its loops of edges between different charts or parts of the mesh, chart on the left. */
function outlinesOf({ faces }, ofFace, count) {
  const seen = new Set();
  const each = (use) => {
    for (const [f, face] of faces.entries())
      for (const [i, from] of face.entries()) use(f, from, face[(i + 1) % face.length]);
  };
  each((_, a, b) => seen.add(`${a[1]} ${b[1]}`));
  const from = new Map();
  each((f, a, b) => {
    if (!seen.has(`${b[1]} ${a[1]}`)) from.set(a[1], { face: f, ends: [a, b] });
  });
  const out = Array.from({ length: count }, () => []);
  for (const first of from.values()) {
    const loop = [];
    for (let edge = first; edge && from.delete(edge.ends[0][1]); edge = from.get(edge.ends[1][1]))
      loop.push(edge);
    out[ofFace[first.face]].push(loop);
  }
  return out;
}

/** The shorter way along the outline. */
function lengthBetween(p, q) {
  if (p.loop !== q.loop) return Infinity;
  const length = Math.abs(p.since - q.since);
  return Math.min(length, p.loop.length - length);
}

/** Texels per unit of length, as a mean over each chart. */
function scalesOf({ positions, texcoords, faces }, ofFace, count, resolution) {
  const [onMesh, inUv] = [new Float64Array(count), new Float64Array(count)];
  for (const [f, face] of faces.entries()) {
    onMesh[ofFace[f]] += areaOf(face.map(([v]) => positions[v]));
    inUv[ofFace[f]] += areaOf(face.map(([, t]) => [...texcoords[t], 0]));
  }
  return Array.from(inUv, (area, chart) => resolution * Math.sqrt(area / onMesh[chart]));
}

function areaOf(points) {
  const sum = [0, 0, 0];
  for (let i = 2; i < points.length; i++) {
    const [a, b] = [i - 1, i].map((k) => points[k].map((x, d) => x - points[0][d]));
    for (let d = 0; d < 3; d++)
      sum[d] += a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3];
  }
  return Math.hypot(...sum) / 2;
}

/** Points at most `step` texels apart, none of them at a corner. */
function samplesOf(loops, { positions, texcoords }, resolution, step) {
  const between = (x, y, share) => x.map((c, d) => c + share * (y[d] - c));
  const out = [];
  for (const edges of loops) {
    const loop = { length: 0 };
    for (const { face, ends } of edges) {
      const [a, b] = ends.map(([, t]) => texcoords[t].map((x) => x * resolution));
      const [from, to] = ends.map(([v]) => positions[v]);
      const along = [b[0] - a[0], b[1] - a[1]];
      const length = Math.hypot(...along);
      const pieces = Math.ceil(length / step);
      for (let k = 0; k < pieces; k++) {
        const share = (k + 0.5) / pieces;
        const [at, place] = [between(a, b, share), between(from, to, share)];
        out.push({ face, along, at, place, loop, since: loop.length + share * length });
      }
      loop.length += length;
    }
  }
  return out;
}

/** Whether the way from p to q leaves the chart. */
const facesAway = (p, q) => p.along[0] * (q.at[1] - p.at[1]) - p.along[1] * (q.at[0] - p.at[0]) < 0;

function forNear(samples, reach, see) {
  const cells = new Map();
  const key = (x, y) => x * 0x100000 + y;
  const cellOf = ({ at }) => at.map((x) => Math.floor(x / reach) + 1);
  for (const p of samples) {
    const [x, y] = cellOf(p);
    for (let i = x - 1; i <= x + 1; i++)
      for (let j = y - 1; j <= y + 1; j++)
        for (const q of cells.get(key(i, j)) ?? []) {
          const gap = Math.hypot(p.at[0] - q.at[0], p.at[1] - q.at[1]);
          if (gap < reach) see(p, q, gap);
        }
    const own = cells.get(key(x, y));
    if (own) own.push(p);
    else cells.set(key(x, y), [p]);
  }
}
