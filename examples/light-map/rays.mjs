// Whether something is in the way of a ray: triangles in a tree of boxes.

const FEW = 4;

/** `triangles`: [[x, y, z], [x, y, z], [x, y, z]] each. Returns whether a ray is blocked. */
export function blockerOf(triangles) {
  const root = nodeOf(triangles);
  return (origin, direction) => blocks(root, { origin, direction });
}

function nodeOf(triangles) {
  const low = [0, 1, 2].map((d) => Math.min(...triangles.flat().map((p) => p[d])));
  const high = [0, 1, 2].map((d) => Math.max(...triangles.flat().map((p) => p[d])));
  if (triangles.length <= FEW) return { low, high, triangles: triangles.map(edgesOf) };
  const extent = high.map((x, d) => x - low[d]);
  const axis = extent.indexOf(Math.max(...extent));
  const middle = (triangle) => triangle.reduce((sum, p) => sum + p[axis], 0);
  const sorted = [...triangles].sort((a, b) => middle(a) - middle(b));
  const half = sorted.length >> 1;
  return { low, high, nodes: [nodeOf(sorted.slice(0, half)), nodeOf(sorted.slice(half))] };
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

const edgesOf = ([a, b, c]) => ({ a, u: minus(b, a), v: minus(c, a) });

function blocks({ low, high, nodes, triangles }, ray) {
  if (!reaches(low, high, ray)) return false;
  if (!triangles) return blocks(nodes[0], ray) || blocks(nodes[1], ray);
  for (const triangle of triangles) if (isHit(triangle, ray)) return true;
  return false;
}

function reaches(low, high, { origin, direction }) {
  let enter = 0;
  let leave = Infinity;
  for (let d = 0; d < 3; ++d) {
    const s = (low[d] - origin[d]) / direction[d];
    const t = (high[d] - origin[d]) / direction[d];
    enter = Math.max(enter, Math.min(s, t));
    leave = Math.min(leave, Math.max(s, t));
  }
  return enter <= leave;
}

/** Möller and Trumbore, from either side. */
function isHit({ a, u, v }, { origin, direction }) {
  const p = cross(direction, v);
  const determinant = dot(u, p);
  if (Math.abs(determinant) < 1e-12) return false;
  const from = minus(origin, a);
  const s = dot(from, p) / determinant;
  if (s < 0 || s > 1) return false;
  const q = cross(from, u);
  const t = dot(direction, q) / determinant;
  return t >= 0 && s + t <= 1 && dot(v, q) / determinant > 0;
}
