// Inspects an unwrapped OBJ text without the program: its charts, and whether they are fine.

/**
 * Positions, texcoords and faces, [[vertex, texcoord], ...] counted from 0; texcoord is -1 if there
 * is none.
 */
export function parseObj(text) {
  const out = { positions: [], texcoords: [], faces: [] };
  for (const line of text.split(/\r?\n/)) {
    const [key, ...words] = line.trim().split(/\s+/);
    if (key === 'v') out.positions.push(words.slice(0, 3).map(Number));
    if (key === 'vt') out.texcoords.push(words.slice(0, 2).map(Number));
    if (key === 'f')
      out.faces.push(words.map((word) => word.split('/').map((i) => Number(i || 0) - 1)));
  }
  return out;
}

/**
 * Sentences about what is wrong with the texcoords of a text; empty if nothing is. Each chart has
 * to lie in one tile.
 */
export function complaints(text, tiles = 1) {
  const { positions, texcoords, faces } = parseObj(text);
  const found = [];
  for (const [i, uv] of texcoords.entries())
    if (!(tileOf(uv) < tiles)) found.push(`texcoord ${i} is ${uv}`);
  for (const [f, face] of faces.entries()) {
    if (face.some(([, t]) => !(t >= 0 && t < texcoords.length)))
      found.push(`face ${f} has a corner without texcoord`);
    else if (new Set(face.map(([, t]) => tileOf(texcoords[t]))).size > 1)
      found.push(`face ${f} lies in several tiles`);
    else if (areaOf(face.map(([v]) => positions[v])) > 0 && !isPositive(face, texcoords))
      found.push(`face ${f} is turned over or has no area`);
  }
  return found;
}

/**
 * Number of the tile around a point, ten in a row; NaN if there is none. Points on a border belong
 * to either tile.
 */
function tileOf([u, v]) {
  const [column, row] = [u, v].map((x) => Math.max(0, Math.ceil(x) - 1));
  return u >= 0 && u <= 10 && v >= 0 ? 10 * row + column : Number.NaN;
}

/**
 * Chart number per face, and the number of charts. Faces of a chart share both texcoords of an
 * edge.
 */
export function chartsOf({ faces }) {
  const parent = faces.map((_, f) => f);
  const find = (f) => {
    let root = f;
    while (parent[root] !== root) root = parent[root];
    parent[f] = root;
    return root;
  };
  const faceOf = new Map();
  for (const [f, face] of faces.entries())
    for (const [i, [, from]] of face.entries())
      faceOf.set(`${from} ${face[(i + 1) % face.length][1]}`, f);
  for (const [f, face] of faces.entries())
    for (const [i, [, from]] of face.entries()) {
      const other = faceOf.get(`${face[(i + 1) % face.length][1]} ${from}`);
      if (other !== undefined) parent[find(other)] = find(f);
    }
  const numbers = new Map();
  const ofFace = faces.map((_, f) => {
    const root = find(f);
    if (!numbers.has(root)) numbers.set(root, numbers.size);
    return numbers.get(root);
  });
  return { ofFace, count: numbers.size };
}

/** Checks the triangles (0, 1, 2), (0, 2, 3), ... that most programs split a face into. */
function isPositive(face, texcoords) {
  const uv = face.map(([, t]) => texcoords[t]);
  return uv.slice(2).every((c, i) => {
    const [a, b] = [uv[0], uv[i + 1]];
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
  });
}

function areaOf(points) {
  const n = [0, 0, 0];
  for (let i = 2; i < points.length; i++) {
    const [a, b] = [i - 1, i].map((k) => points[k].map((x, d) => x - points[0][d]));
    for (let d = 0; d < 3; d++)
      n[d] += a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3];
  }
  return Math.hypot(...n) / 2;
}
