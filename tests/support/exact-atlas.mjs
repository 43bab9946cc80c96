// Judges an atlas exactly, only by the numbers in its file and with none of the program's code:
// which triangles are flipped, which leave their tile, and which overlap.

import { readFileSync } from 'node:fs';
import { elementsOf, parseGltf, trianglesOf } from './glb.mjs';
import { column, elementOf, parsePly } from './ply.mjs';

const SCRATCH = new DataView(new ArrayBuffer(8));

/** A finite double as { digits, exponent }: digits * 2^exponent. */
function partsOf(x) {
  SCRATCH.setFloat64(0, x);
  const bits = SCRATCH.getBigUint64(0);
  const exponent = Number((bits >> 52n) & 0x7ffn);
  const fraction = bits & 0xfffffffffffffn;
  const digits = exponent === 0 ? fraction : fraction | 0x10000000000000n;
  return { digits: bits >> 63n ? -digits : digits, exponent: Math.max(exponent, 1) - 1075 };
}

/** Doubles as integers in a common unit. */
function wholeNumbers(values) {
  const parts = values.map(partsOf);
  const least = Math.min(...parts.map(({ exponent }) => exponent));
  return parts.map(({ digits, exponent }) => digits << BigInt(exponent - least));
}

/**
 * Sign of the area of a triangle of points [x, y], computed with integers if rounding could decide
 * it.
 */
export function turn(a, b, c) {
  const left = (b[0] - a[0]) * (c[1] - a[1]);
  const right = (b[1] - a[1]) * (c[0] - a[0]);
  // Each factor and product is off by a few 2^-53; products below the smallest normal number by
  // more.
  if (Math.abs(left - right) > 1e-14 * (Math.abs(left) + Math.abs(right)) + 1e-290)
    return Math.sign(left - right);
  const [ax, ay, bx, by, cx, cy] = wholeNumbers([...a, ...b, ...c]);
  const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  return area > 0n ? 1 : area < 0n ? -1 : 0;
}

/** The larger of two integers in size has at most 1000 digits afterwards, which a double can hold. */
function scaledDown(integers) {
  const digits = Math.max(...integers.map((x) => x.toString(2).length));
  return integers.map((x) => Number(x >> BigInt(Math.max(0, digits - 1000))));
}

/** The angle from o -> a counter-clockwise to o -> b, 0 to 2 pi; only its last steps are rounded. */
export function angleBetween(a, o, b) {
  const [ax, ay, ox, oy, bx, by] = wholeNumbers([...a, ...o, ...b]);
  const [px, py, qx, qy] = [ax - ox, ay - oy, bx - ox, by - oy];
  const angle = Math.atan2(...scaledDown([px * qy - py * qx, px * qx + py * qy]));
  return angle < 0 ? angle + 2 * Math.PI : angle;
}

/** Whether two counter-clockwise triangles share more than boundary. */
export function overlap(s, t) {
  const separates = (p, q) =>
    [0, 1, 2].some((k) => q.every((point) => turn(p[k], p[(k + 1) % 3], point) <= 0));
  return !separates(s, t) && !separates(t, s);
}

/**
 * Visits pairs whose boxes overlap, each once: from left to right, in rows. If `see(i, j)` returns
 * false, the search ends.
 */
function forNearPairs(boxes, see) {
  const order = boxes.map((_, i) => i).sort((a, b) => boxes[a].low[0] - boxes[b].low[0] || a - b);
  let [low, high, sum] = [Infinity, -Infinity, 0];
  for (const box of boxes) {
    low = Math.min(low, box.low[1]);
    high = Math.max(high, box.high[1]);
    sum += box.high[1] - box.low[1];
  }
  const count = Math.max(
    1,
    Math.min(boxes.length, Math.floor(((high - low) / sum) * boxes.length) || 1),
  );
  const rowOf = (y) =>
    Math.max(0, Math.min(count - 1, Math.floor(((y - low) / (high - low)) * count) || 0));
  const rows = Array.from({ length: count }, () => []);
  for (const i of order) {
    const box = boxes[i];
    const [first, last] = [rowOf(box.low[1]), rowOf(box.high[1])];
    for (let r = first; r <= last; r++) {
      const open = rows[r].filter((j) => boxes[j].high[0] > box.low[0]);
      rows[r] = open;
      for (const j of open) {
        const other = boxes[j];
        // Only in the first row that both are in.
        const isFirst = r === Math.max(first, rowOf(other.low[1]));
        if (isFirst && box.low[1] < other.high[1] && other.low[1] < box.high[1] && !see(i, j))
          return;
      }
      open.push(i);
    }
  }
}

