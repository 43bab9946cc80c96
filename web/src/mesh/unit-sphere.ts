import { boundingBox, type DisplayMesh, usedVertices } from './mesh';

/**
 * Positions moved and scaled so that the triangles lie in the unit sphere around the centre of
 * their box, which preserves the precision of float32.
 */
export function toUnitSphere({ positions, indices }: DisplayMesh): Float32Array {
  const used = usedVertices(positions.length / 3, indices);
  const { min, max } = boundingBox(positions, 3, used);
  const [x, y, z] = min.map((low, d) => (low + max[d]) / 2);
  let radius = 0;
  for (let at = 0; at < used.length; ++at) {
    const i = 3 * used[at];
    const away = Math.hypot(positions[i] - x, positions[i + 1] - y, positions[i + 2] - z);
    if (away > radius) radius = away;
  }
  const points = new Float32Array(positions.length);
  for (let i = 0; i < points.length; i += 3) {
    points[i] = (positions[i] - x) / (radius || 1);
    points[i + 1] = (positions[i + 1] - y) / (radius || 1);
    points[i + 2] = (positions[i + 2] - z) / (radius || 1);
  }
  return points;
}
