// Meshes made on the spot, and as text.

/** A bumpy square of `size` x `size` cells, two triangles each: a disk. */
export function grid(size, Positions = Float64Array) {
  const positions = new Positions(3 * (size + 1) ** 2);
  const indices = new Uint32Array(6 * size ** 2);
  let v = 0;
  for (let y = 0; y <= size; ++y) {
    for (let x = 0; x <= size; ++x) {
      const [a, b] = [x / size, y / size];
      // + 0: text has no negative zero.
      positions.set([a, b, 0.2 * Math.sin(7 * a) * Math.cos(5 * b) + 0], 3 * v++);
    }
  }
  let c = 0;
  for (let y = 0; y < size; ++y) {
    for (let x = 0; x < size; ++x) {
      const [p, q] = [y * (size + 1) + x, (y + 1) * (size + 1) + x];
      indices.set([p, p + 1, q + 1, p, q + 1, q], c);
      c += 6;
    }
  }
  return { positions, indices };
}

/** Two grids that do not touch. */
export function twoGrids(size) {
  const { positions, indices } = grid(size);
  const count = positions.length / 3;
  return {
    positions: Float64Array.from([...positions, ...positions.map((x) => x + 10)]),
    indices: Uint32Array.from([...indices, ...indices.map((v) => v + count)]),
  };
}

export const TETRAHEDRON = {
  positions: new Float64Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]),
  indices: new Uint32Array([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]),
};

export function objText({ positions, indices }) {
  return [...lines(positions, 'v '), ...lines(indices, 'f ', 1)].join('\n');
}

export function offText({ positions, indices }) {
  const counts = `${positions.length / 3} ${indices.length / 3} 0`;
  return ['OFF', counts, ...lines(positions, ''), ...lines(indices, '3 ')].join('\n');
}

/** Numbers as JavaScript writes them read back to the same doubles. */
function lines(values, prefix, offset = 0) {
  return Array.from({ length: values.length / 3 }, (_, i) => {
    const row = [values[3 * i], values[3 * i + 1], values[3 * i + 2]];
    return prefix + row.map((value) => value + offset).join(' ');
  });
}

export const bytesOf = (text) => new TextEncoder().encode(text);

/** The numbers of all lines of an OBJ that begin with `keyword`. */
export function objNumbers(text, keyword) {
  return text
    .split('\n')
    .filter((line) => line.startsWith(`${keyword} `))
    .flatMap((line) => line.trim().split(/\s+/).slice(1).map(Number));
}
