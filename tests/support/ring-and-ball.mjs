// A ring and a ball, painted with all kinds of maps.

import { imageOf, waves } from './made-images.mjs';
import { encodedPng } from './made-png.mjs';
import { texturedGlb } from './textured.mjs';

const fileOf = ({ data, width, height }) => encodedPng(width, height, data);

/** A surface over a unit square that begins at `left`; `at(u, v)` has its position, normal and so on. */
function patch([n, m], { left = 0, material }, at) {
  const out = { positions: [], normals: [], uv: [], triangles: [], material };
  for (let j = 0; j <= m; ++j)
    for (let i = 0; i <= n; ++i) {
      for (const [name, row] of Object.entries(at(i / n, j / m))) {
        out[name] ??= [];
        out[name].push(row);
      }
      out.uv.push([left + i / n, j / m]);
      const a = j * (n + 1) + i;
      if (i < n && j < m) out.triangles.push([a, a + n + 2, a + 1], [a, a + n + 1, a + n + 2]);
    }
  return out;
}

const turn = 2 * Math.PI;

/** With tangents: without them three.js makes frames that are wrong where a layout is stretched. */
const ring = patch([48, 24], { material: 0 }, (u, v) => {
  const [c, s] = [Math.cos(turn * u), Math.sin(turn * u)];
  const [a, b] = [Math.cos(turn * v), -Math.sin(turn * v)];
  return {
    positions: [(1.3 + 0.45 * a) * c, 0.45 * b, -(1.3 + 0.45 * a) * s],
    normals: [a * c, b, -a * s],
    tangents: [-s, 0, -c, 1],
  };
});

const ball = patch([32, 16], { left: 1, material: 1 }, (u, v) => {
  const normal = [
    Math.sin(Math.PI * v) * Math.cos(turn * u),
    Math.cos(Math.PI * v),
    -Math.sin(Math.PI * v) * Math.sin(turn * u),
  ];
  return { positions: normal.map((x) => 0.6 * x), normals: normal };
});

const bumps = imageOf(256, 256, (x, y) => {
  const [a, b] = [0.5 * Math.sin((turn * 6 * x) / 256), 0.5 * Math.cos((turn * 4 * y) / 256)];
  const length = Math.hypot(a, b, 1);
  return [a, b, 1].map((n) => Math.round(127.5 + (127.5 * n) / length));
});
const rough = imageOf(128, 128, (x, y) => [255 - y, 60 + x, y < 64 ? 0 : 200]);

/** A GLB with every map, or all but `normalTexture`; one of its materials has alpha. */
export const ringAndBall = (normalTexture) =>
  texturedGlb([ring, ball], {
    materials: [
      {
        name: 'ring',
        pbrMetallicRoughness: {
          baseColorTexture: {
            index: 0,
            extensions: { KHR_texture_transform: { scale: [3, 2], offset: [0.2, 0.1] } },
          },
          metallicRoughnessTexture: { index: 2 },
        },
        ...(normalTexture && { normalTexture }),
        occlusionTexture: { index: 2, strength: 0.7 },
      },
      {
        name: 'ball',
        pbrMetallicRoughness: {
          baseColorTexture: { index: 3 },
          baseColorFactor: [1, 0.8, 0.6, 1],
          metallicFactor: 0.1,
          roughnessFactor: 0.6,
        },
        alphaMode: 'MASK',
        doubleSided: true,
        emissiveTexture: { index: 0 },
        emissiveFactor: [0.1, 0.05, 0.3],
      },
    ],
    textures: [0, 1, 2, 3].map((source) => ({ source })),
    images: [
      waves(256),
      bumps,
      rough,
      // What is transparent is of a colour that nobody should see.
      imageOf(128, 128, (x, y) =>
        (x >> 5) % 2 ? [40, 90 + y, 200, 255] : [250, 250, 0, 255 * ((y >> 5) % 2)],
      ),
    ].map(fileOf),
    extensionsUsed: ['KHR_texture_transform'],
  });
