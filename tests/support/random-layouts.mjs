// Small layouts from a seed, valid ones and ones damaged in a known way, as { positions, texcoords,
// faces } with triangles of [vertex, texcoord] and as OBJ texts.

import { Random } from './random-surfaces.mjs';

const CELLS = 3;

/** A grid of triangles, jittered but flat, in the middle of a cell of the unit square. */
function island(random, column, row) {
  const [across, up] = [1 + random.below(5), 1 + random.below(5)];
  const turn = random.between(0, 2 * Math.PI);
  const size = random.between(0.3, 0.5) / CELLS;
  const jitter = () => random.between(-0.2, 0.2);
  const points = [];
  for (let j = 0; j <= up; j++)
    for (let i = 0; i <= across; i++) {
      const [x, y] = [(i + jitter()) / across - 0.5, (j + jitter()) / up - 0.5];
      const [c, s] = [Math.cos(turn) * size, Math.sin(turn) * size];
      points.push([(column + 0.5) / CELLS + c * x - s * y, (row + 0.5) / CELLS + s * x + c * y]);
    }
  const triangles = [];
  for (let j = 0; j < up; j++)
    for (let i = 0; i < across; i++) {
      const a = j * (across + 1) + i;
      const [b, c, d] = [a + 1, a + across + 2, a + across + 1];
      triangles.push(
        ...(random.below(2)
          ? [
              [a, b, c],
              [a, c, d],
            ]
          : [
              [a, b, d],
              [b, c, d],
            ]),
      );
    }
  return { points, triangles };
}

/** A strip that goes around more than once at one radius, and so covers itself. */
function coil(random, column, row) {
  const steps = 30 + random.below(20);
  const points = [];
  for (let i = 0; i <= steps; i++)
    for (const radius of [0.08, 0.13]) {
      const angle = (i / steps) * random.between(7.5, 7.6);
      points.push([
        (column + 0.5) / CELLS + radius * Math.cos(angle),
        (row + 0.5) / CELLS + radius * Math.sin(angle),
      ]);
    }
  const triangles = [];
  for (let i = 0; i < steps; i++)
    triangles.push([2 * i, 2 * i + 1, 2 * i + 3], [2 * i, 2 * i + 3, 2 * i + 2]);
  return { points, triangles };
}

const moved = (points, du, dv) => points.map(([u, v]) => [u + du, v + dv]);
const middleOf = (points) =>
  [0, 1].map((d) => points.reduce((sum, p) => sum + p[d], 0) / points.length);

/** Each changes some of the islands; `isGeneric` ones are clear even where numbers are rounded. */
const DAMAGES = {
  pulled: {
    isGeneric: true,
    change(random, [first]) {
      const at = random.below(first.points.length);
      const middle = middleOf(first.points);
      first.points[at] = first.points[at].map((x, d) => 2.7 * middle[d] - 1.7 * x);
    },
  },
  onAnother: {
    isGeneric: true,
    change(random, [first, second]) {
      const [a, b] = [middleOf(first.points), middleOf(second.points)];
      const off = () => random.between(-0.02, 0.02);
      first.points = moved(first.points, b[0] - a[0] + off(), b[1] - a[1] + off());
    },
  },
  within: {
    isGeneric: true,
    change(random, [first, second]) {
      const triangle = second.triangles[random.below(second.triangles.length)];
      const inside = middleOf(triangle.map((v) => second.points[v]));
      const middle = middleOf(first.points);
      first.points = first.points.map((p) => p.map((x, d) => inside[d] + (x - middle[d]) / 200));
    },
  },
  mirrored: {
    isGeneric: true,
    change(_random, [first]) {
      const [middle] = middleOf(first.points);
      first.points = first.points.map(([u, v]) => [2 * middle - u, v]);
    },
  },
  collapsed: {
    isGeneric: true,
    change(random, [first]) {
      const [a, b] = first.triangles[random.below(first.triangles.length)];
      first.points[a] = first.points[b];
    },
  },
  coiled: {
    isGeneric: true,
    change: (random, [first]) => Object.assign(first, coil(random, 0, 0)),
  },
  outside: {
    change(_random, [first]) {
      first.points = moved(first.points, middleOf(first.points)[0] < 0.5 ? -0.2 : 0.3, 0);
      first.points = moved(first.points, 0, 0.9);
    },
  },
  stacked: {
    change(_random, [first, second]) {
      Object.assign(second, {
        points: first.points.map((p) => [...p]),
        triangles: first.triangles.map((t) => [...t]),
      });
    },
  },
  /** A corner of one island is the last number that is still, or already, inside the other. */
  touching: {
    change(random, [first, second]) {
      const [a, b] = second.triangles[random.below(second.triangles.length)];
      const [p, q] = [second.points[a], second.points[b]];
      const t = random.between(0.1, 0.9);
      const onEdge = p.map((x, d) => x + t * (q[d] - x));
      const [from] = first.points;
      first.points = moved(first.points, onEdge[0] - from[0], onEdge[1] - from[1]);
    },
  },
};

export const DAMAGE_NAMES = Object.keys(DAMAGES);

/** `damage`: one of DAMAGE_NAMES, or none for a valid layout. */
export function randomLayout(seed, damage) {
  const random = new Random(seed);
  const cells = Array.from({ length: CELLS ** 2 }, (_, i) => i).sort(() => random.next() - 0.5);
  const count = 2 + random.below(cells.length - 1);
  const islands = cells
    .slice(0, count)
    .map((cell) => island(random, cell % CELLS, Math.floor(cell / CELLS)));
  const { change, isGeneric } = damage ? DAMAGES[damage] : { isGeneric: true };
  change?.(random, islands);
  const [positions, texcoords, faces] = [[], [], []];
  islands.forEach(({ points, triangles }, i) => {
    const first = texcoords.length;
    points.forEach(([u, v], k) => {
      texcoords.push([u, v]);
      positions.push([k % 7, i, Math.floor(k / 7) + (k % 7) ** 2 / 10]);
    });
    for (const triangle of triangles) faces.push(triangle.map((v) => first + v));
  });
  return { positions, texcoords, faces, isGeneric: isGeneric === true };
}

export const layoutText = ({ positions, texcoords, faces }) =>
  [
    ...positions.map((p) => `v ${p.join(' ')}`),
    ...texcoords.map((uv) => `vt ${uv.join(' ')}`),
    ...faces.map((face) => `f ${face.map((v) => `${v + 1}/${v + 1}`).join(' ')}`),
    '',
  ].join('\n');
