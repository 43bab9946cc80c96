// Generated surfaces of every kind, as { positions: [[x, y, z]], faces: [[v, ...]] }, and OBJ texts of them.

import { randomNumbers } from './disks.mjs';

export function objText({ positions, faces }, extra = '') {
  const v = positions.map((p) => `v ${p.join(' ')}`);
  const f = faces.map((face) => `f ${face.map((i) => i + 1).join(' ')}`);
  return `${v.join('\n')}\n${extra}${f.join('\n')}\n`;
}

/** A grid of nu x nv quads over [0, 1)^2; `wrap` says per direction whether its ends are joined. */
function parametric(nu, nv, [wrapU, wrapV], point) {
  const columns = wrapU ? nu : nu + 1;
  const rows = wrapV ? nv : nv + 1;
  const positions = [];
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) positions.push(point(i / nu, j / nv));
  const at = (i, j) => (j % rows) * columns + (i % columns);
  const faces = [];
  for (let j = 0; j < nv; j++)
    for (let i = 0; i < nu; i++) {
      const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      faces.push([a, b, c], [a, c, d]);
    }
  return { positions, faces };
}

const TURN = 2 * Math.PI;

export function torus(nu = 32, nv = 16, thickness = 0.4) {
  return parametric(nu, nv, [true, true], (u, v) => {
    const r = 1 + thickness * Math.cos(TURN * v);
    return [r * Math.cos(TURN * u), r * Math.sin(TURN * u), thickness * Math.sin(TURN * v)];
  });
}

/** A tube around a trefoil. */
export function knot(nu = 160, nv = 12) {
  const curve = (t) => [
    Math.sin(t) + 2 * Math.sin(2 * t),
    Math.cos(t) - 2 * Math.cos(2 * t),
    -Math.sin(3 * t),
  ];
  return parametric(nu, nv, [true, true], (u, v) => {
    const [p, q] = [curve(TURN * u), curve(TURN * u + 1e-4)];
    const t = unit(q.map((x, d) => x - p[d]));
    const a = unit(cross(t, [0, 0, 1]));
    const b = cross(t, a);
    const [x, y] = [0.4 * Math.cos(TURN * v), -0.4 * Math.sin(TURN * v)];
    return p.map((c, d) => c + x * a[d] + y * b[d]);
  });
}

export function sphere(n = 16) {
  const { positions, faces } = voxels([[[1]]], n);
  return { positions: positions.map((p) => unit(p.map((x) => x - 0.5))), faces };
}

/** A strip with a half twist. */
export function moebius(n = 48, rows = 4) {
  return twisted(
    parametric(n, rows, [false, false], (u, v) => strip(u, v)),
    n,
    rows,
  );
}

const strip = (u, v) => {
  const w = 0.6 * (v - 0.5);
  const r = 1 + w * Math.cos(Math.PI * u);
  return [r * Math.cos(TURN * u), r * Math.sin(TURN * u), w * Math.sin(Math.PI * u)];
};

/** Joins the last column to the first one upside down. */
function twisted({ positions, faces }, n, rows) {
  const columns = n + 1;
  const own = (v) => (v % columns === n ? (rows - Math.floor(v / columns)) * columns : v);
  return { positions, faces: faces.map((face) => face.map(own)) };
}

/** The Klein bottle as a figure 8 that turns over once: it intersects itself in space. */
export function kleinBottle(nu = 48, nv = 24) {
  const { positions, faces } = parametric(nu, nv, [false, true], (u, v) => {
    const [c, s] = [Math.cos(Math.PI * u), Math.sin(Math.PI * u)];
    const [x, y] = [Math.sin(TURN * v), Math.sin(2 * TURN * v)];
    const r = 2 + c * x - s * y;
    return [r * Math.cos(TURN * u), r * Math.sin(TURN * u), s * x + c * y];
  });
  const columns = nu + 1;
  const own = (v) => (v % columns === nu ? ((nv - Math.floor(v / columns)) % nv) * columns : v);
  return { positions, faces: faces.map((face) => face.map(own)) };
}

