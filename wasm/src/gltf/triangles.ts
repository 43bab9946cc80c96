// Which triangles a primitive draws.

/** glTF's numbers for `mode`. */
export const TRIANGLES = 4;
const [STRIP, FAN] = [5, 6];

export const isOfTriangles = (mode: number) => mode === TRIANGLES || mode === STRIP || mode === FAN;

/**
 * Three vertices per triangle. In strips and fans, the index `restart` ends one and begins the
 * next; triangles that repeat a vertex only lead from one place to another and are left out.
 */
export function trianglesOf(mode: number, vertices: ArrayLike<number>, restart: number) {
  if (mode === TRIANGLES)
    return new Uint32Array(vertices).subarray(0, vertices.length - (vertices.length % 3));
  const triangles: number[] = [];
  let begin = 0;
  for (let i = 0; i < vertices.length; ++i) {
    if (vertices[i] === restart) begin = i + 1;
    if (i < begin + 2) continue;
    const third = vertices[i] as number;
    const second = vertices[i - 1] as number;
    const first = vertices[mode === FAN ? begin : i - 2] as number;
    if (first === second || second === third || third === first) continue;
    const isTurned = mode === STRIP && (i - begin) % 2 === 1;
    triangles.push(...(isTurned ? [second, first, third] : [first, second, third]));
  }
  return Uint32Array.from(triangles);
}
