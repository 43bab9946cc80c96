// Surfaces as generators and scanners leave them, with each kind of dirt alone or all at once, as
// { positions: [[x, y, z]], faces: [[v, v, v]] }. The same size gives the same figure below the
// dirt, so that what the dirt costs can be measured.

import { randomNumbers } from './disks.mjs';

/** Each takes the figure, random numbers and the surface so far, and returns one with its dirt. */
const DIRT = {
  staircase: withStaircase,
  fins: withFins,
  sheets: withSheets,
  duplicates: withDuplicates,
  specks: withSpecks,
};

export const KINDS_OF_DIRT = Object.keys(DIRT);

/** A figure of about `size` faces with the dirt of one kind, of `all` kinds, or `clean`. */
export function dirtyMesh(size, kind = 'all', seed = 5) {
  const figure = surfaceNet(cellsFor(size));
  let mesh = { positions: [...figure.positions], faces: [...figure.faces] };
  const kinds = kind === 'all' ? KINDS_OF_DIRT : kind === 'clean' ? [] : [kind];
  for (const name of kinds) mesh = DIRT[name](figure, randomNumbers(seed), mesh);
  return mesh;
}

/** The number of its faces grows with the square of the cells. */
function cellsFor(size) {
  const cells = 40;
  return Math.round(cells * Math.sqrt(size / surfaceNet(cells).faces.length));
}

/** Rods with round ends: two ends and a radius. */
// biome-ignore format: a table
const RODS = [
  [[0, -0.1, 0], [0, 0.3, 0], 0.3],
  [[0.02, 0.66, 0.04], [0.02, 0.67, 0.04], 0.19],
  [[0.2, 0.35, 0], [0.8, 0.5, 0.1], 0.11],
  [[-0.2, 0.35, 0], [-0.75, 0.1, 0.2], 0.1],
  [[0.14, -0.2, 0], [0.25, -0.8, 0.05], 0.12],
  [[-0.14, -0.2, 0], [-0.22, -0.8, -0.1], 0.13],
];

/** Below zero inside a body with a head, arms, legs and a ring around it. */
function figureAt(x, y, z) {
  const smooth = 0.04;
  let sum = Math.exp(-(Math.hypot(Math.hypot(x, z) - 0.62, y - 0.15) - 0.1) / smooth);
  for (const [[ax, ay, az], [bx, by, bz], radius] of RODS) {
    const [px, py, pz, dx, dy, dz] = [x - ax, y - ay, z - az, bx - ax, by - ay, bz - az];
    const along = (px * dx + py * dy + pz * dz) / (dx * dx + dy * dy + dz * dz);
    const t = Math.min(1, Math.max(0, along));
    sum += Math.exp(
      (radius - Math.sqrt((px - t * dx) ** 2 + (py - t * dy) ** 2 + (pz - t * dz) ** 2)) / smooth,
    );
  }
  return -smooth * Math.log(sum) + 0.012 * Math.sin(9 * x) * Math.sin(8 * y) * Math.sin(10 * z);
}

/** Tilted, so that nothing lies level with the cells, which would give edges of four faces. */
const tiltedFigureAt = (x, y, z) => figureAt(x + 0.15 * z, y + 0.23 * x - 0.11 * z, z - 0.17 * x);

/**
 * The surface of the figure in n x n x n cells: a vertex in each cell that it crosses, a quad of
 * two triangles around each edge. `cell` is where a vertex belongs, `normals` point outwards.
 */
function surfaceNet(n) {
  const m = n + 1;
  const at = (i) => (2 * i) / n - 1;
  const value = new Float64Array(m ** 3);
  for (let z = 0; z < m; z++)
    for (let y = 0; y < m; y++)
      for (let x = 0; x < m; x++) value[(z * m + y) * m + x] = tiltedFigureAt(at(x), at(y), at(z));
  const step = [1, m, m * m];
  const placeOf = (i) => [i % m, Math.floor(i / m) % m, Math.floor(i / m ** 2)];
  const vertices = new Map(); // by cell: the sum of the crossings of its edges, and their number
  const quads = [];
  const addCrossing = (cell, point) => {
    if (!vertices.has(cell)) vertices.set(cell, { sum: [0, 0, 0], count: 0, id: vertices.size });
    const vertex = vertices.get(cell);
    for (let d = 0; d < 3; d++) vertex.sum[d] += point[d];
    vertex.count++;
    return vertex.id;
  };
  for (let i = 0; i < value.length; i++)
    for (let d = 0; d < 3; d++) {
      const isInside = value[i] < 0;
      if (isInside === value[i + step[d]] < 0) continue;
      const point = placeOf(i).map(at);
      point[d] += (2 / n) * (value[i] / (value[i] - value[i + step[d]]));
      const [u, v] = [step[(d + 1) % 3], step[(d + 2) % 3]];
      const quad = [i - u - v, i - v, i, i - u].map((cell) => addCrossing(cell, point));
      quads.push(isInside ? quad : quad.reverse());
    }
  const positions = [...vertices.values()].map(({ sum, count }) => sum.map((x) => x / count));
  const cells = [...vertices.keys()].map(placeOf);
  const faces = quads.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]); // biome-ignore format: pairs
  return { positions, faces, quads, cells, size: 2 / n, normals: normalsOf({ positions, faces }) };
}

