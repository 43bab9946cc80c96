// Lays charts that lie on each other side by side, since each gets texels of its own.

/** `uvs` with each part, whose faces share vertices, in a column of its own. */
export function spread(uvs: Float64Array, indices: Uint32Array): Float64Array {
  const part = partsOf(uvs.length / 2, indices);
  const spans = new Map<number, [number, number]>();
  for (const vertex of indices) {
    const key = part[vertex] as number;
    const u = uvs[2 * vertex] as number;
    const [left, right] = spans.get(key) ?? [u, u];
    spans.set(key, [Math.min(left, u), Math.max(right, u)]);
  }
  const widths = [...spans.values()].map(([left, right]) => right - left);
  // A gap as wide as the widest keeps islands apart from their neighbours.
  const gap = widths.reduce((a, b) => Math.max(a, b), 1e-30);
  const shifts = new Map<number, number>();
  let end = 0;
  for (const [key, [left, right]] of spans) {
    shifts.set(key, end - left);
    end += right - left + gap;
  }
  return uvs.map((x, i) => (i % 2 === 0 ? x + (shifts.get(part[i >> 1] as number) ?? 0) : x));
}

/** A vertex for each vertex, which is the same for those that faces connect. */
function partsOf(count: number, indices: Uint32Array): Uint32Array {
  const parent = Uint32Array.from({ length: count }, (_, i) => i);
  const root = (vertex: number): number => {
    let at = vertex;
    while (parent[at] !== at) {
      parent[at] = parent[parent[at] as number] as number;
      at = parent[at] as number;
    }
    return at;
  };
  for (let c = 0; c < indices.length; c += 3)
    for (const k of [1, 2]) parent[root(indices[c + k] as number)] = root(indices[c] as number);
  return parent.map((_, vertex) => root(vertex));
}