const boxOf = (triangle) => ({
  low: [0, 1].map((d) => Math.min(...triangle.map((p) => p[d]))),
  high: [0, 1].map((d) => Math.max(...triangle.map((p) => p[d]))),
});

/**
 * Judges triangles [[u, v], [u, v], [u, v]]. `mayBeFlat(i)`: whether triangle i may have no area.
 * `tiles`: [columns, rows] that are allowed, with the first row at `lowestRow`. Returns { flipped,
 * flat, outside } as lists of triangles and { overlaps } as at most `most` pairs; `isValid` if all
 * are empty.
 */
export function judge(
  triangles,
  { mayBeFlat = () => false, tiles = [1, 1], lowestRow = 0, most = 10 } = {},
) {
  const out = { triangles: triangles.length, flipped: [], flat: [], outside: [], overlaps: [] };
  const standing = [];
  const isInTile = ({ low, high }) =>
    [0, lowestRow].every((first, d) => {
      const tile = Math.floor((low[d] + high[d]) / 2);
      return tile >= first && tile < first + tiles[d] && low[d] >= tile && high[d] <= tile + 1;
    });
  triangles.forEach((triangle, i) => {
    const isKnown = triangle.flat().every(Number.isFinite);
    if (!isKnown || !isInTile(boxOf(triangle))) out.outside.push(i);
    const sign = isKnown ? turn(...triangle) : -1;
    if (sign < 0) out.flipped.push(i);
    if (sign === 0 && !mayBeFlat(i)) out.flat.push(i);
    if (sign > 0) standing.push(i);
  });
  forNearPairs(
    standing.map((i) => boxOf(triangles[i])),
    (a, b) => {
      const [i, j] = [standing[a], standing[b]];
      if (overlap(triangles[i], triangles[j])) out.overlaps.push([Math.min(i, j), Math.max(i, j)]);
      return out.overlaps.length < most;
    },
  );
  out.isValid = [out.flipped, out.flat, out.outside, out.overlaps].every((list) => !list.length);
  return out;
}

const isSame = (p, q) => p[0] === q[0] && p[1] === q[1];

/**
 * Triangulates a counter-clockwise polygon, which may touch itself. Corners at the same point as
 * the one before bound nothing.
 */
export function cutPolygon(points) {
  const left = points.map((_, i) => i).filter((i) => !isSame(points[i], points.at(i - 1)));
  const out = [];
  if (left.length < 3) return { triangles: out, isCut: false };
  while (left.length > 3) {
    const ear = left.findIndex((b, i) => {
      const [a, c] = [left.at(i - 1), left[(i + 1) % left.length]];
      if (turn(points[a], points[b], points[c]) <= 0) return false;
      return left.every(
        (p) =>
          [a, b, c].includes(p) ||
          [
            [a, b],
            [b, c],
            [c, a],
          ].some(([from, to]) => turn(points[from], points[to], points[p]) < 0) ||
          [a, b, c].some((q) => isSame(points[q], points[p])),
      );
    });
    if (ear < 0) return { triangles: out, isCut: false };
    out.push([left.at(ear - 1), left[ear], left[(ear + 1) % left.length]]);
    left.splice(ear, 1);
  }
  out.push([...left]);
  return { triangles: out, isCut: true };
}

/**
 * What a reader finds in a file: `faces` as lists of corners { place, uv, id }, three each for a
 * glTF, with v upwards; `id` is the same for corners that share a texcoord. The v of a glTF is
 * 1 - v', which is not rounded here: it is taken as -v', in tiles from -1 up.
 */
export function readAtlas(path) {
  const bytes = readFileSync(path);
  if (/\.(glb|gltf)$/.test(path)) return fromGltf(parseGltf(bytes));
  if (path.endsWith('.ply')) return fromPly(parsePly(bytes));
  return fromObj(bytes.toString());
}

