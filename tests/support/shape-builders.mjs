// Ways to build the shapes that people model: { points: [[x, y, z]], faces: [[point, ...]] }, with y
// upwards and faces counter-clockwise from outside.

const range = (n) => Array.from({ length: n }, (_, i) => i);

export const evenly = (length, n) => range(n + 1).map((i) => (length * i) / n);

/** Collects points, each place once, in a table of its own. */
function pointsByPlace() {
  const points = [];
  const numbers = new Map();
  const at = (...p) => {
    const key = p.join(' ');
    if (!numbers.has(key)) numbers.set(key, points.push(p) - 1);
    return numbers.get(key);
  };
  return { points, at };
}

/** Each polygon as a fan of triangles around its first corner. */
export function triangulated({ points, faces }) {
  const fan = (face) => face.slice(2).map((last, i) => [face[0], face[i + 1], last]);
  return { points, faces: faces.flatMap(fan) };
}

/** Faces turned around: a surface seen from inside. */
export const insideOut = ({ points, faces }) => ({
  points,
  faces: faces.map((face) => face.toReversed()),
});

/** Several shapes in one file; parts at the same place stay separate. */
export function together(shapes) {
  const points = [];
  const faces = [];
  for (const shape of shapes) {
    const first = points.length;
    points.push(...shape.points);
    faces.push(...shape.faces.map((face) => face.map((v) => v + first)));
  }
  return { points, faces };
}

export const moved = ({ points, faces }, shift) => ({
  points: points.map((p) => p.map((x, d) => x + shift[d])),
  faces,
});