/** The outside of solid cells, each side n x n quads: `solid[z][y][x]`. */
export function voxels(solid, n = 2) {
  const positions = [];
  const indexOf = new Map();
  const vertex = (p) => {
    const key = p.join();
    if (!indexOf.has(key)) indexOf.set(key, positions.push(p.map((x) => x / n)) - 1);
    return indexOf.get(key);
  };
  const isSolid = (x, y, z) => Boolean(solid[z]?.[y]?.[x]);
  const faces = [];
  solid.forEach((layer, z) => {
    layer.forEach((row, y) => {
      row.forEach((cell, x) => {
        if (!cell) return;
        for (let axis = 0; axis < 3; axis++)
          for (const side of [0, 1]) {
            const next = [x, y, z];
            next[axis] += 2 * side - 1;
            if (!isSolid(...next)) side_([x, y, z], axis, side);
          }
      });
    });
  });
  return { positions, faces };

  function side_(cell, axis, side) {
    const [a, b] = side === 1 ? [(axis + 1) % 3, (axis + 2) % 3] : [(axis + 2) % 3, (axis + 1) % 3];
    for (let i = 0; i < n; i++)
      for (let j = 0; j < n; j++) {
        const corner = (di, dj) => {
          const p = cell.map((x) => x * n);
          p[axis] += side * n;
          p[a] += i + di;
          p[b] += j + dj;
          return vertex(p);
        };
        faces.push([corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)]);
      }
  }
}

/**
 * Squares, except for those that `isGone`, placed by their fraction of columns and rows; the sides
 * are joined if it is a tube.
 */
