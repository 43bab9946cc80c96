// A bumpy ball whose texture is in many small islands, and a colour that its texels must have.

import { encodedPng } from './made-png.mjs';
import { oneTexture, texturedGlb } from './textured.mjs';

/** Texels around an island that go on as it does. */
const MARGIN = 3;

/** Red, green and blue from 0 to 1 of a point in space, as an image holds them. */
export const colourAt = ([x, y, z]) => [
  0.5 + 0.4 * Math.sin(4 * x + 2 * y),
  0.5 + 0.4 * Math.sin(4 * y - 3 * z + 1),
  0.5 + 0.4 * Math.cos(4 * z + 2 * x),
];

/** The point at a and b from -1 to 1 of a side of the cube that the ball is blown up from. */
function pointOf(side, a, b) {
  const sign = side < 3 ? 1 : -1;
  const p = [0, 0, 0];
  p[side % 3] = sign;
  p[((side % 3) + 1) % 3] = sign * Math.tan((a * Math.PI) / 4);
  p[((side % 3) + 2) % 3] = Math.tan((b * Math.PI) / 4);
  const length = Math.hypot(...p);
  const [x, y, z] = p.map((each) => each / length);
  const radius = 1 + 0.05 * Math.sin(5 * x) * Math.sin(5 * y) * Math.sin(5 * z);
  return [x, y, z].map((each) => each * radius);
}

/**
 * A GLB of 6 sides with `perSide` islands in each direction, of `quads` x `quads` quads; the texture
 * has `texels` for the side of an island, with a margin around it.
 */
export function manyIslands({ perSide, quads, texels }) {
  const islands = 6 * perSide ** 2;
  const columns = Math.ceil(Math.sqrt(islands));
  const part = { positions: [], uv: [], triangles: [], material: 0 };
  const size = columns * texels;
  const pixels = Buffer.alloc(4 * size * size, 255);
  const inner = texels - 2 * MARGIN;
  for (let island = 0; island < islands; island++) {
    const side = Math.floor(island / perSide ** 2);
    const [i, j] = [island % perSide, Math.floor(island / perSide) % perSide];
    const placed = (s, t) =>
      pointOf(side, (2 * (i + s)) / perSide - 1, (2 * (j + t)) / perSide - 1);
    const [left, top] = [(island % columns) * texels, Math.floor(island / columns) * texels];
    for (let y = 0; y < texels; y++)
      for (let x = 0; x < texels; x++) {
        const colour = colourAt(placed((x + 0.5 - MARGIN) / inner, (y + 0.5 - MARGIN) / inner));
        const at = 4 * ((top + y) * size + left + x);
        colour.forEach((value, d) => {
          pixels[at + d] = Math.round(255 * value);
        });
      }
    const first = part.positions.length;
    for (let t = 0; t <= quads; t++)
      for (let s = 0; s <= quads; s++) {
        part.positions.push(placed(s / quads, t / quads));
        part.uv.push([
          (left + MARGIN + (inner * s) / quads) / size,
          (top + MARGIN + (inner * t) / quads) / size,
        ]);
        if (s === quads || t === quads) continue;
        const v = first + t * (quads + 1) + s;
        const [a, b, c, d] = [v, v + 1, v + quads + 2, v + quads + 1];
        part.triangles.push([a, b, c], [a, c, d]);
      }
  }
  return {
    bytes: texturedGlb([part], oneTexture(encodedPng(size, size, pixels))),
    islands,
    faces: part.triangles.length,
  };
}