function fromObj(text) {
  const [positions, texcoords, faces] = [[], [], []];
  for (const line of text.split(/\r?\n/)) {
    const [key, ...words] = line.trim().split(/\s+/);
    if (key === 'v') positions.push(words.slice(0, 3).map(Number));
    if (key === 'vt') texcoords.push(words.slice(0, 2).map(Number));
    if (key === 'f')
      faces.push(
        words.map((word) => {
          const [v, t] = word.split('/').map(Number);
          return {
            place: positions.at(v < 0 ? v : v - 1),
            uv: texcoords.at(t < 0 ? t : t - 1),
            id: t,
          };
        }),
      );
  }
  return { faces, lowestRow: 0 };
}

function fromPly(file) {
  const vertex = elementOf(file, 'vertex');
  const places = column(vertex, 'x', 'y', 'z');
  const uv = column(vertex, 's', 't');
  const faces = column(elementOf(file, 'face'), 'vertex_indices').map((face) =>
    face.map((v) => ({ place: places[v], uv: uv[v], id: v })),
  );
  return { faces, lowestRow: 0 };
}

function fromGltf(model, set = 0) {
  const faces = [];
  let first = 0;
  for (const mesh of model.json.meshes)
    for (const primitive of mesh.primitives.filter((p) => (p.mode ?? 4) >= 4)) {
      const places = elementsOf(model, primitive.attributes.POSITION);
      const uv = elementsOf(model, primitive.attributes[`TEXCOORD_${set}`]);
      for (const face of trianglesOf(model, primitive))
        faces.push(
          face.map((v) => ({ place: places[v], uv: [uv[v][0], -uv[v][1]], id: first + v })),
        );
      first += places.length;
    }
  return { faces, lowestRow: -1 };
}

const edgeBetween = (a, b) => b.place.map((x, d) => x - a.place[d]);

/** The length of the cross product of two vectors. */
const crossLength = (u, v) =>
  Math.hypot(
    ...[0, 1, 2].map((d) => u[(d + 1) % 3] * v[(d + 2) % 3] - u[(d + 2) % 3] * v[(d + 1) % 3]),
  );

/** The height of a triangle in space, relative to its longest side. */
export function flatness(corners) {
  const sides = [0, 1, 2].map((k) => edgeBetween(corners[k], corners[(k + 1) % 3]));
  const longest = Math.max(...sides.map((side) => Math.hypot(...side)));
  return crossLength(sides[0], sides[1]) / longest ** 2;
}

/** Whether corners have no area in space, as far as doubles can tell. */
export function isThinInSpace(corners) {
  const largest = Math.max(...corners.flatMap((c) => edgeBetween(corners[0], c).map(Math.abs)));
  if (!(largest > 0)) return true;
  const [u, v] = [1, 2].map((k) => edgeBetween(corners[0], corners[k]).map((x) => x / largest));
  return crossLength(u, v) < 1e-12;
}

/** Triangles of faces as [{ uv, ... }, ...], and the faces that cannot be cut into such. */
export function cutFaces(faces) {
  const [triangles, uncut] = [[], []];
  for (const [f, face] of faces.entries()) {
    const points = face.map(({ uv }) => uv);
    const cut = face.length === 3 ? { triangles: [[0, 1, 2]], isCut: true } : cutPolygon(points);
    if (!cut.isCut && !isThinInSpace(face)) uncut.push(f);
    for (const triangle of cut.triangles) triangles.push(triangle.map((k) => face[k]));
  }
  return { triangles, uncut };
}

/** With v from 0 up; what is written to a glTF loses nothing by that. */
const fromZero = ({ faces, lowestRow }) =>
  faces.map((face) => face.map((c) => ({ ...c, uv: [c.uv[0], c.uv[1] - lowestRow] })));

/**
 * Judges the contents of files that share an atlas, see judge. Polygons are cut along diagonals
 * that lie inside them in uv; those that cannot be cut, because their outline is not simple or runs
 * clockwise, are listed in `uncut`.
 */
export function judgeFiles(paths, { tiles = [1, 1], most } = {}) {
  const atlases = paths.map(readAtlas);
  const isShared = atlases.length > 1;
  const { triangles, uncut } = cutFaces(isShared ? atlases.flatMap(fromZero) : atlases[0].faces);
  const mayBeFlat = (i) => isThinInSpace(triangles[i]);
  const points = triangles.map((corners) => corners.map(({ uv }) => uv));
  const lowestRow = isShared ? 0 : atlases[0].lowestRow;
  const out = judge(points, { mayBeFlat, tiles, lowestRow, most });
  return { ...out, uncut, isValid: out.isValid && uncut.length === 0 };
}

export const judgeFile = (path, options) => judgeFiles([path], options);
