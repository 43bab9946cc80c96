// Measures of an atlas, computed alike for every program: from triangles with texcoords and the
// surface they lie on.

const sub = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);

/** Edges of a triangle in its own plane, [length of the first, then x and y of the second]; null without area. */
function inPlane([a, b, c]) {
  const [e, g] = [sub(b, a), sub(c, a)];
  const length = Math.hypot(...e);
  const x = dot(e, g) / length;
  const y = Math.sqrt(Math.max(dot(g, g) - x * x, 0));
  return length > 0 && y > 0 ? { length, x, y, area: (length * y) / 2 } : null;
}

/** Sum of the squares of both singular values and of their inverses, halved twice: 1 for an isometry. */
function symmetricDirichlet({ length, x, y }, [a, b, c], scale) {
  const [e, g] = [sub(b, a), sub(c, a)];
  const first = e.map((d) => (scale * d) / length);
  const second = g.map((d, i) => (scale * d - first[i] * x) / y);
  const norm = dot(first, first) + dot(second, second);
  const det = first[0] * second[1] - first[1] * second[0];
  return (norm + norm / (det * det)) / 4;
}

const signedArea = ([a, b, c]) =>
  ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;

/** Length of the edges whose two triangles have different texcoords. */
function seamLength(triangles, positions) {
  const seen = new Map();
  let sum = 0;
  for (const { vertices, texcoords } of triangles)
    for (let i = 0; i < 3; i++) {
      const j = (i + 1) % 3;
      const [from, to] = vertices[i] < vertices[j] ? [i, j] : [j, i];
      const key = vertices[from] * positions.length + vertices[to];
      const here = [texcoords[from], texcoords[to]];
      const other = seen.get(key);
      if (!other) seen.set(key, here);
      else if (other.some((t, k) => t !== here[k]))
        sum += Math.hypot(...sub(positions[vertices[from]], positions[vertices[to]]));
    }
  return sum;
}

/**
 * `triangles` are `{ vertices, texcoords }` of 3 indices each; both tables have rows of numbers.
 * Lengths are relative to the square root of the surface's area; `symmetricDirichlet` is the
 * area-weighted mean at the one area-preserving scale, over all triangles that have area in both;
 * `lost` counts those without area in the layout.
 */
export function measureAtlas({ triangles, positions, texcoords }) {
  const pairs = triangles.flatMap(({ vertices, texcoords: t }) => {
    const flat = inPlane(vertices.map((v) => positions[v]));
    return flat ? [{ flat, uv: t.map((i) => texcoords[i]) }] : [];
  });
  const area = pairs.reduce((sum, { flat }) => sum + flat.area, 0);
  const covered = pairs.reduce((sum, { uv }) => sum + Math.abs(signedArea(uv)), 0);
  const scale = Math.sqrt(area / covered);
  let [energy, weight, lost] = [0, 0, 0];
  for (const { flat, uv } of pairs) {
    // Lost to single precision, or without any texcoords.
    if (!(Math.abs(signedArea(uv)) * scale * scale > 1e-9 * flat.area)) {
      lost++;
      continue;
    }
    energy += flat.area * symmetricDirichlet(flat, uv, scale);
    weight += flat.area;
  }
  return {
    seamLength: seamLength(triangles, positions) / Math.sqrt(area),
    symmetricDirichlet: energy / weight,
    lost,
  };
}
