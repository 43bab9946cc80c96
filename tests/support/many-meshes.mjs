// Folders of meshes of any size and format, some of which are broken, from a seed.

import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { Random } from './random-surfaces.mjs';
import { binaryStl, trianglesOf } from './stl.mjs';
import { objText, sheet, sphere, torus } from './surfaces.mjs';

const triangles = ({ positions, faces }) => ({
  positions,
  faces: faces.flatMap((face) => face.slice(2).map((_, i) => [face[0], face[i + 1], face[i + 2]])),
});

/** Surfaces of about so many faces. */
const SHAPES = [
  (faces, random) => {
    const n = Math.max(1, Math.round(Math.sqrt(faces / 2)));
    const height = random.between(0, 0.3);
    return sheet(n, n, (u, v) => [u, v, height * Math.sin(5 * u) * Math.cos(7 * v)]);
  },
  (faces, random) => {
    const n = Math.max(3, Math.round(Math.sqrt(faces / 4)));
    return torus(2 * n, n, random.between(0.2, 0.6));
  },
  (faces) => triangles(sphere(Math.max(1, Math.round(Math.sqrt(faces / 12))))),
];

const offText = ({ positions, faces }) =>
  [
    `OFF\n${positions.length} ${faces.length} 0`,
    ...positions.map((p) => p.join(' ')),
    ...faces.map((face) => [face.length, ...face].join(' ')),
    '',
  ].join('\n');

const plyText = ({ positions, faces }) =>
  [
    'ply\nformat ascii 1.0',
    `element vertex ${positions.length}`,
    'property double x\nproperty double y\nproperty double z',
    `element face ${faces.length}`,
    'property list uchar int vertex_indices\nend_header',
    ...positions.map((p) => p.join(' ')),
    ...faces.map((face) => [face.length, ...face].join(' ')),
    '',
  ].join('\n');

const WRITERS = {
  obj: (mesh) => objText(mesh),
  off: offText,
  ply: plyText,
  stl: (mesh) => binaryStl(trianglesOf(objText(mesh))),
};

/** Each makes a file that no command can use of one that it could. */
export const BREAKS = {
  empty: () => ['obj', ''],
  noise: (_, random) => ['stl', Buffer.from(Array.from({ length: 300 }, () => random.below(256)))],
  'cut off': (mesh) => ['ply', plyText(mesh).slice(0, -plyText(mesh).length / 3)],
  'not finite': (mesh) => ['obj', objText(mesh).replace(/^v \S+/m, 'v nan')],
  'no such vertex': (mesh) => ['obj', `${objText(mesh)}f 1 2 99999999\n`],
  'no faces': () => ['off', 'OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n'],
  'another format': () => ['glb', 'solid no glTF\nendsolid\n'],
};

/** The number of faces: most meshes are small. */
const sizeOf = (random, most) => Math.round(10 * (most / 10) ** (random.next() ** 24));

/**
 * Writes `count` meshes of up to `most` faces, of which a share is broken. Returns them as `{ name,
 * broken }`, where `broken` says how, if it is.
 */
export function writeManyMeshes(folder, { count, most, broken: share = 0.03, seed = 1 }) {
  const random = new Random(seed);
  const kinds = Object.keys(BREAKS);
  return Array.from({ length: count }, (_, i) => {
    const isBroken = i % Math.round(1 / share) === 0;
    const mesh = random.pick(SHAPES)(i === 1 ? most : sizeOf(random, most), random);
    // No two files have the same content.
    mesh.positions = mesh.positions.map(([x, y, z]) => [x, y, z + i / count]);
    const kind = isBroken ? kinds[Math.round(i * share) % kinds.length] : undefined;
    const format = random.pick(Object.keys(WRITERS));
    const [ending, bytes] = kind ? BREAKS[kind](mesh, random) : [format, WRITERS[format](mesh)];
    const name = `${['', 'a/', 'a/b/'][i % 3]}mesh-${i}.${ending}`;
    mkdirSync(dirname(join(folder, name)), { recursive: true });
    writeFileSync(join(folder, name), bytes);
    return { name, broken: kind };
  });
}
