// OBJ and OFF texts that tests write to files.

export const TRIANGLE = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';

export const TWO_TRIANGLES = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 3 2 4\n';

/** n triangles round vertex 1, which is raised. */
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
