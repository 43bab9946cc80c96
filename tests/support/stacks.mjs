// Finds charts that lie on each other in a file, with none of the program's code, and has the rest
// judged by exact arithmetic.

import { cutPolygon, isThinInSpace, judge, readAtlas, turn } from './exact-atlas.mjs';

const pointOf = ({ uv }) => uv.join(' ');

/** Twice the area of a face in uv; negative if it runs clockwise. */
function areaOf(face) {
  const cross = ({ uv: [ax, ay] }, { uv: [bx, by] }) => ax * by - ay * bx;
  return face.reduce((sum, c, i) => sum + cross(c, face[(i + 1) % face.length]), 0);
}

/** Faces by chart: those that share both texcoords of an edge. Faces without area are left out. */
function chartsIn(all) {
  const faces = all.filter((face) => !isThinInSpace(face));
  const parent = faces.map((_, f) => f);
  const root = (f) => {
    while (parent[f] !== f) f = parent[f] = parent[parent[f]];
    return f;
  };
  const seen = new Map();
  for (const [f, face] of faces.entries()) {
    const ends = face.map(({ id }) => id);
    for (const [i, end] of ends.entries()) {
      const edge = [end, ends[(i + 1) % ends.length]].sort((a, b) => a - b).join(' ');
      if (seen.has(edge)) parent[root(f)] = root(seen.get(edge));
      else seen.set(edge, f);
    }
  }
  const charts = new Map();
  for (const [f, face] of faces.entries()) {
    if (!charts.has(root(f))) charts.set(root(f), []);
    charts.get(root(f)).push(face);
  }
  return [...charts.values()];
}

/** What charts that lie on each other have in common: the places of their outlines. */
export function outlineOf(chart) {
  const sides = new Map();
  for (const face of chart)
    for (const [i, corner] of face.entries()) {
      const side = [pointOf(corner), pointOf(face[(i + 1) % face.length])].sort().join('|');
      sides.set(side, (sides.get(side) ?? 0) + 1);
    }
  const outline = [...sides].filter(([, count]) => count % 2 === 1).map(([side]) => side);
  return outline.sort().join(' ');
}

const isClockwise = (chart) => chart.reduce((sum, face) => sum + areaOf(face), 0) < 0;

const turnedOver = (chart) => chart.map((face) => [...face].reverse());

function trianglesOf(chart) {
  return chart.flatMap((face) => {
    const points = face.map(({ uv }) => uv);
    const { triangles, isCut } =
      face.length === 3 ? { triangles: [[0, 1, 2]], isCut: true } : cutPolygon(points);
    if (!isCut && !isThinInSpace(face)) return [[points[0], points[0], points[0]]];
    const own = triangles.map((t) => t.map((k) => points[k]));
    return isThinInSpace(face) ? own.filter((t) => turn(...t) !== 0) : own;
  });
}

/**
 * Judges the atlas of a file. Each chart has to be fine by itself, a mirrored one once it is turned
 * over, and one of each stack beside all others. `charts` counts those that lie on others.
 */
export function judgeStacks(path, { tiles = [1, 1] } = {}) {
  const { faces, lowestRow } = readAtlas(path);
  const groups = new Map();
  for (const chart of chartsIn(faces)) {
    const form = outlineOf(chart);
    if (!groups.has(form)) groups.set(form, []);
    groups.get(form).push({ chart, isMirrored: isClockwise(chart) });
  }
  const lowest = [];
  const found = { all: 0, charts: 0, places: 0, mirrored: 0 };
  let isValid = true;
  for (const group of groups.values()) {
    const base = group.find(({ isMirrored }) => !isMirrored);
    isValid &&= base !== undefined;
    found.all += group.length;
    found.charts += group.length - 1;
    found.places += group.length > 1;
    for (const { chart, isMirrored } of group) {
      found.mirrored += isMirrored;
      const own = trianglesOf(isMirrored ? turnedOver(chart) : chart);
      if (base?.chart === chart) lowest.push(...own);
      else isValid &&= judge(own, { tiles, lowestRow }).isValid;
    }
  }
  const together = judge(lowest, { tiles, lowestRow });
  return { ...found, isValid: isValid && together.isValid, problems: together };
}

/** The text of an OBJ with one chart of each stack, none of them mirrored. */
export function withoutStacks(path) {
  const groups = new Map();
  for (const chart of chartsIn(readAtlas(path).faces))
    if (!isClockwise(chart)) groups.set(outlineOf(chart), chart);
  const faces = [...groups.values()].flat();
  const [places, texcoords] = [[], []].map((list) => ({ list, number: new Map() }));
  const numberIn = ({ list, number }, values) => {
    const text = values.join(' ');
    if (!number.has(text)) number.set(text, list.push(text));
    return number.get(text);
  };
  // A texcoord for each chart's own vertices.
  const lines = [...groups.values()].flatMap((chart) => {
    texcoords.number.clear();
    return chart.map((face) =>
      face.map(({ place, uv }) => `${numberIn(places, place)}/${numberIn(texcoords, uv)}`),
    );
  });
  const text = [
    ...places.list.map((p) => `v ${p}`),
    ...texcoords.list.map((t) => `vt ${t}`),
    ...lines.map((face) => `f ${face.join(' ')}`),
  ];
  return { faces: faces.length, text: `${text.join('\n')}\n` };
}
