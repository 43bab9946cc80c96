import type { DisplayMesh } from './mesh';

/** The vertices around each face, in order; a face whose triangles have no single outline is given as its triangles. */
export function* outlines({ indices, faces }: DisplayMesh): Generator<number[]> {
  for (let first = 0, end = 0; first < indices.length / 3; first = end) {
    end = first + 1;
    while (faces && end < indices.length / 3 && faces[end] === faces[first]) ++end;
    const corners = indices.subarray(3 * first, 3 * end);
    const outline = end - first > 1 ? outlineOf(corners) : null;
    if (outline) yield outline;
    else for (let c = 0; c < corners.length; c += 3) yield [...corners.subarray(c, c + 3)];
  }
}

/** Null if the sides that have one triangle form no single loop. */
function outlineOf(corners: Uint32Array): number[] | null {
  const sides = new Set<string>();
  for (let c = 0; c < corners.length; ++c) {
    const [a, b] = [corners[c], corners[c % 3 === 2 ? c - 2 : c + 1]];
    if (!sides.delete(`${b} ${a}`)) sides.add(`${a} ${b}`);
  }
  const next = new Map<number, number>();
  for (const side of sides) {
    const [a, b] = side.split(' ').map(Number);
    if (next.has(a)) return null;
    next.set(a, b);
  }
  const [start] = next.keys();
  const loop = [start];
  for (let v = next.get(start); v !== undefined && v !== start; v = next.get(v)) {
    if (loop.length === sides.size) return null;
    loop.push(v);
  }
  // A polygon has two triangles less than corners.
  return loop.length === sides.size && loop.length === corners.length / 3 + 2 ? loop : null;
}
