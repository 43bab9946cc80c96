// Measures that published evaluations of unwrappers print, and the look of seams: from triangles
// with texcoords and the surface they lie on.

import { chartsOf } from '../../support/atlas.mjs';
import { measureAtlas } from './atlas_measures.mjs';

const sub = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const distance = (a, b) => Math.hypot(...sub(a, b));
const total = (items, numberOf) => items.reduce((sum, item) => sum + numberOf(item), 0);
const mean = (values) => total(values, (x) => x) / values.length;

/** As in the published script: a ratio counts as at most this, ... */
const LARGEST_RATIO = 10;
/** ... a triangle with less than this fraction of the mean area does not count, ... */
const LEAST_PART = 1e-4;
/** ... nor do the angles of one whose doubled area in the layout is this small. */
const LEAST_DETERMINANT = 1e-12;

/** A number for each row of a table, equal for rows with equal values. */
function numbersOf(rows) {
  const numbers = new Map();
  return rows.map((row) => {
    const key = row.join(' ');
    if (!numbers.has(key)) numbers.set(key, numbers.size);
    return numbers.get(key);
  });
}

function surfaceArea([a, b, c]) {
  const [e, g] = [sub(b, a), sub(c, a)];
  const normal = [0, 1, 2].map((d) => {
    const [i, j] = [(d + 1) % 3, (d + 2) % 3];
    return e[i] * g[j] - e[j] * g[i];
  });
  return Math.hypot(...normal) / 2;
}

const determinant = ([a, b, c]) => (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);

/** Each triangle with its points, places (numbers of its texcoords), areas and chart. */
function piecesOf({ triangles, positions, texcoords }) {
  const places = numbersOf(texcoords);
  const points = numbersOf(positions);
  const faces = triangles.map(({ vertices, texcoords: t }) =>
    vertices.map((v, i) => [points[v], places[t[i]]]),
  );
  const charts = chartsOf({ faces }).ofFace;
  return triangles.map(({ vertices, texcoords: t }, f) => {
    const xyz = vertices.map((v) => positions[v]);
    const uv = t.map((i) => texcoords[i]);
    return {
      corners: faces[f],
      xyz,
      uv,
      surface: surfaceArea(xyz),
      flat: Math.abs(determinant(uv)) / 2,
      chart: charts[f],
    };
  });
}

function groupByChart(items) {
  const groups = new Map();
  for (const item of items) {
    const group = groups.get(item.chart);
    if (group) group.push(item);
    else groups.set(item.chart, [item]);
  }
  return groups;
}

/**
 * Edges with only one triangle in the layout: the outlines of charts, including each of the two
 * sides of a seam.
 */
function outlineOf(pieces) {
  const edges = new Map();
  for (const { corners, xyz, uv, chart } of pieces)
    for (let i = 0; i < 3; i++) {
      const j = (i + 1) % 3;
      const ends = [corners[i][1], corners[j][1]].toSorted((a, b) => a - b);
      const key = ends.join(' ');
      const isOnly = !edges.has(key);
      const points = [corners[i][0], corners[j][0]];
      edges.set(key, isOnly && { chart, points, xyz: [xyz[i], xyz[j]], uv: [uv[i], uv[j]] });
    }
  return [...edges.values()].filter(Boolean);
}

/**
 * Means of max(r, 1 / r), where r is the area in the layout over that on the surface, relative to
 * that of all the pieces.
 */
function areaRatios(pieces) {
  const surface = total(pieces, (piece) => piece.surface);
  const scale = surface / total(pieces, (piece) => piece.flat);
  const least = (LEAST_PART * surface) / pieces.length;
  return pieces
    .filter((piece) => piece.surface > 0 && piece.surface >= least && piece.flat > 0)
    .map((piece) => (scale * piece.flat) / piece.surface)
    .map((ratio) => Math.min(LARGEST_RATIO, Math.max(ratio, 1 / ratio)));
}

/** Weights each chart by its number of triangles. */
function areaByChart(charts) {
  const ofChart = (pieces) => {
    const ratios = areaRatios(pieces);
    return pieces.length * (ratios.length > 0 ? mean(ratios) : 1);
  };
  const groups = [...charts.values()];
  return total(groups, ofChart) / total(groups, (pieces) => pieces.length);
}

/**
 * |cos| of the angle between the images on the surface of the layout's directions u and v; null
 * without area.
 */
