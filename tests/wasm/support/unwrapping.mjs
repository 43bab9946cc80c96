// Meshes as arrays, and how a call of unwrap fails.

import assert from 'node:assert/strict';
import { AbflatError } from 'abflat';

/** Triangles as arrays; a polygon becomes a fan around its first corner. */
export function arraysOf({ positions, faces }) {
  const fans = faces.flatMap((face) => face.slice(2).flatMap((c, k) => [face[0], face[k + 1], c]));
  return { positions: Float64Array.from(positions.flat()), indices: Uint32Array.from(fans) };
}

/** With faces of four corners. */
export const CUBE = {
  positions: [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, (i >> 1) & 1, i >> 2]),
  faces: [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ],
};

/** And the next call works. */
export async function assertFails(abflat, call, code, pattern) {
  await assert.rejects(call, (error) => {
    assert.ok(error instanceof AbflatError, `${error}`);
    assert.equal(error.code, code, error.message);
    assert.match(error.message, pattern);
    return true;
  });
  assert.equal((await abflat.unwrap(arraysOf(CUBE))).report.valid, true);
}
