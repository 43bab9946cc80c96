// Ordinary shapes, and what a person would expect of their layouts, decided before seeing one.
//
// Each is { name, points, faces, expect }, with y upwards. `expect` has
//   charts  [fewest, most]
//   sd      most symmetric Dirichlet energy / 4 at equal area; 1 + 1e-6 if the shape unrolls
//   flat    edges of charts within flat regions: always 0
//   level   least share of outlines along u or v
//   isSeam  which edges may be cut: of { a, b, bend }, its ends and by how many degrees it bends
//   cut     most length of cut edges

import {
  bevelledBox,
  box,
  cells,
  evenly,
  extruded,
  insideOut,
  moved,
  regular,
  rounded,
  screw,
  together,
  triangulated,
  tube,
  turned,
} from './shape-builders.mjs';

const UNROLLED = 1 + 1e-6;

const isCrease = ({ bend }) => bend > 20;
const isAlong =
  (axis) =>
  ({ a, b }) =>
    [0, 1, 2].every((d) => d === axis || Math.abs(a[d] - b[d]) < 1e-9);

/** Shapes of right angles, made of at most `most` flat regions: by creases, every outline level. */
const rightAngled = (most) => ({
  charts: [1, most],
  sd: UNROLLED,
  flat: 0,
  level: 0.99,
  isSeam: isCrease,
});

/** Points of a plane, from "x y, x y, ...". */
const outline = (text) => text.split(', ').map((point) => point.split(' ').map(Number));

const shape = (name, surface, expect) => ({ name, ...surface, expect: { flat: 0, ...expect } });

const grid = (xs, ys, zs, isSolid = () => true) => cells([xs, ys, zs], isSolid);
const unit = (n) => evenly(n, n);

function boxes() {
  const out = [
    shape('cube', box([1, 1, 1]), rightAngled(6)),
    shape('cube of triangles', triangulated(box([1, 1, 1])), rightAngled(6)),
    shape('plank', box([3, 0.3, 0.2]), rightAngled(6)),
  ];
  for (const size of [
    [1, 2, 3],
    [1, 1, 8],
    [1, 4, 4],
  ])
    for (const n of [1, 3, 8]) {
      const name = `box ${size.join(':')} in ${n}x${n}`;
      out.push(shape(name, box(size, n), rightAngled(6)));
      out.push(shape(`${name} of triangles`, triangulated(box(size, n)), rightAngled(6)));
    }
  return out;
}

/** The side is a strip, cut once along the axis; caps are disks. */
function cylinders() {
  const out = [];
  const isUpright = isAlong(1);
  const side = { charts: [1, 1], sd: UNROLLED, level: 0.99, isSeam: isUpright };
  const closed = {
    charts: [3, 3],
    sd: UNROLLED,
    level: 0.5,
    isSeam: (edge) => edge.bend > 80 || isUpright(edge),
  };
  for (const sides of [8, 16, 32, 64]) {
    const profile = (rows) => evenly(2, rows).map((y) => [1, y]);
    for (const rows of [1, 6]) {
      const name = `of ${sides} sides in ${rows} row${rows > 1 ? 's' : ''}`;
      out.push(shape(`open cylinder ${name}`, turned(profile(rows), sides), side));
      out.push(shape(`cylinder ${name}`, turned(profile(rows), sides, 'polygon'), closed));
    }
    const fan = triangulated(turned(profile(1), sides, 'fan'));
    out.push(shape(`cylinder of ${sides} sides, caps as fans`, fan, closed));
    out.push(shape(`cylinder of ${sides} sides as in three.js`, asInThree(sides), closed));
  }
  return out;
}

/** The side and both caps have vertices of their own, and the side starts and ends with its own. */
function asInThree(sides) {
  const whole = [0, 2].map((y) => [1, y]);
  const side = triangulated(turned(whole, sides));
  const points = side.points.slice();
  // The last column gets copies of the points of the first.
  const copies = side.points.slice(0, 0);
  const faces = side.faces.map((face, f) => {
    if (f < side.faces.length - 2) return face;
    return face.map((v) => {
      const [x, , z] = side.points[v];
      const isFirst = Math.abs(x) < 1e-12 && z > 0;
      return isFirst ? points.length + copies.push([...side.points[v]]) - 1 : v;
    });
  });
  points.push(...copies);
  const cap = (ends) => triangulated(turned(ends, sides));
  return together([{ points, faces }, cap(outline('1 2, 0 2')), cap(outline('0 0, 1 0'))]);
}

