// Cylinders with two lids, whose side is smooth and whose rims are hard, as files say it.

import { GlbMaker } from './glb.mjs';

/**
 * `faces` are triangles, with the part of each: 0 is the lid below, 1 the side, 2 the lid above.
 * `edges` has the hard edges, two vertices each, the smaller first.
 */
export function drum(sides = 24, rows = 3) {
  const positions = [];
  for (let row = 0; row <= rows; ++row)
    for (let i = 0; i < sides; ++i) {
      const angle = (2 * Math.PI * i) / sides;
      positions.push([Math.cos(angle), Math.sin(angle), (2 * row) / rows]);
    }
  const [below, above] = [positions.length, positions.length + 1];
  positions.push([0, 0, 0], [0, 0, 2]);
  const [faces, parts, edges] = [[], [], []];
  const add = (part, ...triangles) => {
    for (const triangle of triangles) {
      faces.push(triangle);
      parts.push(part);
    }
  };
  for (let i = 0; i < sides; ++i) {
    const next = (i + 1) % sides;
    const top = rows * sides;
    add(0, [below, next, i]);
    for (let row = 0; row < rows; ++row) {
      const [a, b] = [row * sides + i, row * sides + next];
      add(1, [a, b, b + sides], [a, b + sides, a + sides]);
    }
    add(2, [above, top + i, top + next]);
    for (const at of [0, top]) edges.push([at + i, at + next].sort((a, b) => a - b));
  }
  return { positions, faces, parts, edges };
}

/** The shading normal of a vertex in a part. */
const normalOf = ([x, y], part) =>
  [
    [0, 0, -1],
    [x, y, 0],
    [0, 0, 1],
  ][part];

const lines = (keyword, rows) => rows.map((row) => `${keyword} ${row.join(' ')}\n`).join('');

/** With a normal for each vertex and part, referred to as the OBJ format does. */
export function objWithNormals({ positions, faces, parts }) {
  const normals = [0, 1, 2].flatMap((part) => positions.map((p) => normalOf(p, part)));
  // The centres of the lids have none on the side.
  const given = normals.map((n) => (n.every((x) => x === 0) ? [1, 0, 0] : n));
  const f = faces.map((face, i) =>
    face.map((v) => `${v + 1}//${parts[i] * positions.length + v + 1}`),
  );
  return lines('v', positions) + lines('vn', given) + lines('f', f);
}

/** The lids are in no group, or in groups of their own. */
export function objWithGroups({ positions, faces, parts }, groups = ['off', '1', 'off']) {
  const f = faces.map(
    (face, i) => `s ${groups[parts[i]]}\nf ${face.map((v) => v + 1).join(' ')}\n`,
  );
  return lines('v', positions) + f.join('');
}

/** With one vertex for each place and normal, as in graphics memory; `source` is the place of each. */
export function split({ positions, faces, parts }) {
  const [known, source, normals] = [new Map(), [], []];
  const indices = faces.flatMap((face, i) =>
    face.map((v) => {
      const key = `${v} ${parts[i]}`;
      if (!known.has(key)) {
        known.set(key, source.length);
        source.push(v);
        normals.push(normalOf(positions[v], parts[i]));
      }
      return known.get(key);
    }),
  );
  return { positions: source.map((v) => positions[v]), indices, normals, source };
}

export function plyText(surface) {
  const { positions, indices, normals } = split(surface);
  const rows = positions.map((p, i) => `${[...p, ...normals[i]].join(' ')}\n`);
  const faces = surface.faces.map((_, f) => `3 ${indices.slice(3 * f, 3 * f + 3).join(' ')}\n`);
  const numbers = ['x', 'y', 'z', 'nx', 'ny', 'nz'].map((name) => `property double ${name}\n`);
  return `ply\nformat ascii 1.0\nelement vertex ${rows.length}\n${numbers.join('')}element face ${faces.length}\nproperty list uchar int vertex_indices\nend_header\n${rows.join('')}${faces.join('')}`;
}

/** `node`: where it is placed. */
export function glbBytes(surface, node = {}) {
  const { positions, indices, normals } = split(surface);
  const maker = new GlbMaker();
  const floats = (rows) => new Float32Array(rows.flat());
  const attributes = {
    POSITION: maker.accessor(floats(positions), 'VEC3', { box: true, target: 34962 }),
    NORMAL: maker.accessor(floats(normals), 'VEC3', { target: 34962 }),
  };
  const primitive = {
    attributes,
    indices: maker.accessor(new Uint16Array(indices), 'SCALAR', { target: 34963 }),
  };
  Object.assign(maker.json, {
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, ...node }],
    meshes: [{ primitives: [primitive] }],
  });
  return maker.glb();
}
