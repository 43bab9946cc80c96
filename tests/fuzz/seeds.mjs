// Files to start from: small, and one of each kind that a reader distinguishes.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { randomNumbers } from '../support/disks.mjs';
import { GlbMaker } from '../support/glb.mjs';
import { PLY_FORMATS, plyBytes } from '../support/ply.mjs';
import { CUBE, CUBE_OF_PARTS, fan, grid, TETRAHEDRON, TRIANGLE } from '../support/small-meshes.mjs';
import { binaryStl, textStl, trianglesOf } from '../support/stl.mjs';

const SQUARE = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0],
  [0, 1, 0],
];

function square(format) {
  const xyz = ['x', 'y', 'z'].map((name) => ({ name, type: 'float' }));
  const st = ['s', 't'].map((name) => ({ name, type: 'double' }));
  return plyBytes({
    format,
    comments: ['TextureFile a.png'],
    elements: [
      {
        name: 'vertex',
        properties: [...xyz, ...st, { name: 'red', type: 'uchar' }],
        rows: SQUARE.map(([x, y, z]) => [x, y, z, x, y, 200]),
      },
      {
        name: 'face',
        properties: [
          { name: 'vertex_indices', countType: 'uchar', type: 'int' },
          { name: 'texcoord', countType: 'uchar', type: 'float' },
        ],
        rows: [
          [
            [0, 1, 2],
            [0, 0, 1, 0, 1, 1],
          ],
          [
            [0, 2, 3],
            [0, 0, 1, 1, 0, 1],
          ],
        ],
      },
      {
        name: 'edge',
        properties: [{ name: 'vertex1', type: 'short' }],
        rows: [[1], [2]],
      },
    ],
  });
}

/** A square and a flap as one strip, and another. */
function strips(format) {
  return plyBytes({
    format,
    elements: [
      {
        name: 'vertex',
        properties: ['x', 'y', 'z'].map((name) => ({ name, type: 'float' })),
        rows: [...SQUARE, [0, 0, 1]],
      },
      {
        name: 'tristrips',
        properties: [{ name: 'vertex_indices', countType: 'int', type: 'int' }],
        rows: [[[0, 1, 3, 2, -1, 0, 3, 4]], [[2, 1, 1, 4]]],
      },
    ],
  });
}

/** A square as binary OFF. */
function binaryOff(isLittle, hasColors) {
  const bytes = [];
  const put = (kind, value) => {
    const view = new DataView(new ArrayBuffer(4));
    view[`set${kind}`](0, value, isLittle);
    bytes.push(Buffer.from(view.buffer));
  };
  for (const count of [4, 2, 0]) put('Int32', count);
  for (const x of SQUARE.flat()) put('Float32', x);
  for (const face of [
    [0, 1, 2],
    [0, 2, 3],
  ]) {
    for (const number of [3, ...face]) put('Int32', number);
    if (!hasColors) continue;
    put('Int32', 3);
    for (const x of [1, 0.5, 0]) put('Float32', x);
  }
  return Buffer.concat([Buffer.from('OFF BINARY\n'), ...bytes]);
}

/** A textured square, its indices in the given type, with a second node that mirrors it. */
function squareGlb(Indices, mode, indices) {
  const maker = new GlbMaker();
  const positions = new Float32Array(SQUARE.flat());
  const attributes = {
    POSITION: maker.accessor(positions, 'VEC3', { box: true, target: 34962 }),
    TEXCOORD_0: maker.accessor(new Uint8Array([0, 0, 255, 0, 255, 255, 0, 255]), 'VEC2', {
      normalized: true,
      target: 34962,
    }),
  };
  const targets = [
    { POSITION: maker.sparse(4, 'VEC3', new Uint16Array([1]), positions.slice(3, 6)) },
  ];
  const primitive = {
    attributes,
    indices: maker.accessor(Indices.from(indices), 'SCALAR'),
    mode,
    targets,
  };
  Object.assign(maker.json, {
    meshes: [
      {
        primitives: [
          { ...primitive, material: 0 },
          { attributes: { POSITION: attributes.POSITION } },
        ],
      },
    ],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ source: 0 }],
    images: [{ uri: 'image.png' }],
    nodes: [
      { mesh: 0, children: [1] },
      { mesh: 0, scale: [-1, 1, 1], rotation: [0, 0, 1, 0] },
    ],
    scenes: [{ nodes: [0] }],
    scene: 0,
  });
  return maker.glb();
}

const MATERIALS = `mtllib a.mtl\n${CUBE_OF_PARTS}\0newmtl most\nKd 1 0 0.5\nmap_Kd -s 1 2 -o 0.5 -clamp on -mm 0 1 a.png\nmap_Bump -bm 0.5 b.png\nrefl -type sphere c.png\nd 0.5\nnewmtl last\nTr 0.1\nPm 1\n`;

const OBJ = [
  TRIANGLE,
  CUBE,
  CUBE_OF_PARTS,
  fan(7),
  grid(3),
  'o a\ng b c\ns 1\nv 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0 # c\nvn 0 0 1\nvt 0 0 0\nf -3/1/1 -2/-1/1 \\\n-1//1\nl 1 2\n',
  '\ufeffv 1e-3 .5 +2.\r\nv 1 0 0\r\nv 0 1 0\r\nf 1/ 2/ 3/\r\n',
];

const TARGETS = {
  obj: OBJ,
  off: [
    TETRAHEDRON,
    binaryOff(false, true),
    binaryOff(true, false),
    'COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n3 0 1 2 0 0 1\n',
  ],
  ply: [...PLY_FORMATS.map(square), ...PLY_FORMATS.map(strips)],
  stl: [binaryStl(trianglesOf(fan(5))), textStl(trianglesOf(fan(3)))],
  gltf: [
    squareGlb(Uint8Array, 4, [0, 1, 2, 0, 2, 3]),
    squareGlb(Uint16Array, 5, [0, 1, 3, 2]),
    squareGlb(Uint32Array, 6, [0, 1, 2, 3]),
  ],
  materials: [MATERIALS],
  unwrap: randomBytes(200),
  flatten: randomBytes(200),
  pack: randomBytes(200),
  verify: [
    ...randomBytes(200),
    ...OBJ.map((text) => `o${text}`),
    ...PLY_FORMATS.map((format) => Buffer.concat([Buffer.from('p'), square(format)])),
  ],
};

function randomBytes(count) {
  const random = randomNumbers(7);
  return Array.from({ length: count }, (_, i) =>
    Buffer.from(Array.from({ length: 16 + 4 * i }, () => Math.floor(256 * random()))),
  );
}

/** Loaded only when needed: the names of targets must be known before packages are installed. */
async function furtherSeeds(target) {
  if (target !== 'gltf') return [];
  const { compressedSeeds } = await import('./compressed-seeds.mjs');
  return compressedSeeds();
}

/** Writes the seeds of a target into a folder. */
export async function writeSeeds(target, folder) {
  mkdirSync(folder, { recursive: true });
  for (const [i, bytes] of [...TARGETS[target], ...(await furtherSeeds(target))].entries())
    writeFileSync(join(folder, `seed-${i}`), bytes);
}

export const TARGET_NAMES = Object.keys(TARGETS);
