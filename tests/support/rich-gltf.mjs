// A glTF with everything that must survive new texcoords.

import { GlbMaker } from './glb.mjs';
import { sphere, torus } from './surfaces.mjs';

const PNG = Buffer.from(
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==',
  'base64',
);
const VERTICES = 34962;
const floats = (rows) => Float32Array.from(rows.flat());
const unit = (p) => p.map((x) => x / Math.hypot(...p));

/** Skinned, with morph targets, colours, and two primitives that share all accessors. */
function addTorus(maker, uv) {
  const { positions, faces } = torus(24, 12);
  const count = positions.length;
  const each = (value) => positions.map((p, i) => value(p, i));
  const [position, normal] = maker.interleaved([floats(positions), floats(each(unit))], 'VEC3');
  Object.assign(maker.json.accessors[position], {
    min: boxMin(positions),
    max: boxMax(positions),
    name: 'places',
  });
  const vertices = (array, type, more) =>
    maker.accessor(array, type, { target: VERTICES, ...more });
  const attributes = {
    POSITION: position,
    NORMAL: normal,
    TANGENT: vertices(floats(each(() => [1, 0, 0, -1])), 'VEC4'),
    COLOR_0: vertices(Uint8Array.from(each((_, i) => [i, 2 * i, 3 * i]).flat()), 'VEC3', {
      normalized: true,
    }),
    JOINTS_0: vertices(Uint8Array.from(each((_, i) => [i % 2, 1 - (i % 2), 0, 0]).flat()), 'VEC4'),
    WEIGHTS_0: vertices(floats(each((_, i) => [i / count, 1 - i / count, 0, 0])), 'VEC4'),
    _CUSTOM: vertices(Uint16Array.from(each((_, i) => 7 * i)), 'SCALAR'),
  };
  if (uv) {
    attributes.TEXCOORD_0 = vertices(floats(each((p) => [p[0] / 4 + 0.5, p[1] / 4 + 0.5])), 'VEC2');
    const half = (x) => Math.round(65535 * (x / 4 + 0.5));
    attributes.TEXCOORD_1 = vertices(
      Uint16Array.from(each((p) => [half(p[0]), half(p[1])]).flat()),
      'VEC2',
      { normalized: true },
    );
  }
  const moved = Uint16Array.from({ length: count / 2 }, (_, i) => 2 * i);
  const shifts = Float32Array.from(moved, () => 0.5);
  const values = Float32Array.from(Array.from(shifts).flatMap((x, i) => [x, i / 100, 0]));
  const more = { min: [0, 0, 0], max: [0.5, Math.fround((moved.length - 1) / 100), 0] };
  const targets = [
    { POSITION: maker.sparse(count, 'VEC3', moved, values, more) },
    {
      POSITION: vertices(floats(each((p) => p.map((x) => x / 2))), 'VEC3', {
        min: boxMin(positions).map((x) => x / 2),
        max: boxMax(positions).map((x) => x / 2),
      }),
    },
  ];
  const middle = 3 * Math.floor(faces.length / 2);
  const indices = Uint16Array.from(faces.flat());
  const primitive = (array, material) => ({
    attributes: { ...attributes },
    targets: targets.map((target) => ({ ...target })),
    indices: maker.accessor(array, 'SCALAR', { target: 34963 }),
    material,
  });
  return {
    name: 'ring',
    primitives: [primitive(indices.slice(0, middle), 0), primitive(indices.slice(middle), 1)],
    weights: [0, 0.5],
    extras: { made: 'by hand' },
  };
}

/** Positions in 16 bits, without indices. */
function addSphere(maker) {
  const { positions, faces } = sphere(4);
  const corners = faces.flatMap(([a, b, c, d]) => [a, b, c, a, c, d].map((v) => positions[v]));
  const rounded = Int16Array.from(corners.flat().map((x) => Math.round(32767 * x)));
  const POSITION = maker.accessor(rounded, 'VEC3', {
    target: VERTICES,
    box: true,
    normalized: true,
  });
  return { name: 'ball', primitives: [{ attributes: { POSITION } }] };
}

/** A closed ring as one strip, and some points. */
function addStrip(maker) {
  const n = 16;
  const ring = Array.from({ length: 2 * n + 2 }, (_, i) => {
    const angle = (2 * Math.PI * (Math.floor(i / 2) % n)) / n;
    return [Math.cos(angle), Math.sin(angle), i % 2];
  });
  const rows = floats(ring);
  const POSITION = maker.accessor(rows, 'VEC3', { target: VERTICES, box: true });
  const indices = Uint8Array.from({ length: 2 * n + 2 }, (_, i) => i % (2 * n));
  return {
    name: 'band',
    primitives: [
      {
        attributes: { POSITION },
        mode: 5,
        indices: maker.accessor(indices, 'SCALAR', { target: 34963 }),
      },
      { attributes: { POSITION }, mode: 0 },
    ],
  };
}

const boxMin = (rows) => [0, 1, 2].map((d) => Math.fround(Math.min(...rows.map((p) => p[d]))));
const boxMax = (rows) => [0, 1, 2].map((d) => Math.fround(Math.max(...rows.map((p) => p[d]))));

/** `uv`: whether the ring has texcoords already. Mesh 1 is scaled by 2, mesh 2 is moved. */
export function richGltf({ uv = true } = {}) {
  const maker = new GlbMaker();
  const { json } = maker;
  json.asset.generator = 'tests';
  json.meshes = [addTorus(maker, uv), addSphere(maker), addStrip(maker)];
  const identity = Float32Array.from({ length: 16 }, (_, i) => (i % 5 === 0 ? 1 : 0));
  const matrices = Float32Array.from([...identity, ...identity]);
  json.skins = [{ joints: [4, 5], inverseBindMatrices: maker.accessor(matrices, 'MAT4') }];
  const input = maker.accessor(Float32Array.of(0, 1), 'SCALAR', { box: true });
  const output = maker.accessor(Float32Array.of(0, 0, 0, 1, 2, 3), 'VEC3');
  json.animations = [
    {
      samplers: [{ input, output }],
      channels: [{ sampler: 0, target: { node: 1, path: 'translation' } }],
    },
  ];
  const image = maker.view(PNG);
  Object.assign(json, {
    images: [{ bufferView: image, mimeType: 'image/png' }],
    textures: [{ source: 0 }],
    materials: [
      {
        name: 'paint',
        ...(uv && { normalTexture: { index: 0 } }),
        extras: { note: [1, 2.5, 'x'] },
      },
      { name: 'plain', extensions: { EXT_unknown: { answer: 42, parts: [0, 1] } } },
    ],
    extensionsUsed: ['KHR_mesh_quantization', 'EXT_unknown'],
    extensionsRequired: ['KHR_mesh_quantization'],
    scene: 0,
    scenes: [{ nodes: [0, 1, 3, 4], extras: { weather: 'fine' } }],
    nodes: [
      { mesh: 0, skin: 0, name: 'skinned' },
      { mesh: 1, scale: [2, 2, 2], children: [2] },
      { mesh: 1, translation: [9, 0, 0], scale: [-1, 1, 1], name: 'mirrored' },
      { mesh: 2, translation: [0, 5, 0] },
      { name: 'joint', children: [5] },
      { name: 'joint 2' },
    ],
  });
  return maker;
}

/** Where the scene places the positions of a mesh of richGltf. */
export const richTransform = (mesh) => (p) =>
  mesh === 1
    ? p.map((x) => (2 * x) / 32767)
    : mesh === 2
      ? p.map((x, d) => (d === 1 ? x + 5 : x))
      : p;