function normalsOf({ positions, faces }) {
  const sums = positions.map(() => [0, 0, 0]);
  for (const face of faces) {
    const [a, b, c] = face.map((v) => positions[v]);
    const n = cross(minus(b, a), minus(c, a));
    for (const v of face) for (let d = 0; d < 3; d++) sums[v][d] += n[d];
  }
  return sums.map((n) => n.map((x) => x / Math.hypot(...n)));
}

/** Vertices in the middle of their cells, shaken a little: the steps of voxels. */
function withStaircase({ cells, size }, random, { positions, faces }) {
  const shaken = (i) => (i + 0.5 + 0.1 * (random() - 0.5)) * size - 1;
  return { positions: positions.map((p, v) => cells[v]?.map(shaken) ?? p), faces };
}

/**
 * Bands that stand on the surface along every tenth layer of cells, edges of three faces; every
 * second one goes on below the surface: edges of four faces.
 */
function withFins({ quads, cells, size, normals }, _random, { positions, faces }) {
  const out = { positions: [...positions], faces: [...faces] };
  const isFoot = (v) => cells[v][1] % 10 === 0;
  for (const side of [1, -1]) {
    const tips = new Map();
    const tipOf = (v) => {
      if (!tips.has(v))
        tips.set(v, out.positions.push(moved(positions[v], normals[v], side * 2.5 * size)) - 1);
      return tips.get(v);
    };
    const isTaken = new Set();
    for (const quad of quads)
      for (const [k, a] of quad.entries()) {
        const b = quad[(k + 1) % 4];
        const key = a < b ? `${a} ${b}` : `${b} ${a}`;
        if (!isFoot(a) || !isFoot(b) || isTaken.has(key)) continue;
        if (side < 0 && cells[a][1] % 20 > 0) continue;
        isTaken.add(key);
        // The same way around the body for all, whichever face comes first.
        const isForward = cross(positions[a], minus(positions[b], positions[a]))[1] > 0;
        const [p, q] = isForward === side > 0 ? [a, b] : [b, a];
        out.faces.push([p, q, tipOf(q)], [p, tipOf(q), tipOf(p)]);
      }
  }
  return out;
}

/**
 * Below a quarter of the surface a second one, a third of a cell deeper and seen from behind. Half
 * of these sheets hang on the surface with their rims.
 */
function withSheets(figure, _random, { positions, faces }) {
  const out = { positions: [...positions], faces: [...faces] };
  const depth = ([x, y, z]) => Math.sin(5 * x) + Math.sin(6 * y + 1) + Math.sin(4 * z) - 0.8;
  const isBelow = (face) => face.every((v) => depth(figure.positions[v]) > 0);
  const isRim = new Set(figure.faces.filter((face) => !isBelow(face)).flat());
  const copies = new Map();
  const copyOf = (v) => {
    if (isRim.has(v) && figure.positions[v][0] > 0) return v;
    if (!copies.has(v))
      copies.set(
        v,
        out.positions.push(moved(positions[v], figure.normals[v], -figure.size / 3)) - 1,
      );
    return copies.get(v);
  };
  for (const face of figure.faces) if (isBelow(face)) out.faces.push(face.map(copyOf).reverse());
  return out;
}

/** One face in thirty twice, every third of these with the other side up. */
function withDuplicates(_figure, random, { positions, faces }) {
  const copies = faces.filter(() => random() < 1 / 30);
  return {
    positions,
    faces: [...faces, ...copies.map((face, i) => (i % 3 === 0 ? [...face].reverse() : [...face]))],
  };
}

/** Loose octahedra, smaller than two cells, around the surface: one for 400 faces. */
function withSpecks(figure, random, { positions, faces }) {
  const out = { positions: [...positions], faces: [...faces] };
  for (let i = 0; i < figure.faces.length / 400; i++) {
    const v = Math.floor(random() * figure.positions.length);
    const middle = moved(figure.positions[v], figure.normals[v], (3 + 4 * random()) * figure.size);
    const radius = (0.1 + 0.9 * random()) * figure.size;
    const first = out.positions.length;
    for (let d = 0; d < 3; d++)
      for (const side of [1, -1])
        out.positions.push(
          middle.map((x, k) => x + (k === d ? side * radius * (0.5 + random()) : 0)),
        );
    for (const [
      i,
      j,
      k,
    ] of [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]) // biome-ignore format: one row
      out.faces.push([first + i, first + j, first + k]);
  }
  return out;
}

const minus = (a, b) => a.map((x, d) => x - b[d]);
const moved = (p, n, by) => p.map((x, d) => x + by * n[d]);
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