export function sheet(columns, rows, place, isGone = () => false, isTube = false) {
  const positions = [];
  const faces = [];
  const numbers = new Map();
  const at = (x, y) => {
    const column = isTube ? x % columns : x;
    const key = `${column} ${y}`;
    if (!numbers.has(key)) {
      numbers.set(key, positions.length);
      positions.push(place(column / columns, y / rows));
    }
    return numbers.get(key);
  };
  for (let y = 0; y < rows; y++)
    for (let x = 0; x < columns; x++) {
      if (isGone(x, y)) continue;
      const [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
      faces.push([a, b, c], [a, c, d]);
    }
  return { positions, faces };
}

/** A flat sheet with a row of `count` windows. */
export function windows(count) {
  const isGone = (x, y) => x % 11 >= 3 && x % 11 < 8 && y >= 5 && y < 10;
  return sheet(11 * count, 15, (u, v) => [11 * count * u, 15 * v, 0], isGone);
}

/**
 * A tube of radius 1, or with the given radius at each height, without the squares that `isGone`.
 */
export function tube(height, radius = () => 1, isGone = undefined) {
  const place = (u, v) => {
    const [a, r] = [2 * Math.PI * u, radius(v)];
    return [r * Math.cos(a), r * Math.sin(a), height * v];
  };
  return sheet(48, 30, place, isGone, true);
}

/** A plate with a row of holes. */
export function plate(holes, n = 2) {
  const width = 2 * holes + 1;
  const row = (y) => Array.from({ length: width }, (_, x) => (y === 1 && x % 2 === 1 ? 0 : 1));
  return voxels([[row(0), row(1), row(2)]], n);
}

export function triangleSoup(count, seed = 1) {
  const next = randomNumbers(seed);
  const positions = Array.from({ length: 3 * count }, () => [next(), next(), next()]);
  return {
    positions,
    faces: Array.from({ length: count }, (_, i) => [3 * i, 3 * i + 1, 3 * i + 2]),
  };
}

/** Several surfaces in one, each moved. */
export function together(parts) {
  const positions = [];
  const faces = [];
  for (const [surface, shift] of parts) {
    const first = positions.length;
    for (const p of surface.positions) positions.push(p.map((x, d) => x + shift[d]));
    for (const face of surface.faces) faces.push(face.map((v) => v + first));
  }
  return { positions, faces };
}

export function boxArray(n) {
  const box = voxels([[[1]]], 1);
  const parts = [];
  for (let y = 0; y < n; y++) for (let x = 0; x < n; x++) parts.push([box, [2 * x, 2 * y, 0]]);
  return together(parts);
}

/** Every corner has its own vertex, as in STL. */
export function unwelded({ positions, faces }) {
  const out = { positions: [], faces: [] };
  for (const face of faces)
    out.faces.push(face.map((v) => out.positions.push([...positions[v]]) - 1));
  return out;
}

/**
 * In every tenth face, a copy of it scaled down to `size` at its middle, with six triangles in
 * between.
 */
export function withTinyTriangles({ positions, faces }, size = 5e-7) {
  const out = { positions: [...positions], faces: [] };
  for (const [f, face] of faces.entries()) {
    if (f % 10 > 0 || face.length !== 3) {
      out.faces.push(face);
      continue;
    }
    const corners = face.map((v) => positions[v]);
    const middle = [0, 1, 2].map((d) => corners.reduce((sum, p) => sum + p[d] / 3, 0));
    const [a, b, c] = face;
    const [p, q, r] = corners.map(
      (x) => out.positions.push(middle.map((m, d) => m + size * (x[d] - m))) - 1,
    );
    out.faces.push([p, q, r], [a, b, q], [a, q, p], [b, c, r], [b, r, q], [c, a, p], [c, p, r]);
  }
  return out;
}

/** Everything that can be wrong with a mesh with finite coordinates, at once. */
export function defects() {
  const body = sphere(6);
  const n = body.positions.length;
  const { positions, faces } = body;
  const [a, b, c, d] = faces[0];
  positions.push([3, 0, 0], [4, 0, 0], [3, 1, 0], [9, 9, 9], [...positions[b]]);
  faces.push(
    [a, b, c, d], // repeats a face
    [d, c, b, a], // and once more from behind
    [a, b, n], // a third face at an edge
    [n, n + 1, n + 2],
    [n + 1, n, n + 2], // two faces back to back
    [n, n + 1, n + 1], // fewer than three vertices
    [a, b, n + 4], // the same by position
  );
  const turned = faces[40];
  faces[40] = [...turned].reverse();
  return body;
}

/** Zero set of a smooth random field over n^3 cells, by marching tetrahedra. */
export function isosurface(n, seed = 3, waves = 12) {
  const next = randomNumbers(seed);
  const terms = Array.from({ length: waves }, () => ({
    k: [0, 1, 2].map(() => Math.round(8 * next() - 4)),
    phase: TURN * next(),
  }));
  const field = (p) =>
    terms.reduce(
      (sum, { k, phase }) =>
        sum + Math.cos(TURN * (k[0] * p[0] + k[1] * p[1] + k[2] * p[2]) + phase),
      0,
    );
  const m = n + 1;
  const value = new Float64Array(m ** 3);
  const at = (x, y, z) => (z * m + y) * m + x;
  for (let z = 0; z < m; z++)
    for (let y = 0; y < m; y++)
      for (let x = 0; x < m; x++) value[at(x, y, z)] = field([x / n, y / n, z / n]);
  const positions = [];
  const faces = [];
  const onEdge = new Map();
  const point = (i, j) => {
    const key = i < j ? i * m ** 3 + j : j * m ** 3 + i;
    const known = onEdge.get(key);
    if (known !== undefined) return known;
    const t = value[i] / (value[i] - value[j]);
    const p = [0, 1, 2].map((d) => {
      const [a, b] = [i, j].map((v) => Math.floor(v / m ** d) % m);
      return (a + t * (b - a)) / n;
    });
    onEdge.set(key, positions.length);
    return positions.push(p) - 1;
  };
  const triangle = (inside, corners) => {
    const [a, b, c] = corners;
    if (a === b || b === c || c === a) return;
    const [p, q, r] = corners.map((v) => positions[v]);
    const normal = cross(sub(q, p), sub(r, p));
    const s = [0, 1, 2].map((d) => (Math.floor(inside / m ** d) % m) / n);
    // The inside is below zero, behind the surface.
    faces.push(dot(normal, sub(s, p)) < 0 ? [a, b, c] : [a, c, b]);
  };
  const TETRAHEDRA = [
    [0, 1, 3, 7],
    [0, 3, 2, 7],
    [0, 2, 6, 7],
    [0, 6, 4, 7],
    [0, 4, 5, 7],
    [0, 5, 1, 7],
  ];
  for (let z = 0; z < n; z++)
    for (let y = 0; y < n; y++)
      for (let x = 0; x < n; x++) {
        const corner = (c) => at(x + (c & 1), y + ((c >> 1) & 1), z + (c >> 2));
        for (const tetrahedron of TETRAHEDRA) {
          const all = tetrahedron.map(corner);
          const low = all.filter((v) => value[v] < 0);
          const high = all.filter((v) => value[v] >= 0);
          if (low.length === 1)
            triangle(
              low[0],
              high.map((h) => point(low[0], h)),
            );
          if (low.length === 3)
            triangle(
              low[0],
              low.map((l) => point(l, high[0])),
            );
          if (low.length !== 2) continue;
          const [[a, b], [c, d]] = [low, high];
          const quad = [point(a, c), point(a, d), point(b, d), point(b, c)];
          triangle(a, [quad[0], quad[1], quad[2]]);
          triangle(a, [quad[0], quad[2], quad[3]]);
        }
      }
  return { positions, faces };
}

const sub = (a, b) => a.map((x, d) => x - b[d]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const unit = (a) => {
  const length = Math.sqrt(dot(a, a));
  return a.map((x) => x / length);
};
