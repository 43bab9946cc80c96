// OBJ and OFF texts that tests write to files.

export const TRIANGLE = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';

export const TWO_TRIANGLES = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 3 2 4\n';

/** n triangles around vertex 1, which is raised. */
export function fan(n, height = 0.5) {
  const lines = [`v 0 0 ${height}`];
  for (let i = 0; i < n; i++) {
    const angle = (2 * Math.PI * i) / n;
    lines.push(`v ${Math.cos(angle)} ${Math.sin(angle)} 0`);
  }
  for (let i = 0; i < n; i++) lines.push(`f 1 ${2 + i} ${2 + ((i + 1) % n)}`);
  return `${lines.join('\n')}\n`;
}

/** Wavy height field of n x n squares, each cut in two. */
export function grid(n) {
  const lines = [];
  for (let y = 0; y <= n; y++)
    for (let x = 0; x <= n; x++) lines.push(`v ${x} ${y} ${Math.sin(x) * Math.cos(1.3 * y)}`);
  for (let y = 0; y < n; y++)
    for (let x = 0; x < n; x++) {
      const a = y * (n + 1) + x + 1;
      const d = a + n + 1;
      lines.push(`f ${a} ${a + 1} ${d + 1}`, `f ${a} ${d + 1} ${d}`);
    }
  return `${lines.join('\n')}\n`;
}

export const TETRAHEDRON =
  'OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n';

const CUBE_FACES = ['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6'];
const CUBE_VERTICES = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => `v ${i & 1} ${(i >> 1) & 1} ${i >> 2}`);

export const CUBE = `${[...CUBE_VERTICES, ...CUBE_FACES.map((face) => `f ${face}`)].join('\n')}\n`;

/**
 * The same with two uv islands (the second face and the rest) and two materials (the last face and
 * the rest).
 */
export const CUBE_OF_PARTS = `${[
  ...CUBE_VERTICES,
  ...Array.from({ length: 16 }, (_, i) => `vt ${(i & 3) / 8} ${(i >> 2) / 8}`),
  'usemtl most',
  ...CUBE_FACES.map((face, i) => {
    const texcoord = (v) => (i === 1 ? v : v + 8);
    const corners = face.split(' ').map((v) => `${v}/${texcoord(Number(v))}`);
    return `${i === 5 ? 'usemtl last\n' : ''}f ${corners.join(' ')}`;
  }),
].join('\n')}\n`;
