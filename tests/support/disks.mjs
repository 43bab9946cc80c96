// Generated topological disks, from harmless to hostile, each fully determined by its number.

/** Small deterministic generator (mulberry32), uniform in [0, 1). */
export function randomNumbers(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** Two triangles per square over a grid of (columns + 1) x (rows + 1) vertices; `place(i, j)` gives xyz. */
function grid(columns, rows, place) {
  const positions = [];
  const faces = [];
  for (let j = 0; j <= rows; j++) for (let i = 0; i <= columns; i++) positions.push(place(i, j));
  const at = (i, j) => j * (columns + 1) + i;
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) {
      faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
      faces.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  return { positions, faces };
}

function heightField(random, size) {
  const columns = Math.max(1, Math.round(Math.sqrt(size / 2)));
  const waves = Array.from({ length: 6 }, () => [
    (random() - 0.5) * 12,
    (random() - 0.5) * 12,
    random() * 6.3,
    (random() - 0.5) * 0.5,
  ]);
  const noise = random() < 0.3 ? 0.3 * random() : 0;
  return grid(columns, columns, (i, j) => {
    const x = i / columns;
    const y = j / columns;
    const z = waves.reduce((sum, [a, b, c, h]) => sum + h * Math.sin(a * x + b * y + c), 0);
    return [x, y, z + (noise * (random() - 0.5)) / columns];
  });
}

function spiral(random, size) {
  const rows = 1 + Math.floor(random() * 4);
  const columns = Math.max(3, Math.round(size / (2 * rows)));
  const turns = 0.5 + 4 * random();
  const width = 0.2 + 0.75 * random();
  const rise = random() < 0.5 ? 0 : random();
  return grid(columns, rows, (i, j) => {
    const angle = (2 * Math.PI * turns * i) / columns;
    const radius = 1 + angle / (2 * Math.PI) + (width * (rows - j)) / rows;
    const bump = 0.1 * (random() - 0.5);
    return [radius * Math.cos(angle), radius * Math.sin(angle), rise * angle + bump];
  });
}

function comb(random, size) {
  const teeth = 2 + Math.floor(random() * 12);
  const length = Math.max(1, Math.round(size / (4 * teeth)));
  const bend = 3 * (random() - 0.5);
  const noise = 0.4 * random();
  const vertex = new Map();
  const positions = [];
  const faces = [];
  const at = (i, j) => {
    const key = `${i},${j}`;
    if (!vertex.has(key)) {
      vertex.set(key, positions.length);
      const phase = (bend * j) / Math.max(4, length);
      positions.push([
        i + 0.5 * Math.sin(phase * 3 + i),
        4 * Math.sin(phase),
        j * Math.cos(phase * 0.5) + noise * (random() - 0.5),
      ]);
    }
    return vertex.get(key);
  };
  const square = (i, j) => {
    faces.push(
      [at(i, j), at(i + 1, j), at(i + 1, j + 1)],
      [at(i, j), at(i + 1, j + 1), at(i, j + 1)],
    );
  };
  for (let i = 0; i < 2 * teeth - 1; i++) square(i, 0);
  for (let i = 0; i < 2 * teeth - 1; i += 2) for (let j = 1; j <= length; j++) square(i, j);
  return { positions, faces };
}

/** Closed sphere-like surface: an octahedron subdivided to about `size` faces and bumped. */
function closedSphere(random, size) {
  const positions = [
    [1, 0, 0],
    [-1, 0, 0],
    [0, 1, 0],
    [0, -1, 0],
    [0, 0, 1],
    [0, 0, -1],
  ];
  let faces = [
    [0, 2, 4],
    [2, 1, 4],
    [1, 3, 4],
    [3, 0, 4],
    [2, 0, 5],
    [1, 2, 5],
    [3, 1, 5],
    [0, 3, 5],
  ];
  while (faces.length * 4 <= Math.max(size, 32)) {
    const middle = new Map();
    const half = (a, b) => {
      const key = a < b ? a * 1e7 + b : b * 1e7 + a;
      if (!middle.has(key)) {
        middle.set(key, positions.length);
        const p = positions[a].map((x, d) => x + positions[b][d]);
        const length = Math.hypot(...p);
        positions.push(p.map((x) => x / length));
      }
      return middle.get(key);
    };
    faces = faces.flatMap(([a, b, c]) => {
      const [ab, bc, ca] = [half(a, b), half(b, c), half(c, a)];
      return [
        [a, ab, ca],
        [ab, b, bc],
        [ca, bc, c],
        [ab, bc, ca],
      ];
    });
  }
  const waves = Array.from({ length: 5 }, () => [
    random() * 8 - 4,
    random() * 8 - 4,
    random() * 8 - 4,
    random() * 0.25,
  ]);
  for (const p of positions) {
    const r = waves.reduce(
      (sum, [a, b, c, h]) => sum + h * Math.sin(a * p[0] + b * p[1] + c * p[2]),
      1,
    );
    for (let d = 0; d < 3; d++) p[d] *= r;
  }
  return { positions, faces };
}

function sphereWithHole(random, size) {
  const mesh = closedSphere(random, size);
  mesh.faces.splice(Math.floor(random() * mesh.faces.length), 1);
  return mesh;
}

/**
 * Cuts a mesh open along edges: corners that can be reached around a vertex without crossing a cut
 * share a vertex.
 */
export function cutOpen({ positions, faces }, isCut) {
  const edge = new Map();
  for (const [i, [a, b, c]] of faces.entries()) {
    edge.set(`${a},${b}`, 3 * i);
    edge.set(`${b},${c}`, 3 * i + 1);
    edge.set(`${c},${a}`, 3 * i + 2);
  }
  const twin = (h) => {
    const f = faces[Math.floor(h / 3)];
    const a = f[h % 3];
    const b = f[(h + 1) % 3];
    return isCut(a, b) ? undefined : edge.get(`${b},${a}`);
  };
  const parent = faces.flatMap((_, i) => [3 * i, 3 * i + 1, 3 * i + 2]);
  const find = (c) => {
    while (parent[c] !== c) c = parent[c] = parent[parent[c]];
    return c;
  };
  const next = (h) => (h % 3 === 2 ? h - 2 : h + 1);
  for (let h = 0; h < parent.length; h++) {
    const t = twin(h);
    if (t === undefined) continue;
    parent[find(h)] = find(next(t));
    parent[find(next(h))] = find(t);
  }
  const number = new Map();
  const out = { positions: [], faces: [] };
  for (const [i, f] of faces.entries()) {
    const corners = f.map((v, k) => {
      const root = find(3 * i + k);
      if (!number.has(root)) {
        number.set(root, out.positions.length);
        out.positions.push(positions[v]);
      }
      return number.get(root);
    });
    out.faces.push(corners);
  }
  return out;
}

function sphereCutAlongTree(random, size) {
  const mesh = closedSphere(random, size);
  const neighbours = mesh.positions.map(() => new Set());
  for (const [a, b, c] of mesh.faces) {
    neighbours[a].add(b);
    neighbours[b].add(c);
    neighbours[c].add(a);
  }
  const edges = Math.max(4, Math.floor((0.02 + 0.3 * random() ** 2) * mesh.positions.length));
  const inTree = [Math.floor(random() * mesh.positions.length)];
  const seen = new Set(inTree);
  const cut = new Set();
  for (let tries = 0; cut.size < edges && tries < 100 * edges; tries++) {
    // Mostly grow at the tip, so that the cuts are long and branched.
    const from =
      random() < 0.8 ? inTree[inTree.length - 1] : inTree[Math.floor(random() * inTree.length)];
    const free = [...neighbours[from]].filter((v) => !seen.has(v));
    if (free.length === 0) {
      inTree.push(inTree[Math.floor(random() * inTree.length)]);
      continue;
    }
    const to = free[Math.floor(random() * free.length)];
    seen.add(to);
    inTree.push(to);
    cut.add(`${from},${to}`).add(`${to},${from}`);
  }
  return cutOpen(mesh, (a, b) => cut.has(`${a},${b}`));
}

function needles(random, size) {
  const columns = Math.max(2, Math.round(Math.sqrt(size / 2)));
  const aspect = 10 ** (1 + 3 * random());
  const height = 0.3 * random();
  return grid(columns, columns, (i, j) => [
    i / aspect,
    j + 0.3 * random(),
    height * Math.sin(3 * j) + (0.3 * (random() - 0.5)) / aspect,
  ]);
}

function valenceThree(random, size) {
  const mesh = {
    positions: [
      [0, 0, 0],
      [1, 0, 0.2],
      [1, 1, 0],
      [0, 1, 0.3],
    ],
    faces: [
      [0, 1, 2],
      [0, 2, 3],
    ],
  };
  while (mesh.faces.length + 2 <= size) {
    const i = Math.floor(random() * mesh.faces.length);
    const [a, b, c] = mesh.faces[i];
    const w = [0.2 + random(), 0.2 + random(), 0.2 + random()];
    const total = w[0] + w[1] + w[2];
    const p = [0, 1, 2].map(
      (d) =>
        (w[0] * mesh.positions[a][d] + w[1] * mesh.positions[b][d] + w[2] * mesh.positions[c][d]) /
        total,
    );
    const side = Math.hypot(...[0, 1, 2].map((d) => mesh.positions[a][d] - mesh.positions[b][d]));
    p[2] += 0.15 * side * (random() - 0.5);
    const v = mesh.positions.push(p) - 1;
    mesh.faces[i] = [a, b, v];
    mesh.faces.push([b, c, v], [c, a, v]);
    if (mesh.faces.length > 400) break;
  }
  return mesh;
}

function hubs(random, size) {
  const count = Math.max(1, Math.min(8, Math.floor(size / 80)));
  const valence = 40;
  const positions = [];
  const faces = [];
  // A row of cones of 40 triangles, each joined to the next by a quad.
  for (let h = 0; h < count; h++) {
    const hub = positions.push([3 * h, 0, 1.5 * (random() - 0.3)]) - 1;
    for (let k = 0; k < valence; k++) {
      const angle = (2 * Math.PI * (k + 0.5)) / valence;
      positions.push([3 * h + Math.cos(angle), Math.sin(angle), 0.1 * random()]);
    }
    for (let k = 0; k < valence; k++) faces.push([hub, hub + 1 + k, hub + 1 + ((k + 1) % valence)]);
    if (h === 0) continue;
    const left = hub - valence - 1;
    const [a, b] = [left + valence, left + 1]; // right side of previous cone, below and above axis
    const [c, d] = [hub + 1 + valence / 2 - 1, hub + 1 + valence / 2];
    faces.push([a, d, c], [a, c, b]);
  }
  return { positions, faces };
}

const FAMILIES = {
  heightField,
  spiral,
  comb,
  sphereWithHole,
  sphereCutAlongTree,
  needles,
  valenceThree,
  hubs,
};

/** Disk number n: its family cycles with n, and its size varies from 3 to `maxFaces` faces. */
export function generatedDisk(n, maxFaces = 20000) {
  const names = Object.keys(FAMILIES);
  const family = names[n % names.length];
  const random = randomNumbers(n + 1);
  const size = Math.max(3, Math.round(Math.exp(Math.log(3) + random() * Math.log(maxFaces / 3))));
  return { name: `${family}-${n}`, ...FAMILIES[family](random, size) };
}

export function toObj({ positions, faces }) {
  const lines = positions.map((p) => `v ${p.join(' ')}`);
  for (const f of faces) lines.push(`f ${f.map((v) => v + 1).join(' ')}`);
  return `${lines.join('\n')}\n`;
}
