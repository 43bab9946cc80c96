// STL files from triangles, [[[x, y, z] x 3], ...], written by code that is independent of the
// library.

export function binaryStl(triangles, header = 'made by a test') {
  const bytes = Buffer.alloc(84 + 50 * triangles.length);
  bytes.write(header, 'latin1');
  bytes.writeUInt32LE(triangles.length, 80);
  triangles.flat(2).forEach((x, i) => {
    const facet = Math.floor(i / 9);
    bytes.writeFloatLE(x, 84 + 50 * facet + 12 + 4 * (i % 9));
  });
  return bytes;
}

export function textStl(triangles) {
  const facets = triangles.map(
    (points) =>
      `facet normal 0 0 0\nouter loop\n${points.map((p) => `vertex ${p.join(' ')}\n`).join('')}endloop\nendfacet\n`,
  );
  return Buffer.from(`solid test\n${facets.join('')}endsolid test\n`);
}

/** The triangles of an OBJ text without texcoords. */
export function trianglesOf(obj) {
  const lines = obj.split('\n').map((line) => line.split(' '));
  const points = lines.filter(([key]) => key === 'v').map(([, ...xyz]) => xyz.map(Number));
  return lines
    .filter(([key]) => key === 'f')
    .map(([, ...corners]) => corners.map((v) => points[Number(v) - 1]));
}