function turnedShapes() {
  const isLowRim = ({ a, b, bend }) => a[1] === 0 && b[1] === 0 && bend > 20;
  const isRule = ({ a, b }) => Math.abs(a[0] * b[2] - a[2] * b[0]) < 1e-9;
  const out = [];
  for (const sides of [16, 48]) {
    const cone = { sd: UNROLLED, isSeam: (edge) => isLowRim(edge) || isRule(edge) };
    const profile = outline('1 0, 0 2');
    out.push(
      shape(`open cone of ${sides} sides`, turned(profile, sides), { ...cone, charts: [1, 1] }),
      shape(`cone of ${sides} sides`, turned(profile, sides, 'polygon'), {
        ...cone,
        charts: [2, 2],
      }),
      shape(`frustum of ${sides} sides`, turned(outline('1 0, 0.6 2'), sides, 'polygon'), {
        charts: [3, 3],
        sd: UNROLLED,
        isSeam: (edge) => edge.bend > 45 || isRule(edge),
      }),
      shape(
        `lid of ${sides} sides`,
        turned(outline('1.8 0.4, 1.8 0, 2 0, 2 0.5'), sides, 'polygon'),
        // A long strip may be cut in two, to be no longer than the discs are wide.
        {
          charts: [3, 7],
          sd: UNROLLED,
          isSeam: (edge) => edge.bend > 60 || isRule(edge),
        },
      ),
      shape(`disc of ${sides} sides`, turned(outline('2 0, 2 0.1'), sides, 'polygon'), {
        charts: [3, 5],
        sd: UNROLLED,
        isSeam: (edge) => edge.bend > 60 || isAlong(1)(edge),
      }),
    );
  }
  out.push(
    shape(
      'torus',
      turned(
        regular(24, 0.4).map(([x, y]) => [x + 1, y]),
        48,
        'ring',
      ),
      {
        charts: [1, 4],
        sd: 1.07,
        // Twice around the hole and four times around the ring.
        cut: 2 * 2 * Math.PI + 4 * 0.8 * Math.PI,
      },
    ),
  );
  return out;
}

const L = outline('0 0, 3 0, 3 0.5, 0.5 0.5, 0.5 2, 0 2');

/** A polygon drawn out: a strip and two ends, cut at the ends' rims and along the strip. */
const drawnOut = (least = 0.5) => ({
  charts: [1, 3],
  sd: UNROLLED,
  level: least,
  isSeam: (edge) => edge.bend > 80 || isAlong(2)(edge),
});

function prisms() {
  const out = [3, 5, 6].map((sides) =>
    shape(`prism of ${sides} sides`, extruded(regular(sides), 2), drawnOut()),
  );
  out.push(shape('bracket', extruded(L, 1.5), rightAngled(8)));
  for (const segments of [1, 3])
    out.push(
      shape(
        `bracket, corners of ${segments}`,
        extruded(rounded(L, 0.15, segments), 1.5),
        drawnOut(),
      ),
      // The corners do not unroll, but they are small.
      shape(`bevelled box, edges of ${segments}`, bevelledBox([3, 2, 1], 0.1, segments), {
        charts: [1, 6],
        sd: 1.005,
        level: 0.7,
        isSeam: isCrease,
      }),
    );
  out.push(
    shape('house', extruded(outline('0 0, 4 0, 4 2, 2 3.5, 0 2'), 6), {
      charts: [1, 7],
      sd: UNROLLED,
      level: 0.6,
      isSeam: isCrease,
    }),
    shape(
      'house with eaves',
      extruded(outline('0 0, 4 0, 4 2, 4.6 1.55, 4.6 1.75, 2 3.7, -0.6 1.75, -0.6 1.55, 0 2'), 6),
      { charts: [1, 11], sd: UNROLLED, level: 0.6, isSeam: isCrease },
    ),
  );
  return out;
}

function letters() {
  const letter = (name, polygon, options) =>
    shape(`letter ${name}`, extruded(polygon, 0.4, options), {
      charts: [1, options ? 4 : 3],
      sd: UNROLLED,
      level: options ? 0.4 : 0.99,
      isSeam: isCrease,
    });
  const ring = [0, 0.4, 1, 1.4];
  return [
    letter('L', outline('0 0, 1.2 0, 1.2 0.4, 0.4 0.4, 0.4 2, 0 2')),
    letter('T', outline('0.5 0, 0.9 0, 0.9 1.6, 1.4 1.6, 1.4 2, 0 2, 0 1.6, 0.5 1.6')),
    letter(
      'E',
      outline(
        '0 0, 1.2 0, 1.2 0.4, 0.4 0.4, 0.4 0.8, 1 0.8, 1 1.2, 0.4 1.2, 0.4 1.6, 1.2 1.6, 1.2 2, 0 2',
      ),
    ),
    letter(
      'H',
      outline('0 0, 0.4 0, 0.4 0.8, 1 0.8, 1 0, 1.4 0, 1.4 2, 1 2, 1 1.2, 0.4 1.2, 0.4 2, 0 2'),
    ),
    letter('A', outline('0 0, 0.3 0, 0.45 0.4, 1.05 0.4, 1.2 0, 1.5 0, 0.95 2, 0.55 2'), {
      hole: outline('0.55 0.7, 0.75 1.4, 0.95 0.7'),
      from: 2,
    }),
    shape(
      'letter O',
      grid(ring, [0, 0.4, 1.6, 2], [0, 0.4], (x, y) => x !== 1 || y !== 1),
      rightAngled(4),
    ),
  ];
}

