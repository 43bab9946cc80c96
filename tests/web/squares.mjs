// An OBJ whose layout is known: separate squares.

export const CORNERS = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
];

/** Unit squares, each an object with a rectangle in uv: [u, v, width, height], a negative width mirrors it. */
export function squares(rectangles) {
  const lines = rectangles.flatMap(([u, v, width, height], i) => [
    `o square ${i}`,
    ...CORNERS.map(([x, y]) => `v ${x + 2 * i} ${y} 0`),
    ...CORNERS.map(([x, y]) => `vt ${u + x * width} ${v + y * height}`),
    `f ${[1, 2, 3, 4].map((k) => `${4 * i + k}/${4 * i + k}`).join(' ')}`,
  ]);
  return `${lines.join('\n')}\n`;
}
