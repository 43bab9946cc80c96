// A ring with a colour, bumps, metal and roughness in images.

import { madePng } from './made-png.mjs';
import { texturedGlb } from './textured.mjs';

const TURN = 2 * Math.PI;
const byte = (x) => Math.round(255 * Math.min(1, Math.max(0, x)));

/** A GLB of `around` by `across` quads, with images of `texels` by as many. */
export function texturedRing({ around = 96, across = 48, texels = 1024 } = {}) {
  const part = { positions: [], normals: [], uv: [], triangles: [], material: 0 };
  for (let j = 0; j <= across; j++)
    for (let i = 0; i <= around; i++) {
      const [a, b] = [(TURN * i) / around, (TURN * j) / across];
      const normal = [Math.cos(b) * Math.cos(a), Math.sin(b), Math.cos(b) * Math.sin(a)];
      part.normals.push(normal);
      part.positions.push([
        Math.cos(a) + 0.45 * normal[0],
        0.45 * normal[1],
        Math.sin(a) + 0.45 * normal[2],
      ]);
      part.uv.push([i / around, j / across]);
      if (i === around || j === across) continue;
      const v = j * (around + 1) + i;
      const [p, q, r, s] = [v, v + around + 1, v + around + 2, v + 1];
      part.triangles.push([p, q, r], [p, r, s]);
    }
  const wave = (x, y, k) => Math.sin((TURN * k * x) / texels) * Math.cos((TURN * k * y) / texels);
  const colour = madePng(texels, texels, (x, y) =>
    [0.55 + 0.4 * wave(x, y, 3), 0.5 + 0.3 * wave(y, x, 5), 0.5 - 0.3 * wave(x, y, 2)].map(byte),
  );
  const bumps = madePng(texels, texels, (x, y) => {
    const slope = 0.35 * TURN;
    const n = [
      slope * 0.12 * Math.cos((TURN * 12 * x) / texels),
      slope * 0.2 * Math.sin((TURN * 6 * y) / texels),
      1,
    ];
    return n.map((each) => byte(0.5 + each / Math.hypot(...n) / 2));
  });
  const metal = madePng(texels, texels, (x, y) =>
    [1, 0.5 + 0.3 * wave(x, y, 4), 0.5 + 0.5 * wave(y, x, 2)].map(byte),
  );
  return texturedGlb([part], {
    materials: [
      {
        pbrMetallicRoughness: {
          baseColorTexture: { index: 0 },
          metallicRoughnessTexture: { index: 2 },
        },
        normalTexture: { index: 1 },
      },
    ],
    textures: [{ source: 0 }, { source: 1 }, { source: 2 }],
    images: [colour, bumps, metal],
  });
}
