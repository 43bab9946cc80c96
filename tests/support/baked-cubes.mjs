// Cubes of several materials as a GLB, and whether an OBJ has the same look.

import assert from 'node:assert/strict';
import { atRandomPoints, COLOUR, ROUGH, waves } from './baking.mjs';
import { samplerOf, texturedCube, texturedGlb } from './textured.mjs';
import { objSampler } from './textured-obj.mjs';

/** A cube beside others, also in its layout, as pack keeps what lies on each other. */
export function cubeAt(material, x) {
  const cube = texturedCube(material);
  return {
    ...cube,
    positions: cube.positions.map(([a, b, c]) => [a + x, b, c]),
    uv: cube.uv.map(([u, v]) => [u + x, v]),
  };
}

/** The first has every map but normals; the others are plain. The node has a name. */
export const threeCubes = () =>
  texturedGlb([cubeAt(0, 0), cubeAt(1, 5), cubeAt(2, 10)], {
    materials: [
      {
        name: 'old metal',
        pbrMetallicRoughness: {
          baseColorTexture: { index: 0 },
          baseColorFactor: [0.5, 1, 0.25, 1],
          metallicFactor: 0.8,
          roughnessFactor: 0.25,
          metallicRoughnessTexture: { index: 1 },
        },
        occlusionTexture: { index: 1, strength: 0.5 },
        emissiveFactor: [0, 0.5, 0],
      },
      { name: 'old#metal', pbrMetallicRoughness: { baseColorFactor: [0.2, 0.4, 0.8, 1] } },
      { pbrMetallicRoughness: { baseColorFactor: [0.2, 0.4, 0.8, 1] } },
    ],
    nodes: [{ mesh: 0, name: 'cubes' }],
    textures: [{ source: 0 }, { source: 1 }],
    images: [waves(384, 256), waves(192, 128, 1)],
  });

export const CUBE_NAMES = ['old_metal', 'old_metal_2', 'material'];

function assertNear(is, expected, what) {
  expected.forEach((value, d) => {
    assert.ok(Math.abs(is[d] - value) < 0.025, `${what}: ${is} is not ${expected}`);
  });
}

/** Compares the cubes of threeCubes with an OBJ that they were baked into. */
export function assertSameCubes(glb, path) {
  const [was, is] = [samplerOf(glb), objSampler(path)];
  assert.equal(is.count, was.count);
  const factor = [0.5, 1, 0.25];
  atRandomPoints(was.count, (t, weights) => {
    const isFirst = t < 12;
    const colour = isFirst
      ? was.sample(COLOUR, t, weights, true).map((x, d) => x * (factor[d] ?? 1))
      : [0.2, 0.4, 0.8];
    assertNear(is.sample('map_Kd', t, weights, true), colour.slice(0, 3), 'colour');
    const old = isFirst ? was.sample(ROUGH, t, weights) : [1, 4, 1.25];
    assertNear(is.sample('map_Pr', t, weights), [0.25 * old[1]], 'roughness');
    assertNear(is.sample('map_Pm', t, weights), [0.8 * old[2]], 'metal');
    assertNear(is.sample('map_Ke', t, weights, true), [0, isFirst ? 0.5 : 0, 0], 'emission');
  });
}
