import type { FlatMesh } from './mesh';

/** Interior angles of a triangle with these side lengths, each opposite its side, radians. */
function angles(a: number, b: number, c: number): [number, number, number] {
  const at = (opposite: number, s: number, t: number) =>
    Math.acos(Math.min(1, Math.max(-1, (s * s + t * t - opposite * opposite) / (2 * s * t))));
  return [at(a, b, c), at(b, c, a), at(c, a, b)];
}

function lengths(p: Float64Array, size: number, vertices: Uint32Array): [number, number, number] {
  const distance = (v: number, w: number) => {
    let sum = 0;
    for (let d = 0; d < size; ++d) sum += (p[size * v + d] - p[size * w + d]) ** 2;
    return Math.sqrt(sum);
  };
  const [i, j, k] = vertices;
  return [distance(j, k), distance(k, i), distance(i, j)];
}

/**
 * Per triangle, the root mean square over its corners of the relative change of the angle. The mean
 * of the squares over all triangles is the angular distortion in the report. 0 for a triangle
 * without area in 3D.
 */
export function angleErrors({ positions, indices, uv }: FlatMesh): Float32Array {
  const errors = new Float32Array(indices.length / 3);
  for (let f = 0; f < errors.length; ++f) {
    const vertices = indices.subarray(3 * f, 3 * f + 3);
    const before = angles(...lengths(positions, 3, vertices));
    const after = angles(...lengths(uv, 2, vertices));
    const squares = before.map((alpha, k) => ((after[k] - alpha) / alpha) ** 2);
    const error = Math.sqrt((squares[0] + squares[1] + squares[2]) / 3);
    errors[f] = Number.isFinite(error) ? error : 0;
  }
  return errors;
}