/** The outside of solid cells of a grid with the given coordinates, as quads. */
export function cells([xs, ys, zs], isSolid) {
  const lines = [xs, ys, zs];
  const { points, at } = pointsByPlace();
  const faces = [];
  const isFilled = (cell) =>
    cell.every((i, d) => i >= 0 && i < lines[d].length - 1) && isSolid(...cell);
  const side = (cell, axis, end) => {
    const [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
    const corner = (i, j) => {
      const grid = [...cell];
      grid[axis] += end;
      grid[a] += i;
      grid[b] += j;
      return at(...grid.map((k, d) => lines[d][k]));
    };
    const quad = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
    faces.push(end === 1 ? quad : quad.toReversed());
  };
  for (const x of range(xs.length - 1))
    for (const y of range(ys.length - 1))
      for (const z of range(zs.length - 1)) {
        if (!isSolid(x, y, z)) continue;
        for (const axis of [0, 1, 2])
          for (const end of [0, 1]) {
            const next = [x, y, z];
            next[axis] += 2 * end - 1;
            if (!isFilled(next)) side([x, y, z], axis, end);
          }
      }
  return { points, faces };
}

export const box = (size, n = 1) =>
  cells(
    size.map((length) => evenly(length, n)),
    () => true,
  );

/**
 * A counter-clockwise polygon [[x, y]] drawn out along z, in `rows` rows. A hole is clockwise, and
 * the caps reach it by a slit from corner `from` of the polygon to its first corner.
 */
export function extruded(polygon, depth, { hole = [], from = 0, rows = 1 } = {}) {
  const rings = [polygon, hole].filter((ring) => ring.length > 0);
  const { points, at } = pointsByPlace();
  const faces = [];
  const levels = evenly(depth, rows);
  for (const ring of rings)
    for (const [i, p] of ring.entries()) {
      const q = ring[(i + 1) % ring.length];
      for (const k of range(rows))
        faces.push([
          at(...p, levels[k]),
          at(...q, levels[k]),
          at(...q, levels[k + 1]),
          at(...p, levels[k + 1]),
        ]);
    }
  const slit = hole.length > 0 ? [...hole, hole[0], polygon[from]] : [];
  const outline = [...polygon.slice(0, from + 1), ...slit, ...polygon.slice(from + 1)];
  faces.push(outline.map((p) => at(...p, depth)));
  faces.push(outline.toReversed().map((p) => at(...p, 0)));
  return { points, faces };
}

/** A polygon of right angles with every corner rounded by `segments` edges. */
export function rounded(polygon, radius, segments) {
  const unit = (a, b) => {
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    return [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
  };
  return polygon.flatMap((p, i) => {
    const [before, after] = [polygon.at(i - 1), polygon[(i + 1) % polygon.length]];
    const [back, on] = [unit(p, before), unit(p, after)];
    return range(segments + 1).map((k) => {
      const angle = (Math.PI / 2) * (k / segments);
      const [s, t] = [1 - Math.sin(angle), 1 - Math.cos(angle)].map((x) => x * radius);
      return p.map((x, d) => x + s * back[d] + t * on[d]);
    });
  });
}

/** A regular polygon around the origin, counter-clockwise from the point on the x-axis. */
export const regular = (sides, radius = 1) =>
  range(sides).map((i) => {
    const angle = (2 * Math.PI * i) / sides;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });

/**
 * A profile [[radius, y], ...] turned around the y-axis; the surface lies to the right of the
 * profile as it rises. A point of radius 0 is one vertex. `caps` closes the first and last ring:
 * 'none', 'polygon' or 'fan' (with a vertex in the middle); 'ring' joins the ends of the profile.
 */
export function turned(profile, sides, caps = 'none') {
  const { points, at } = pointsByPlace();
  const faces = [];
  const circle = regular(sides);
  const place = ([r, y], i) => {
    const [c, s] = circle[i % sides];
    return r === 0 ? at(0, y, 0) : at(r * s, y, r * c);
  };
  const strip = (low, high) => {
    for (const i of range(sides)) {
      const quad = [place(low, i), place(low, i + 1), place(high, i + 1), place(high, i)];
      faces.push(quad.filter((v, k) => v !== quad.at(k - 1)));
    }
  };
  for (const k of range(profile.length - 1)) strip(profile[k], profile[k + 1]);
  const [first, last] = [profile[0], profile.at(-1)];
  if (caps === 'ring') strip(last, first);
  if (caps === 'fan') {
    strip([0, first[1]], first);
    strip(last, [0, last[1]]);
  }
  if (caps === 'polygon') {
    if (first[0] > 0)
      faces.push(
        range(sides)
          .map((i) => place(first, i))
          .toReversed(),
      );
    if (last[0] > 0) faces.push(range(sides).map((i) => place(last, i)));
  }
  return { points, faces };
}

const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/**
 * An open tube of radius 1 along a way of steps: { ahead: length, rows } goes straight on,
 * { bend: 'left' or 'up', radius, rows } turns by a right angle.
 */
export function tube(steps, sides) {
  const circle = regular(sides);
  const points = [];
  const faces = [];
  let [place, ahead, left] = [
    [0, 0, 0],
    [1, 0, 0],
    [0, 0, -1],
  ];
  const add = (p, ...terms) => p.map((x, d) => terms.reduce((s, [f, v]) => s + f * v[d], x));
  const ring = (p, along, side) => {
    const above = cross(along, side);
    for (const [c, s] of circle) points.push(add(p, [c, side], [s, above]));
    const last = points.length - sides;
    if (last === 0) return;
    for (const i of range(sides)) {
      const j = (i + 1) % sides;
      faces.push([last + i, last + j, last - sides + j, last - sides + i].toReversed());
    }
  };
  ring(place, ahead, left);
  for (const { ahead: length, bend, radius, rows } of steps) {
    const toward = bend === 'up' ? cross(ahead, left) : left;
    const start = place;
    const [from, sideways] = [ahead, left];
    for (const k of range(rows)) {
      if (bend === undefined) {
        place = add(start, [(length * (k + 1)) / rows, from]);
      } else {
        const angle = ((Math.PI / 2) * (k + 1)) / rows;
        const [c, s] = k + 1 === rows ? [0, 1] : [Math.cos(angle), Math.sin(angle)];
        place = add(start, [radius * s, from], [radius * (1 - c), toward]);
        ahead = add([0, 0, 0], [c, from], [s, toward]);
        left = bend === 'up' ? sideways : add([0, 0, 0], [c, toward], [-s, from]);
      }
      ring(place, ahead, left);
    }
  }
  return { points, faces };
}

/** A box whose edges and corners are rounded by `segments` faces across. */
export function bevelledBox(size, width, segments) {
  const { points, at } = pointsByPlace();
  const faces = [];
  const signs = [-1, 1];
  // Weights that meet the axes at even angles along the edges of a corner.
  const weight = (k) => Math.sin((Math.PI / 2) * (k / segments));
  const place = (sign, ijk) => {
    const direction = ijk.map(weight);
    const length = Math.hypot(...direction);
    return at(...size.map((s, d) => sign[d] * (s / 2 - width + (width * direction[d]) / length)));
  };
  /** From the inside out: the shape is convex. */
  const face = (...corners) => {
    const [a, b, c] = corners.slice(0, 3).map((v) => points[v]);
    const normal = cross(
      b.map((x, d) => x - a[d]),
      c.map((x, d) => x - a[d]),
    );
    const isOutward = normal.reduce((sum, x, d) => sum + x * a[d], 0) > 0;
    faces.push(isOutward ? corners : corners.toReversed());
  };
  /** The sign of axis d is s, of the next one t, of the one after u. */
  const signed = (d, s, t, u) => {
    const out = [0, 0, 0];
    for (const [k, x] of [s, t, u].entries()) out[(d + k) % 3] = x;
    return out;
  };
  for (const d of [0, 1, 2]) {
    const flat = signed(d, segments, 0, 0);
    for (const s of signs)
      face(
        ...[
          [-1, -1],
          [1, -1],
          [1, 1],
          [-1, 1],
        ].map(([t, u]) => place(signed(d, s, t, u), flat)),
      );
    for (const t of signs)
      for (const u of signs)
        for (const k of range(segments)) {
          const across = (i) => signed(d, 0, segments - i, i);
          const [near, far] = signs.map((s) => signed(d, s, t, u));
          face(
            place(near, across(k)),
            place(far, across(k)),
            place(far, across(k + 1)),
            place(near, across(k + 1)),
          );
        }
  }
  for (const x of signs)
    for (const y of signs)
      for (const z of signs) {
        const corner = (i, j) => place([x, y, z], [i, j, segments - i - j]);
        for (const i of range(segments))
          for (const j of range(segments - i)) {
            face(corner(i, j), corner(i + 1, j), corner(i, j + 1));
            if (i + j < segments - 1)
              face(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
          }
      }
  return { points, faces };
}

/** A screw with a hexagonal head, and a round shaft of `sides` (a multiple of 6) without a thread. */
export function screw(sides, { head = 1.8, height = 1.2, shaft = 1, length = 5 } = {}) {
  const { points, at } = pointsByPlace();
  const per = sides / 6;
  const ring = (corners, y) => corners.map(([c, s]) => at(s, y, c));
  const hexagon = regular(6, head);
  const [top, under] = [length + height, length].map((y) => ring(hexagon, y));
  const [high, low] = [length, 0].map((y) => ring(regular(sides, shaft), y));
  const faces = [top, low.toReversed()];
  for (const k of range(6)) {
    const next = (k + 1) % 6;
    faces.push([under[k], under[next], top[next], top[k]]);
    // The ring under the head: from each corner of the hexagon half a side to either way.
    const half = Math.floor(per / 2);
    const middle = (k * per + half) % sides;
    for (const i of range(per)) {
      const [a, b] = [k * per + i, (k * per + i + 1) % sides];
      faces.push([high[a], high[b], i < half ? under[k] : under[next]]);
    }
    faces.push([high[middle], under[next], under[k]]);
  }
  for (const i of range(sides)) {
    const j = (i + 1) % sides;
    faces.push([low[i], low[j], high[j], high[i]]);
  }
  return { points, faces };
}
