import type { DisplayMesh } from './mesh';
import { weld } from './weld';

/** The number of the connected part that each triangle belongs to. Vertices at the same point connect. */
export function connectedParts({ positions, indices }: DisplayMesh): Uint32Array {
  const parent = weld(positions, 3).slice();
  const rootOf = (v: number) => {
    let root = v;
    while (parent[root] !== root) root = parent[root];
    for (let at = v; at !== root; ) [at, parent[at]] = [parent[at], root];
    return root;
  };
  for (let c = 0; c < indices.length; ++c) {
    const [a, b] = [rootOf(indices[c]), rootOf(indices[c % 3 === 2 ? c - 2 : c + 1])];
    // Roots are the lowest of their part, as those of vertices at the same point.
    parent[Math.max(a, b)] = Math.min(a, b);
  }
  return Uint32Array.from({ length: indices.length / 3 }, (_, f) => rootOf(indices[3 * f]));
}
