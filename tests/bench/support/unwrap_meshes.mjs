// Closed meshes as large as scans, as OBJ files in build/bench.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { BUILD, ROOT } from '../../../scripts/lib/paths.mjs';
import { isosurface, knot, objText } from '../../support/surfaces.mjs';

const FOLDER = join(BUILD, 'bench');
const SHARED = join(ROOT, '../shared/meshes');

/** Splits each face into four at the midpoints of its edges. */
function subdivided({ positions, faces }) {
  const points = [...positions];
  const middles = new Map();
  const middle = (a, b) => {
    const key = Math.min(a, b) * positions.length + Math.max(a, b);
    if (!middles.has(key))
      middles.set(key, points.push(positions[a].map((x, d) => (x + positions[b][d]) / 2)) - 1);
    return middles.get(key);
  };
  const parts = faces.flatMap(([a, b, c]) => {
    const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
    return [
      [a, ab, ca],
      [ab, b, bc],
      [ca, bc, c],
      [ab, bc, ca],
    ];
  });
  return { positions: points, faces: parts };
}

/**
 * Moves each vertex halfway to the mean of its neighbours, so that a subdivided surface is curved
 * everywhere.
 */
function smoothed({ positions, faces }) {
  const sums = positions.map(() => [0, 0, 0, 0]);
  for (const face of faces)
    for (const [i, v] of face.entries()) {
      const next = positions[face[(i + 1) % face.length]];
      for (let d = 0; d < 3; d++) sums[v][d] += next[d];
      sums[v][3]++;
    }
  return {
    positions: positions.map((p, v) => p.map((x, d) => (x + sums[v][d] / sums[v][3]) / 2)),
    faces,
  };
}

function readOff(name) {
  const words = readFileSync(join(SHARED, name), 'utf8').replace(/#.*/g, '').trim().split(/\s+/);
  const [vertices, faces] = words.slice(1, 3).map(Number);
  const numbers = words.slice(4).map(Number);
  const rest = numbers.slice(3 * vertices);
  return {
    positions: Array.from({ length: vertices }, (_, v) => numbers.slice(3 * v, 3 * v + 3)),
    faces: Array.from({ length: faces }, (_, f) => rest.slice(4 * f + 1, 4 * f + 4)),
  };
}

const refined = (name, levels) => {
  let mesh = readOff(name);
  for (let i = 0; i < levels; i++) mesh = smoothed(smoothed(subdivided(mesh)));
  return mesh;
};

const MESHES = {
  'knot-90k': { make: () => knot(900, 50) },
  'iso-64': { make: () => isosurface(64) },
  'fertility+1': { file: 'fertility-genus4.off', make: () => refined('fertility-genus4.off', 1) },
  'bunny+2': { file: 'bunny-closed.off', make: () => refined('bunny-closed.off', 2) },
  'iso-128': { make: () => isosurface(128) },
};

export const UNWRAP_MESHES = Object.keys(MESHES);

/** Writes a mesh; returns its path and number of faces, undefined if its source file is missing. */
export function writeUnwrapMesh(name) {
  const { file, make } = MESHES[name];
  if (file && !existsSync(join(SHARED, file))) {
    console.log(`skipped: ${name}, ../shared/meshes/${file} does not exist`);
    return undefined;
  }
  mkdirSync(FOLDER, { recursive: true });
  const path = join(FOLDER, `${name}.obj`);
  const mesh = make();
  writeFileSync(path, objText(mesh));
  return { path, faces: mesh.faces.length };
}
