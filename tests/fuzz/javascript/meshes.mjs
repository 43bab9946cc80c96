// Meshes as callers may hold them: with every kind of array and buffer, some of them broken.

import { Random, randomSurface } from '../../support/random-surfaces.mjs';
import { objText, offText } from '../../wasm/support/meshes.mjs';
import { CallersError, cutOff, detached, oddValue } from './odd-values.mjs';

const REALS = [Float64Array, Float32Array, Array, Int16Array, Int32Array, Int8Array, Uint8Array];
const WHOLE = [Uint32Array, Uint16Array, Uint8Array, Array, Int32Array];

/** The same numbers somewhere inside a larger buffer, which may be shared or resizable. */
function placed(random, array) {
  if (Array.isArray(array)) return array;
  const bytes = array.byteLength + 64;
  const buffer = random.pick([
    () => new ArrayBuffer(bytes),
    () => new SharedArrayBuffer(bytes),
    () => new ArrayBuffer(bytes, { maxByteLength: 2 * bytes }),
  ])();
  const view = new array.constructor(buffer, 8 * random.below(8), array.length);
  view.set(array);
  return view;
}

/** Ways in which one array may be wrong. */
const SPOILS = {
  element(random, array) {
    const values = [Number.NaN, Number.POSITIVE_INFINITY, -1, 0.5, 1e300, 2 ** 32, 2 ** 31, 255, 0];
    if (array.length > 0) array[random.below(array.length)] = random.pick(values);
    return array;
  },
  oddElement(random, array) {
    const plain = Array.from(array);
    plain[random.below(plain.length + 1)] = oddValue(random);
    return plain;
  },
  shorter: (_, array) => array.slice(0, -1),
  longer: (_, array) => array.constructor.from([...array, 1]),
  empty: (_, array) => array.slice(0, 0),
  detached: (_, array) => detached(Float64Array.from(array)),
  cutOff: () => cutOff(Float32Array),
  proxy: (_, array) => new Proxy(array, {}),
  throwing: (_, array) =>
    new Proxy(Array.from(array), {
      get(target, key) {
        if (key === '2') throw new CallersError('of the caller');
        return Reflect.get(target, key);
      },
    }),
  odd: (random) => oddValue(random),
};

function arrayOf(random, values, kinds) {
  const array = random.pick(kinds).from(values);
  return random.chance(0.3) ? placed(random, array) : array;
}

/** Triangles of a random surface, as plain numbers. */
function randomTriangles(random) {
  const { positions, faces } = randomSurface(random);
  const indices = faces.flatMap((face) =>
    face.slice(2).flatMap((v, k) => [face[0], face[k + 1], v]),
  );
  return { positions: positions.flat(), indices };
}

/** { positions, indices } and sometimes more, sound or with one thing wrong. */
function arrayMesh(random) {
  const { positions, indices } = randomTriangles(random);
  const mesh = {
    positions: arrayOf(random, positions, random.chance(0.7) ? REALS.slice(0, 3) : REALS),
    indices: arrayOf(random, indices, random.chance(0.7) ? WHOLE.slice(0, 1) : WHOLE),
  };
  if (random.chance(0.2)) {
    delete mesh.indices;
    mesh.positions = arrayOf(
      random,
      indices.flatMap((v) => positions.slice(3 * v, 3 * v + 3)),
      REALS,
    );
  }
  if (random.chance(0.25)) mesh.texcoords = randomTexcoords(random, mesh.positions.length / 3);
  if (random.chance(0.25)) mesh.materials = randomMaterials(random, indices.length / 3);
  if (random.chance(0.35)) spoil(random, mesh);
  return Object.assign(mesh, normalsFor(indices));
}

function randomTexcoords(random, count) {
  const make = () => (random.chance(0.02) ? Number.NaN : random.between(0, 1));
  return arrayOf(random, Array.from({ length: 2 * count }, make), REALS.slice(0, 3));
}

/** Of corners, for some meshes; takes no random numbers, so that known seeds keep their meaning. */
function normalsFor(indices) {
  if (indices.length % 4 !== 0) return {};
  const random = new Random(indices.length);
  const make = () => (random.chance(0.02) ? Number.NaN : random.between(-1, 1));
  return { cornerNormals: Float32Array.from({ length: 3 * indices.length }, make) };
}

function randomMaterials(random, count) {
  return arrayOf(
    random,
    Array.from({ length: count }, () => random.below(3)),
    WHOLE,
  );
}

function spoil(random, mesh) {
  const name = random.pick(Object.keys(mesh));
  mesh[name] = SPOILS[random.pick(Object.keys(SPOILS))](random, mesh[name]);
  if (random.chance(0.1)) {
    const value = mesh[name];
    const throws = value === undefined || random.chance(0.3);
    const get = () => {
      if (throws) throw new CallersError('of the caller');
      return value;
    };
    Object.defineProperty(mesh, name, { enumerable: true, get });
    return;
  }
  if (random.chance(0.1)) takeAway(mesh, name, random.pick(Object.keys(mesh)));
}

/** Getting one array of the mesh transfers another away. */
function takeAway(mesh, name, other) {
  const [value, taken] = [mesh[name], mesh[other]];
  const get = () => {
    const isLeft = taken?.buffer instanceof ArrayBuffer && taken.buffer.byteLength > 0;
    if (isLeft) detached(taken);
    return value;
  };
  Object.defineProperty(mesh, other, { enumerable: true, get: () => taken });
  Object.defineProperty(mesh, name, { enumerable: true, get });
}

const NAMES = ['mesh.obj', 'mesh.off', 'mesh.ply', 'mesh.stl', 'mesh', '', 'a.glb', 'é\ud800.obj'];

/** { bytes, name }, complete, truncated or with some bytes changed. */
export function fileMesh(random) {
  const text = random.pick([objText, offText])(randomTriangles(random));
  let bytes = new TextEncoder().encode(text);
  if (random.chance(0.2)) bytes = bytes.subarray(0, random.below(bytes.length));
  if (random.chance(0.2) && bytes.length > 0) bytes[random.below(bytes.length)] = random.below(256);
  if (random.chance(0.3)) bytes = placed(random, bytes);
  const mesh = { bytes: random.chance(0.3) ? bytes.slice().buffer : bytes };
  if (random.chance(0.9)) mesh.name = random.chance(0.6) ? 'mesh.obj' : random.pick(NAMES);
  if (random.chance(0.1))
    mesh.bytes = random.chance(0.5) ? detached(bytes.slice()) : oddValue(random);
  if (random.chance(0.05)) mesh.name = oddValue(random);
  return mesh;
}

export function randomMesh(random) {
  if (random.chance(0.03)) return oddValue(random);
  return random.chance(0.75) ? arrayMesh(random) : fileMesh(random);
}
