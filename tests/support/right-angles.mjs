// Random meshes of right angles, as blocks, levels and furniture have them: { positions, faces }.
// Many of their boundary vertices have a surface angle of exactly 2 pi, so that a flat layout
// touches itself.

export const whole = (random, least, most) => least + random.below(most - least + 1);

export function shuffled(random, list) {
  const out = [...list];
  for (let i = out.length - 1; i > 0; i--) {
    const k = random.below(i + 1);
    [out[i], out[k]] = [out[k], out[i]];
  }
  return out;
}

/** Collects quads whose corners are found by their place. */
class Blocks {
  #numbers = new Map();
  positions = [];
  faces = [];

  #vertex(p) {
    const key = p.join();
    if (!this.#numbers.has(key)) {
      this.#numbers.set(key, this.positions.length);
      this.positions.push(p);
    }
    return this.#numbers.get(key);
  }

  quad(...corners) {
    this.faces.push(corners.map((p) => this.#vertex(p)));
  }

  mesh() {
    return { positions: this.positions, faces: this.faces };
  }
}

/** Increasing coordinates of grid lines, regular or not. */
function gridLines(random, count) {
  const isRegular = random.chance(0.5);
  const out = [0];
  for (let i = 0; i < count; i++) out.push(out[i] + (isRegular ? 1 : random.between(0.2, 3)));
  return out;
}

const SIDES = [0, 1, 2].flatMap((axis) => [
  { axis, step: 1 },
  { axis, step: -1 },
]);

/** The faces between full and empty cells. `isFull(cell)` gets three whole numbers. */
function surfaceOfCells(size, lines, isFull, keep = () => true) {
  const blocks = new Blocks();
  const at = (cell) => cell.map((i, d) => lines[d][i]);
  const isInside = (cell) => cell.every((i, d) => i >= 0 && i < size[d]);
  for (let x = 0; x < size[0]; x++)
    for (let y = 0; y < size[1]; y++)
      for (let z = 0; z < size[2]; z++) {
        const cell = [x, y, z];
        if (!isFull(cell)) continue;
        for (const { axis, step } of SIDES) {
          const next = cell.map((i, d) => (d === axis ? i + step : i));
          if ((isInside(next) && isFull(next)) || !keep()) continue;
          const corner = (u, v) => {
            const p = [...cell];
            p[axis] += step > 0 ? 1 : 0;
            p[(axis + 1) % 3] += u;
            p[(axis + 2) % 3] += v;
            return at(p);
          };
          const loop = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
          blocks.quad(...(step > 0 ? loop : loop.reverse()));
        }
      }
  return blocks.mesh();
}

/** A few blocks grown from one, with some faces missing or none. */
function voxels(random) {
  const size = [whole(random, 1, 5), whole(random, 1, 5), whole(random, 1, 5)];
  const lines = size.map((n) => gridLines(random, n));
  const full = new Set([size.map((n) => whole(random, 0, n - 1)).join()]);
  for (let i = whole(random, 0, 25); i > 0; i--) {
    const from = random
      .pick([...full])
      .split(',')
      .map(Number);
    const { axis, step } = random.pick(SIDES);
    from[axis] += step;
    if (from[axis] >= 0 && from[axis] < size[axis]) full.add(from.join());
  }
  const missing = random.pick([0, 0, 0.1, 0.4]);
  return surfaceOfCells(
    size,
    lines,
    (cell) => full.has(cell.join()),
    () => !random.chance(missing),
  );
}

/** A heightfield of blocks: a maze of walls, stairs or towers, with or without its floor. */
function maze(random) {
  const size = [whole(random, 2, 8), whole(random, 2, 8), whole(random, 1, 4)];
  const lines = size.map((n) => gridLines(random, n));
  const heights = Array.from({ length: size[0] * size[1] }, () => whole(random, 0, size[2]));
  return surfaceOfCells(size, lines, ([x, y, z]) => z < heights[x * size[1] + y]);
}

/** Floor and walls seen from inside, open at the top, with windows. */
function room(random) {
  const size = [whole(random, 1, 6), whole(random, 1, 6), whole(random, 1, 3)];
  const lines = size.map((n) => gridLines(random, n));
  const blocks = new Blocks();
  const point = (x, y, z) => [lines[0][x], lines[1][y], lines[2][z]];
  const [w, d, h] = size;
  const missing = random.pick([0, 0.1, 0.3]);
  const tile = (...corners) => random.chance(missing) || blocks.quad(...corners);
  for (let x = 0; x < w; x++)
    for (let y = 0; y < d; y++)
      tile(point(x, y, 0), point(x + 1, y, 0), point(x + 1, y + 1, 0), point(x, y + 1, 0));
  const walls = whole(random, 1, 4);
  for (let z = 0; z < h; z++) {
    for (let x = 0; x < w; x++) {
      const [a, b] = [point(x, d, z), point(x + 1, d, z)];
      tile(a, b, point(x + 1, d, z + 1), point(x, d, z + 1));
      const [e, f] = [point(x + 1, 0, z), point(x, 0, z)];
      if (walls > 2) tile(e, f, point(x, 0, z + 1), point(x + 1, 0, z + 1));
    }
    for (let y = 0; y < d; y++) {
      const [a, b] = [point(0, y, z), point(0, y + 1, z)];
      if (walls > 1) tile(a, b, point(0, y + 1, z + 1), point(0, y, z + 1));
      const [e, f] = [point(w, y + 1, z), point(w, y, z)];
      if (walls > 3) tile(e, f, point(w, y, z + 1), point(w, y + 1, z + 1));
    }
  }
  if (blocks.faces.length === 0) return room(random);
  return blocks.mesh();
}

/** Steps with treads, risers and maybe cheeks of one quad each. */
function stairs(random) {
  const blocks = new Blocks();
  const [width, tread, rise] = [1, 2, 3].map(() => random.between(0.2, 3));
  const isOpen = random.chance(0.5);
  for (let i = whole(random, 1, 12); i > 0; i--) {
    const [x0, x1, z0, z1] = [(i - 1) * tread, i * tread, (i - 1) * rise, i * rise];
    blocks.quad([x0, 0, z0], [x0, width, z0], [x0, width, z1], [x0, 0, z1]);
    blocks.quad([x0, 0, z1], [x0, width, z1], [x1, width, z1], [x1, 0, z1]);
    if (isOpen) continue;
    blocks.quad([x0, 0, 0], [x0, 0, z1], [x1, 0, z1], [x1, 0, 0]);
    blocks.quad([x0, width, 0], [x1, width, 0], [x1, width, z1], [x0, width, z1]);
  }
  return blocks.mesh();
}

/** A plate with square holes, as vents, windows and fences are. */
function grille(random) {
  const size = [2 * whole(random, 1, 4) + 1, 2 * whole(random, 1, 4) + 1, 1];
  const lines = size.map((n) => gridLines(random, n));
  lines[2] = [0, random.between(0.05, 1)];
  return surfaceOfCells(size, lines, ([x, y]) => x % 2 === 0 || y % 2 === 0);
}

export const RIGHT_ANGLED = { voxels, maze, room, stairs, grille };

/** Numbers vertices at random and turns and scales the mesh, if that is asked for. */
export function disguised(random, { positions, faces }) {
  const order = shuffled(
    random,
    positions.map((_, i) => i),
  );
  const place = new Map(order.map((old, now) => [old, now]));
  const [a, b] = [random.between(0, 7), random.between(0, 7)];
  const size = random.pick([1, 0.001, 40]);
  const turn = ([x, y, z]) => {
    const [u, v] = [x * Math.cos(a) - y * Math.sin(a), x * Math.sin(a) + y * Math.cos(a)];
    return [u, v * Math.cos(b) - z * Math.sin(b), v * Math.sin(b) + z * Math.cos(b)];
  };
  const moved = random.chance(0.5) ? (p) => turn(p).map((x) => size * x) : (p) => p;
  return {
    positions: order.map((old) => moved(positions[old])),
    faces: shuffled(
      random,
      faces.map((face) => face.map((v) => place.get(v))),
    ),
  };
}
