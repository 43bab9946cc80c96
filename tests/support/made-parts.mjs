// Random parts as CAD programs, level editors and scanners write them, with the slivers that these
// leave: { positions, faces }.

import { whole } from './right-angles.mjs';

class Builder {
  positions = [];
  faces = [];

  vertex(...p) {
    return this.positions.push(p) - 1;
  }
  face(...corners) {
    this.faces.push(corners);
  }
  mesh() {
    return { positions: this.positions, faces: this.faces };
  }
}

const circle = (n, r, x, y) =>
  Array.from({ length: n }, (_, i) => {
    const angle = (2 * Math.PI * i) / n;
    return [x + r * Math.cos(angle), y + r * Math.sin(angle)];
  });

/**
 * A plate with round holes, drilled through: each cell of a grid has a hole, and its two flat sides
 * are fans from the corners of the cell. T-junctions between cells are closed by slivers.
 */
function drilled(random) {
  const out = new Builder();
  const [columns, rows] = [whole(random, 1, 4), whole(random, 1, 4)];
  const n = 4 * whole(random, 1, 8);
  const thickness = random.between(0.05, 1);
  const gap = random.pick([0, 1e-7, 3e-6]);
  for (let x = 0; x < columns; x++)
    for (let y = 0; y < rows; y++) {
      const square = [
        [x, y],
        [x + 1, y],
        [x + 1, y + 1],
        [x, y + 1],
      ];
      const hole = circle(n, random.between(0.1, 0.45), x + 0.5, y + 0.5);
      const rims = [0, thickness].map((z) => hole.map(([u, v]) => out.vertex(u, v, z)));
      const ends = [0, thickness].map((z) => square.map(([u, v]) => out.vertex(u, v, z)));
      const flat = (side, ...corners) => out.face(...(side === 1 ? corners : corners.toReversed()));
      for (const side of [0, 1]) {
        for (let i = 0; i < n; i++) {
          const corner = ends[side][(2 + Math.floor((4 * i) / n)) % 4];
          flat(side, rims[side][i], corner, rims[side][(i + 1) % n]);
        }
        // From one corner of the square to the next, at the hole's point between them.
        for (let k = 0; k < 4; k++) {
          const at = rims[side][(k * n) / 4];
          flat(side, at, ends[side][(k + 1) % 4], ends[side][(k + 2) % 4]);
        }
      }
      for (let i = 0; i < n; i++) {
        const j = (i + 1) % n;
        out.face(rims[0][i], rims[1][i], rims[1][j], rims[0][j]);
      }
      if (gap === 0) continue;
      // A vertex in the middle of an edge, a hair off it, as T-junctions are closed.
      const middle = out.vertex(x + 0.5, y + gap, thickness);
      out.face(ends[1][0], ends[1][1], middle);
    }
  return out.mesh();
}

/** A turned part: rings of different radius, the ends closed by fans or single polygons. */
function turned(random) {
  const out = new Builder();
  const n = whole(random, 3, 40);
  const isPointed = random.chance(0.4);
  let z = 0;
  const rings = Array.from({ length: whole(random, 2, 7) }, () => {
    z += random.pick([0, random.between(0.05, 1), random.between(1e-6, 1e-4)]);
    const r = random.between(0.2, 1);
    return circle(n, r, 0, 0).map(([x, y]) => out.vertex(x, y, z));
  });
  for (let k = 1; k < rings.length; k++)
    for (let i = 0; i < n; i++) {
      const j = (i + 1) % n;
      out.face(rings[k - 1][i], rings[k - 1][j], rings[k][j], rings[k][i]);
    }
  const cap = (ring, height) => {
    if (!isPointed) {
      out.face(...ring);
      return;
    }
    const tip = out.vertex(0, 0, height);
    for (const [i, v] of ring.entries()) out.face(v, ring[(i + 1) % n], tip);
  };
  cap(rings[0].toReversed(), random.between(-1, 0));
  cap(rings.at(-1), z + random.between(0, 1));
  return out.mesh();
}

/** Almost flat window frames, one corner a butt joint, beside a floor that sets the scale. */
function frames(random) {
  const out = new Builder();
  const noise = random.pick([0, 1e-6, 1e-4, 1e-3]);
  const count = whole(random, 1, 12);
  for (let i = 0; i < count; i++) {
    const [x0, size, lean] = [2 * i, random.between(0.02, 1), random.between(-0.4, 0.4)];
    const [h, t] = [random.between(0.5, 1.5), random.between(0.08, 0.2)];
    const seen = new Map();
    const at = (x, y) => {
      if (!seen.has(`${x} ${y}`)) {
        const z = size * random.between(-noise, noise);
        seen.set(`${x} ${y}`, out.vertex(x0 + size * (x + lean * y), size * y, z));
      }
      return seen.get(`${x} ${y}`);
    };
    const isButt = random.chance(0.5);
    out.face(at(0, 0), at(1, 0), at(1 - t, t), at(t, t));
    out.face(at(1, 0), at(1, h), at(1 - t, h - t), at(1 - t, t));
    out.face(at(1, h), isButt ? at(t, h) : at(0, h), at(t, h - t), at(1 - t, h - t));
    if (isButt) out.face(at(0, h + t), at(0, 0), at(t, t), at(t, h + t));
    else out.face(at(0, h), at(0, 0), at(t, t), at(t, h - t));
  }
  const floor = random.pick([1, 40]);
  const corner = (x, y) => out.vertex(x, y, -9);
  out.face(corner(0, 0), corner(floor, 0), corner(floor, floor), corner(0, floor));
  return out.mesh();
}

/** A wavy, noisy sheet or tube with holes and loose specks. */
function scan(random) {
  const out = new Builder();
  const [columns, rows] = [whole(random, 3, 24), whole(random, 3, 24)];
  const isTube = random.chance(0.4);
  const [wave, noise] = [random.between(0, 0.4), random.pick([0, 0.01, 0.05])];
  const grid = Array.from({ length: columns + 1 }, (_, i) =>
    Array.from({ length: rows + 1 }, (_, j) => {
      const [u, v] = [i / columns, j / rows];
      const height = wave * Math.sin(7 * u) * Math.cos(5 * v) + noise * random.between(-1, 1);
      if (!isTube) return out.vertex(u, v, height);
      const angle = 2 * Math.PI * (i % columns) * (1 / columns);
      const r = 0.3 + 0.3 * height;
      return i === columns ? -1 : out.vertex(r * Math.cos(angle), r * Math.sin(angle), v);
    }),
  );
  if (isTube) grid[columns] = grid[0];
  const missing = random.pick([0, 0.03, 0.15]);
  for (let i = 0; i < columns; i++)
    for (let j = 0; j < rows; j++) {
      const [a, b, c, d] = [grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]];
      if (!random.chance(missing)) out.face(a, b, c);
      if (!random.chance(missing)) out.face(a, c, d);
    }
  for (let k = random.pick([0, 5]); k > 0; k--) {
    const p = [0, 1, 2].map(() => random.between(-0.2, 1.2));
    const speck = () => out.vertex(...p.map((x) => x + random.between(0, 0.01)));
    out.face(speck(), speck(), speck());
  }
  return out.faces.length > 0 ? out.mesh() : scan(random);
}

export const PARTS = { drilled, turned, frames, scan };
