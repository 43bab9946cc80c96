// A random call of bake: a mesh, a layout of it, and images.

import { randomMesh } from './meshes.mjs';
import { isPlain, oddValue, plainly } from './odd-values.mjs';
import { randomOptions } from './options.mjs';

function randomImage(random) {
  if (random.chance(0.05)) return oddValue(random);
  const [width, height] = [1 + random.below(5), 1 + random.below(5)];
  const length = random.chance(0.95) ? 4 * width * height : random.below(30);
  const data = Uint8Array.from({ length }, () => random.below(256));
  return { data: random.chance(0.5) ? data : new Uint8ClampedArray(data), width, height };
}

function randomSource(random) {
  if (random.chance(0.03)) return oddValue(random);
  const out = {};
  const add = (name, make, share = 0.2) => {
    if (random.chance(share)) out[name] = random.chance(0.04) ? oddValue(random) : make();
  };
  const pair = () => [random.between(-3, 3), random.pick([0, 1, -1, 1e300, 0.5])];
  add('image', () => randomImage(random), 0.8);
  add('wrapU', () => random.pick(['repeat', 'mirror', 'clamp', 'stretch']));
  add('wrapV', () => random.pick(['repeat', 'mirror', 'clamp']));
  add('offset', pair);
  add('scale', pair);
  add('rotation', () => random.between(-9, 9));
  add('factor', () => [0, 1, 2, 0.5].map((x) => x * random.next()));
  add('opaque', () => random.chance(0.5));
  return out;
}

/** The layout is that of the mesh, other numbers, or none. */
function randomLayout(random, { texcoords, indices }) {
  if (random.chance(0.05)) return oddValue(random);
  const isArray = ArrayBuffer.isView(texcoords);
  const length = isArray ? Math.min(texcoords.length ?? 6, 6000) : 6;
  const uv = Float64Array.from({ length }, () =>
    random.chance(0.97) ? random.next() : random.pick([1e300, -4, Number.NaN]),
  );
  const layout = { uv: random.chance(0.5) && isArray ? texcoords : uv };
  if (random.chance(0.3)) layout.indices = random.chance(0.9) ? indices : oddValue(random);
  if (random.chance(0.1)) layout.vertexMap = oddValue(random);
  return layout;
}

/** Few meshes have texcoords, which baking needs. */
function withTexcoords(random, mesh) {
  const { positions, texcoords } = plainly(mesh);
  if (texcoords !== undefined || !ArrayBuffer.isView(positions) || random.chance(0.1)) return mesh;
  const length = Math.floor((2 * (positions.length ?? 0)) / 3);
  return { ...plainly(mesh), texcoords: Float64Array.from({ length }, () => random.next()) };
}

export function bakeCall(random, without) {
  const mesh = withTexcoords(random, randomMesh(random));
  const own = plainly(mesh);
  const layout = randomLayout(random, own);
  const count = random.below(4);
  const sources = random.chance(0.5)
    ? randomSource(random)
    : Array.from({ length: count }, () => randomSource(random));
  const given = randomOptions(random, 'bake', without);
  // By default an image may become larger than the memory of these tests.
  const options = isPlain(given) ? { bakeResolution: 16, ...plainly(given) } : given;
  return {
    method: 'bake',
    args: [mesh, options, layout, sources],
    run: (abflat) => abflat.bake(mesh, layout, sources, options),
  };
}