function skewOf({ xyz: [a, b, c], uv: [p, q, r], surface }) {
  const det = determinant([p, q, r]);
  if (Math.abs(det) <= LEAST_DETERMINANT || surface === 0) return null;
  const [e, g] = [sub(b, a), sub(c, a)];
  const [[u1, v1], [u2, v2]] = [sub(q, p), sub(r, p)];
  const alongU = e.map((x, d) => (v2 * x - v1 * g[d]) / det);
  const alongV = e.map((x, d) => (u1 * g[d] - u2 * x) / det);
  return Math.abs(dot(alongU, alongV)) / Math.sqrt(dot(alongU, alongU) * dot(alongV, alongV));
}

/**
 * 4 pi A / P^2 of charts in the layout, 1 for a disk: the mean, weighted by area on the surface.
 */
function compactness(charts, outline) {
  const outlines = groupByChart(outline);
  const parts = [...charts].map(([chart, pieces]) => {
    const perimeter = total(outlines.get(chart) ?? [], ({ uv }) => distance(...uv));
    const surface = total(pieces, (piece) => piece.surface);
    return {
      surface,
      value: (4 * Math.PI * total(pieces, (piece) => piece.flat)) / perimeter ** 2,
    };
  });
  return total(parts, (part) => part.surface * part.value) / total(parts, (part) => part.surface);
}

/**
 * The same edges on the surface, once each: those of two outlines are seams, the others its
 * boundary.
 */
function onSurface(outline) {
  const sides = new Map();
  for (const edge of outline) {
    const key = edge.points.toSorted((a, b) => a - b).join(' ');
    sides.set(key, { ...edge, isSeam: sides.has(key) });
  }
  return [...sides.values()];
}

/**
 * How much seams turn where they continue, between junctions and ends: radians per length, in units
 * of the square root of the surface's area.
 */
function turning(edges, surface) {
  const ways = new Map();
  for (const { points, xyz, isSeam } of edges)
    for (const [i, point] of points.entries()) {
      const way = { isSeam, direction: sub(xyz[1 - i], xyz[i]) };
      ways.set(point, [...(ways.get(point) ?? []), way]);
    }
  const inner = [...ways.values()].filter((w) => w.length === 2 && w.every((way) => way.isSeam));
  const turns = inner.map(([{ direction: a }, { direction: b }]) => {
    const cosine = -dot(a, b) / Math.sqrt(dot(a, a) * dot(b, b));
    return Math.acos(Math.min(1, Math.max(-1, cosine)));
  });
  const seams = edges.filter(({ isSeam }) => isSeam);
  const length = total(seams, ({ xyz }) => distance(...xyz));
  return length > 0 ? total(turns, (x) => x) / (length / Math.sqrt(surface)) : 0;
}

/** What can be drawn: triangles with their charts, outlines in the layout, seams and boundary on the surface. */
export function seamsOf(layout) {
  const pieces = piecesOf(layout);
  const outline = outlineOf(pieces);
  const edges = onSurface(outline);
  return {
    pieces,
    outline,
    seams: edges.filter(({ isSeam }) => isSeam),
    boundary: edges.filter(({ isSeam }) => !isSeam),
  };
}

/**
 * `triangles` are `{ vertices, texcoords }` of 3 indices each. `seam` is the length of all outlines
 * in the packed layout; `seam3` is their length on the surface over the square root of its area,
 * counting both sides of a seam, and boundaries. `area` is the mean change of area relative to the
 * chart, `areaOverall` relative to the mesh; `angular` is 1 if right angles stay right; `sd` is the
 * symmetric Dirichlet energy / 4 at equal total area.
 */
export function measureLayout(layout) {
  const pieces = piecesOf(layout);
  const charts = groupByChart(pieces);
  const outline = outlineOf(pieces);
  const surface = total(pieces, (piece) => piece.surface);
  return {
    charts: charts.size,
    seam: total(outline, ({ uv }) => distance(...uv)),
    seam3: total(outline, ({ xyz }) => distance(...xyz)) / Math.sqrt(surface),
    area: areaByChart(charts),
    areaOverall: mean(areaRatios(pieces)),
    angular: 1 - mean(pieces.map(skewOf).filter((skew) => skew !== null)),
    sd: measureAtlas(layout).symmetricDirichlet,
    compactness: compactness(charts, outline),
    turning: turning(onSurface(outline), surface),
  };
}

/**
 * The layout of an OBJ text as read by parseObj, with polygons as triangle fans around their first
 * corner.
 */
export function layoutOf({ positions, texcoords, faces }) {
  const corners = faces.flatMap((face) =>
    face.slice(2).map((last, i) => [face[0], face[i + 1], last]),
  );
  const triangles = corners.map((three) => ({
    vertices: three.map(([v]) => v),
    texcoords: three.map(([, t]) => t),
  }));
  return { triangles, positions, texcoords };
}
