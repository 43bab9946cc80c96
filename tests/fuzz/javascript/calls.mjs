// The call of a seed.

import { createAbflat } from 'abflat';
import { documentMesh, setTexcoords, unwrap as unwrapTransform } from 'abflat/gltf';
import { packGeometry, unwrapGeometry } from 'abflat/three';
import { BufferAttribute, BufferGeometry } from 'three';
import { accessor, addMesh, emptyDocument } from '../../support/gltf.mjs';
import { Random } from '../../support/random-surfaces.mjs';
import { bakeCall } from './bake-call.mjs';
import { fileMesh, randomMesh } from './meshes.mjs';
import { isPlain, oddValue, plainly } from './odd-values.mjs';
import { randomOptions } from './options.mjs';

const METHODS = ['unwrap', 'pack', 'flatten', 'flatten', 'inspect', 'compare', 'load', 'sample'];
const SAMPLES = ['hemisphere', 'wavy-strip', 'three-balls', 'teapot', '', '\0'];

function methodCall(random, without) {
  const method = random.pick(METHODS);
  const first =
    method === 'sample'
      ? random.chance(0.8)
        ? random.pick(SAMPLES)
        : oddValue(random)
      : method === 'load' && random.chance(0.9)
        ? fileMesh(random)
        : randomMesh(random);
  const options = randomOptions(random, method, without);
  return { method, args: [first, options], run: (abflat) => abflat[method](first, options) };
}

/** Array types that those libraries accept as data. */
const STORED = [Float32Array, Uint32Array, Uint16Array, Uint8Array, Int16Array, Int8Array];
const DRAWN = [...STORED, Int32Array, Float64Array];
const isOf = (kinds, values) =>
  ArrayBuffer.isView(values) && kinds.some((Kind) => values instanceof Kind);

const OF_GEOMETRY = { unwrap: unwrapGeometry, pack: packGeometry };

/** A call of abflat/three, whose geometry may lack something it needs. */
const geometryCall = (verb) => (random, without) => {
  const mesh = randomMesh(random);
  const geometry = new BufferGeometry();
  const { positions, indices, texcoords } = plainly(mesh);
  geometry.userData = { self: geometry };
  if (isOf(DRAWN, positions))
    geometry.setAttribute('position', new BufferAttribute(positions, random.pick([3, 3, 2])));
  if (isOf(DRAWN, indices)) geometry.setIndex(new BufferAttribute(indices, 1));
  if (isOf(DRAWN, texcoords)) geometry.setAttribute('uv', new BufferAttribute(texcoords, 2));
  if (random.chance(0.2)) geometry.addGroup(0, 3, random.below(3));
  const options = randomOptions(random, verb, without);
  if (random.chance(0.1) && isPlain(options))
    options.attribute = random.chance(0.5) ? 'uv1' : oddValue(random);
  const given = random.chance(0.95) ? geometry : oddValue(random);
  const run = (abflat) => OF_GEOMETRY[verb](abflat, given, options);
  return { method: `${verb}Geometry`, args: [given, options], run };
};

/** A call of abflat/gltf. */
function documentCall(random, without) {
  const mesh = randomMesh(random);
  const document = emptyDocument();
  const primitive = document.createPrimitive();
  const { positions, indices } = plainly(mesh);
  if (isOf(STORED, positions))
    primitive.setAttribute('POSITION', accessor(document, 'VEC3', positions));
  if (isOf(STORED, indices)) primitive.setIndices(accessor(document, 'SCALAR', indices));
  primitive.setMode(random.pick([4, 4, 4, 5, 6, 1]));
  addMesh(document, 'mesh', primitive);
  const options = randomOptions(random, 'unwrap', without);
  if (isPlain(options)) {
    if (random.chance(0.2))
      options.texcoord = random.pick([0, 1, 'auto', -1, 0.5, oddValue(random)]);
    if (random.chance(0.1)) options.groupBy = random.pick(['mesh', 'primitive', oddValue(random)]);
  }
  const isWhole = random.chance(0.8);
  const run = async (abflat) => {
    if (isWhole) {
      await document.transform(unwrapTransform(abflat, options));
      return {};
    }
    const found = documentMesh(document);
    const result = await abflat.unwrap(found, { roundsForGltf: true });
    setTexcoords(found, result, { texcoord: random.pick([0, 1, 'auto']) });
    return {};
  };
  return { method: 'glTF', args: [mesh, options], run };
}

const SETTINGS = {
  build: (random) => random.pick(['simd', 'threads', 'plain']),
  maxMemory: (random) => random.pick([0, 2 ** 24 - 1, 2 ** 24, 2 ** 25 + 0.5, 2 ** 32, 2 ** 33]),
  baseUrl: () => '/nowhere/dist',
  wasmUrl: () => '/nowhere/abflat-simd.wasm',
  workerUrl: () => 'worker.js',
};

function startCall(random, without) {
  const options = {};
  for (const [name, make] of Object.entries(SETTINGS))
    if (random.chance(0.3)) options[name] = random.chance(0.4) ? oddValue(random) : make(random);
  for (const name of without) delete options[name];
  const given = random.chance(0.95) ? options : oddValue(random);
  const run = async () => {
    const made = await createAbflat(given);
    made.terminate();
    return {};
  };
  return { method: 'createAbflat', args: [undefined, given], run };
}

const MAKERS = [
  ...Array(20).fill(methodCall),
  geometryCall('unwrap'),
  geometryCall('pack'),
  documentCall,
  startCall,
];

/** One seed in so many bakes. */
const BAKING = 16;

/**
 * The calls of a seed, mostly one, sometimes several at once. `without`: options to leave out, to
 * find those that matter.
 */
export function makeCalls(seed, without = []) {
  const random = new Random(seed);
  if (seed % BAKING === BAKING - 1) return [bakeCall(random, without)];
  const count = random.chance(0.9) ? 1 : 3;
  return Array.from({ length: count }, () => random.pick(MAKERS)(random, without));
}
