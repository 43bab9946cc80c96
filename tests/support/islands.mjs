// The uv islands of an OBJ text, found without the program: by places and texcoords, not by indices.

function parseObj(text) {
  const out = { positions: [], texcoords: [], faces: [] };
  for (const line of text.split(/\r?\n/)) {
    const [key, ...words] = line.trim().split(/\s+/);
    if (key === 'v') out.positions.push(words.slice(0, 3).map(Number).join(' '));
    if (key === 'vt') out.texcoords.push(words.slice(0, 2).map(Number).join(' '));
    if (key === 'f')
      out.faces.push(words.map((word) => word.split('/').map((i) => Number(i || 0) - 1)));
  }
  return out;
}

/**
 * Island of each face, numbered by first appearance. Two faces belong to one island if they share
 * an edge: the same places, with the same texcoords there.
 */
export function islandsOf(text) {
  const { positions, texcoords, faces } = parseObj(text);
  const parent = faces.map((_, f) => f);
  const root = (f) => {
    while (parent[f] !== f) f = parent[f];
    return f;
  };
  const seen = new Map();
  for (const [f, face] of faces.entries()) {
    const ends = face.map(([v, t]) => `${positions[v]} ${texcoords[t]}`);
    for (const [i, end] of ends.entries()) {
      const edge = [end, ends[(i + 1) % ends.length]].sort().join('|');
      if (seen.has(edge)) parent[root(f)] = root(seen.get(edge));
      else seen.set(edge, f);
    }
  }
  const numbers = new Map();
  return faces.map((_, f) => {
    const r = root(f);
    if (!numbers.has(r)) numbers.set(r, numbers.size);
    return numbers.get(r);
  });
}
