// Finer versions of a mesh that are curved everywhere.

/** Splits each face into four at the midpoints of its edges. */
function subdivided({ positions, faces }) {
  const points = [...positions];
  const middles = new Map();
  const middle = (a, b) => {
    const key = Math.min(a, b) * positions.length + Math.max(a, b);
    if (!middles.has(key))
      middles.set(key, points.push(positions[a].map((x, d) => (x + positions[b][d]) / 2)) - 1);
    return middles.get(key);
  };
  const parts = faces.flatMap(([a, b, c]) => {
    const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    return [
      [a, ab, ca],
      [ab, b, bc],
      [ca, bc, c],
      [ab, bc, ca],
    ];
  });
  return { positions: points, faces: parts };
}

/**
 * Moves each vertex halfway to the mean of its neighbours, so that a subdivided surface is curved
 * everywhere.
 */
function smoothed({ positions, faces }) {
  const sums = positions.map(() => [0, 0, 0, 0]);
  for (const face of faces)
    for (const [i, v] of face.entries()) {
      const next = positions[face[(i + 1) % face.length]];
      for (let d = 0; d < 3; d++) sums[v][d] += next[d];
      sums[v][3]++;
    }
  return {
    positions: positions.map((p, v) => p.map((x, d) => (x + sums[v][d] / sums[v][3]) / 2)),
    faces,
  };
}

/** Splits and smooths a mesh so many times. */
export function refined(mesh, levels) {
  let out = mesh;
  for (let i = 0; i < levels; i++) out = smoothed(smoothed(subdivided(out)));
  return out;
}
