// Surfaces that nobody would model, from a seed: soups, checkerboards, polygons that touch
// themselves, edges with many faces, surfaces that are flat, doubled, flipped or empty. As {
// positions, faces, texcoords, materials }, where texcoords are per face corner or missing, and as
// OBJ texts.

import { randomNumbers } from './disks.mjs';
import * as surfaces from './surfaces.mjs';

export class Random {
  constructor(seed) {
    this.next = randomNumbers(seed + 1);
  }
  /** An integer below n. */
  below(n) {
    return Math.floor(this.next() * n);
  }
  between(low, high) {
    return low + (high - low) * this.next();
  }
  chance(share) {
    return this.next() < share;
  }
  pick(list) {
    return list[this.below(list.length)];
  }
}

function bumpy(random) {
  const height = random.pick([0.05, 0.2, 0.6]);
  return (u, v) => [u, v, height * random.next()];
}

const KINDS = {
  soup: (random) => surfaces.triangleSoup(1 + random.below(40), random.below(1e6)),

  /** Arbitrary corners: edges with many faces, faces that repeat others or use a vertex twice. */
  tangle(random) {
    const n = 3 + random.below(12);
    const positions = Array.from({ length: n }, () => [0, 1, 2].map(() => random.next()));
    const face = () => Array.from({ length: 3 + random.below(5) }, () => random.below(n));
    return { positions, faces: Array.from({ length: 1 + random.below(25) }, face) };
  },

  checkerboard(random) {
    const [columns, rows] = [3 + random.below(8), 2 + random.below(8)];
    const isEven = random.chance(0.5);
    const isGone = (x, y) => (isEven ? (x + y) % 2 === 0 : random.chance(0.3));
    const isInside = (x, y) => x > 0 && x + 1 < columns && y > 0 && y + 1 < rows;
    const place = bumpy(random);
    const isTube = random.chance(0.3);
    return surfaces.sheet(columns, rows, place, (x, y) => isInside(x, y) && isGone(x, y), isTube);
  },

  /** Single triangles of a closed or an open surface are missing. */
  motheaten(random) {
    const whole = KINDS.closed(random);
    return { ...whole, faces: whole.faces.filter(() => random.chance(0.85)) };
  },

  closed: (random) =>
    random.pick([
      () => surfaces.torus(5 + random.below(10), 4 + random.below(6)),
      () => surfaces.sphere(1 + random.below(4)),
      () => surfaces.moebius(9 + random.below(20), 1 + random.below(3)),
      () => surfaces.kleinBottle(10, 6),
      () => surfaces.plate(1 + random.below(3)),
    ])(),

  /** Solid cells, which touch along edges and corners. */
  cells(random) {
    const row = () => [0, 1, 2].map(() => (random.chance(0.4) ? 1 : 0));
    const layer = () => [row(), row(), row()];
    return surfaces.voxels([layer(), layer(), [[1], ...layer()]], 1 + random.below(2));
  },

  /** Faces of a grid of so many cells as one polygon each, and one with a hole in it. */
  polygons(random) {
    const n = 2 + random.below(5);
    const positions = [];
    for (let k = 0; k <= n; k++)
      for (const y of [0, 1, 2]) positions.push([k, y, random.chance(0.1) ? random.next() : 0]);
    const strip = (y) => [...Array(n + 1).keys()].map((k) => 3 * k + y);
    const faces = [
      [...strip(0), ...strip(1).reverse()],
      [...strip(1), ...strip(2).reverse()],
    ];
    const first = positions.length;
    positions.push([0, 0, 1], [4, 0, 1], [4, 4, 1], [0, 4, 1], [1, 1, 1], [1, 3, 1], [3, 3, 1]);
    faces.push([0, 1, 2, 3, 0, 4, 5, 6, 4].map((v) => v + first));
    return { positions, faces };
  },

  fan(random) {
    const n = 3 + random.below(20);
    const positions = [[0, 0, random.between(-1, 2)]];
    for (let i = 0; i < n; i++)
      positions.push([Math.cos((6.28 * i) / n), Math.sin((6.28 * i) / n), 0.3 * random.next()]);
    const faces = Array.from({ length: n }, (_, i) => [0, 1 + i, 1 + ((i + 1) % n)]);
    return { positions, faces: random.chance(0.5) ? faces : faces.slice(1) };
  },

  sheet: (random) =>
    surfaces.sheet(1 + random.below(9), 1 + random.below(9), (u, v) => [
      u,
      v,
      random.between(0, 0.1),
    ]),
};

/** What happens to surfaces on their way through programs. */
const ACCIDENTS = {
  unwelded: (_, s) => surfaces.unwelded(s),
  shaken: (random, s) => moved(s, (x) => x + 1e-9 * random.next()),
  snapped: (_, s) => moved(s, (x) => Math.round(2 * x) / 2),
  flat: (_, s) => ({ ...s, positions: s.positions.map(([x, y]) => [x, y, 0]) }),
  line: (_, s) => ({ ...s, positions: s.positions.map(([x]) => [x, 2 * x, 0]) }),
  point: (_, s) => moved(s, () => 1),
  huge: (random, s) => moved(s, (x) => x * 10 ** random.between(-30, 30)),
  far: (_, s) => moved(s, (x) => x + 1e6),
  doubled: (random, s) => ({
    ...s,
    faces: [...s.faces, ...s.faces.filter(() => random.chance(0.2))],
  }),
  turned: (random, s) => ({
    ...s,
    faces: s.faces.map((f) => (random.chance(0.2) ? [...f].reverse() : f)),
  }),
  stray: (random, s) => ({
    ...s,
    positions: [...s.positions, [1e9, 0, 0], [random.next(), random.next(), random.next()]],
  }),
};

const moved = (s, move) => ({ ...s, positions: s.positions.map((p) => p.map(move)) });

/** Texcoords of each corner: the vertex seen from above, a separate place per corner, or noise. */
function texcoordsOf(random, { positions, faces }) {
  const kind = random.below(4);
  const above = ([x, y]) => [0.1 + 0.05 * Math.abs(x % 16), 0.1 + 0.05 * Math.abs(y % 16)];
  if (kind === 0) return undefined;
  return faces.map((face) => {
    if (kind === 3 && random.chance(0.5)) return undefined;
    return face.map((v) => (kind === 1 ? [random.next(), random.next()] : above(positions[v])));
  });
}

export const SURFACE_KINDS = Object.keys(KINDS);

/** The surface for a seed; small, so that thousands of runs take minutes. */
export function randomSurface(random, kind = random.pick(SURFACE_KINDS)) {
  let surface = KINDS[kind](random);
  for (let i = random.below(3); i > 0; i--)
    surface = ACCIDENTS[random.pick(Object.keys(ACCIDENTS))](random, surface);
  const materials = random.chance(0.5) ? surface.faces.map(() => random.below(3)) : undefined;
  return { ...surface, texcoords: texcoordsOf(random, surface), materials };
}

export function surfaceText({ positions, faces, texcoords, materials }) {
  const lines = positions.map((p) => `v ${p.join(' ')}`);
  let count = 0;
  for (const [f, face] of faces.entries()) {
    const uv = texcoords?.[f];
    if (materials) lines.push(`usemtl m${materials[f]}`);
    for (const place of uv ?? []) lines.push(`vt ${place.join(' ')}`);
    lines.push(`f ${face.map((v) => (uv ? `${v + 1}/${++count}` : v + 1)).join(' ')}`);
  }
  return `${lines.join('\n')}\n`;
}
