// OBJ texts of meshes that produce report entries that are otherwise rare.

import { randomNumbers } from './disks.mjs';
import { objText, sheet } from './surfaces.mjs';

/**
 * A sheet with random heights: steep enough for angles to leave their range, and for cotangent
 * weights to flip triangles.
 */
export function rough(seed) {
  const next = randomNumbers(seed);
  return objText(sheet(12, 12, (u, v) => [12 * u, 12 * v, 4 * next()]));
}

/**
 * A flat sheet with a vertex in the middle of each square: its edges resist the Delaunay condition
 * on a convex outline.
 */
export function stellated() {
  const { positions, faces } = sheet(4, 4, (u, v) => [4 * u, 4 * v, 0]);
  const fans = faces.flatMap((face) => {
    const middle = [0, 1, 2].map(
      (d) => face.reduce((sum, v) => sum + positions[v][d], 0) / face.length,
    );
    const n = positions.push(middle) - 1;
    return face.map((v, k) => [v, face[(k + 1) % face.length], n]);
  });
  return objText({ positions, faces: fans });
}

const FLAT = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0 0\n';
/** A disk with a triangle without area. */
export const NEEDLE = `${FLAT}f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n`;
/** The second face touches itself. */
export const TOUCHING = `${FLAT}v -1 0 0\nv -1 -1 0\nf 1 3 4\nf 1 2 3 1 6 7\n`;

/** Two triangles of which each is the other's mirror image, and a copy of the first. */
export const MIRROR_IMAGES = [
  ...['0 0', '3 0', '0 1', '9 0', '6 0', '9 1', '0 5', '3 5', '0 6'].map((p) => `v ${p} 0`),
  ...['1 2 3', '4 6 5', '7 8 9', ''].map((f) => f && `f ${f}`),
].join('\n');

/** Pins at the corners of a grid of n x n squares that make it fold. */
export const foldingPins = (n) => {
  const uv = [
    [0, 0],
    [0, 1],
    [1, 0],
    [1, 1],
  ];
  return [0, n, n * (n + 1), (n + 1) ** 2 - 1].map((vertex, i) => ({ vertex, uv: uv[i] }));
};

/** A triangle without area in uv. */
export const EMPTY_IN_UV = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 1\nf 1/1 2/2 3/2\n';

/** Squares in space: two that lie on each other, one of them mirrored, one that overlaps them a little, and one without texcoords. */
export function overlappingIslands() {
  const places = [[0, 1], [1, -1], [0.9, 1], undefined];
  const corners = [0, 1, 2, 3].map((k) => [k === 1 || k === 2 ? 1 : 0, k >> 1]);
  const lines = places.flatMap((place, i) => [
    ...corners.map(([x, y]) => `v ${x} ${y} ${i}`),
    ...corners.flatMap(([x, y]) => (place ? [`vt ${place[0] + x * place[1]} ${y}`] : [])),
    `f ${[1, 2, 3, 4].map((k) => (place ? `${4 * i + k}/${4 * i + k}` : 4 * i + k)).join(' ')}`,
  ]);
  return `${lines.join('\n')}\n`;
}