function table() {
  const [xs, ys, zs] = [
    [0, 0.2, 2.8, 3],
    [0, 1.4, 1.5],
    [0, 0.2, 1.3, 1.5],
  ];
  const isLeg = (x, z) => x !== 1 && z !== 1;
  const leg = box([0.2, 1.4, 0.2]);
  const corners = [0, 2.8].flatMap((x) => [0, 1.3].map((z) => [x, 0, z]));
  return [
    shape(
      'table of five boxes',
      together([moved(box([3, 0.1, 1.5]), [0, 1.4, 0]), ...corners.map((p) => moved(leg, p))]),
      { ...rightAngled(30), charts: [5, 30] },
    ),
    shape(
      'table in one piece',
      grid(xs, ys, zs, (x, y, z) => y === 1 || isLeg(x, z)),
      rightAngled(26),
    ),
  ];
}

function plate(count) {
  const lines = Array.from({ length: 2 * count + 2 }, (_, i) => i);
  const isHole = (x, z) => x % 2 === 1 && z % 2 === 1;
  return shape(
    `plate with ${count}x${count} holes`,
    grid(lines, [0, 0.3], lines, (x, _, z) => !isHole(x, z)),
    { ...rightAngled(count ** 2 + 6), charts: [2, count ** 2 + 6] },
  );
}

function stairs(steps) {
  const polygon = [[0, 0]];
  for (let i = 0; i < steps; i++) polygon.push([steps - i, i], [steps - i, i + 1]);
  polygon.push([0, steps]);
  return shape(`stairs of ${steps} steps`, extruded(polygon, 4), rightAngled(4));
}

/** Walls of thickness 0 seen from inside, with a recess for the door. */
function room() {
  const isAir = (x, y, z) => z > 0 || (x === 1 && y === 0);
  const inside = grid([0, 2, 2.9, 5], [0, 2.1, 2.8], [-0.2, 0, 4], isAir);
  return shape('room', insideOut(inside), rightAngled(11));
}

/** Solid cubes, as in games made of blocks. */
function blocks() {
  const isInSprite = (x, y) => {
    const rows = ['0011100', '0111110', '1101011', '1111111', '1011101', '0100010', '0010100'];
    return rows[6 - y][x] === '1';
  };
  const isShelf = (x, y) => y % 5 === 0 || x === 0 || x === 8 || x === 15;
  const isHouse = (x, y, z) => {
    const isWall = x === 1 || x === 10 || z === 1 || z === 8;
    const isDoor = z === 1 && x > 4 && x < 7 && y < 3;
    const isRoof = y >= 5 && (z === y - 5 || z === 14 - y);
    return (
      isRoof ||
      (y < 5 + Math.min(z, 9 - z) && isWall && z > 0 && z < 9 && x > 0 && x < 11 && !isDoor)
    );
  };
  const isStud = (x, y, z) => y === 0 || (x % 2 === 1 && z % 2 === 1);
  return [
    shape('sprite of blocks', grid(unit(7), unit(7), [0, 1], isInSprite), rightAngled(8)),
    shape('shelf of blocks', grid(unit(16), unit(21), unit(4), isShelf), rightAngled(20)),
    shape('plate with studs', grid(unit(9), unit(2), unit(9), isStud), rightAngled(38)),
    shape('house of blocks', grid(unit(12), unit(10), unit(10), isHouse), rightAngled(30)),
  ];
}

function pipes() {
  const steps = [
    { ahead: 6, rows: 2 },
    { bend: 'left', radius: 3, rows: 6 },
    { ahead: 4, rows: 2 },
    { bend: 'up', radius: 3, rows: 6 },
    { ahead: 6, rows: 2 },
  ];
  const length = 16 + 3 * Math.PI;
  return [16, 64].map((sides) =>
    shape(`pipe of ${sides} sides with two bends`, tube(steps, sides), {
      charts: [1, 5],
      sd: 1.03,
      level: 0.9,
      // Once along the pipe and four times around it.
      cut: 1.1 * length + 4 * 2 * Math.PI,
    }),
  );
}

export function ordinaryShapes() {
  return [
    ...boxes(),
    ...prisms(),
    ...cylinders(),
    ...turnedShapes(),
    ...pipes(),
    stairs(6),
    ...table(),
    plate(3),
    plate(15),
    room(),
    shape('screw', screw(24), {
      charts: [3, 6],
      sd: UNROLLED,
      isSeam: (edge) => edge.bend > 50 || isAlong(1)(edge),
    }),
    ...letters(),
    ...blocks(),
  ];
}
