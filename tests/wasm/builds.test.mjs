// The builds of the module: which one is chosen, and that they agree to the last bit.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { AbflatError, bestBuild, createAbflat, SAMPLE_NAMES } from 'abflat';
import { createAbflatSync } from 'abflat/sync';
import { MILD_DISKS } from '../support/shared.mjs';
import { DIST, MESHES, NEEDS_MESHES } from './support/paths.mjs';

const FILES = { simd: 'abflat-simd.wasm', threads: 'abflat-threads.wasm' };
const BUILDS = Object.keys(FILES);
/** Node runs threads only if it is asked to. */
const BEST = 'simd';

const started = [];
after(() => {
  for (const abflat of started) abflat.terminate();
});

async function start(options) {
  const abflat = await createAbflat(options);
  started.push(abflat);
  return abflat;
}

/** Simulates a runtime without vectors: the probe is the only module that is validated. */
async function withoutVectors(action) {
  const { validate } = WebAssembly;
  WebAssembly.validate = () => false;
  try {
    return await action();
  } finally {
    WebAssembly.validate = validate;
  }
}

test('the fastest build that runs here is the default', async () => {
  assert.equal(bestBuild(), BEST);
  assert.equal((await start()).build, BEST);
});

test('without vector instructions one sentence says what is missing', async () => {
  const refused = {
    name: 'AbflatError',
    code: 'UnsupportedHost',
    lost: null,
    message:
      /^abflat needs WebAssembly with 128-bit vectors \(SIMD\), which is missing here: .*\.$/,
  };
  const wasmUrl = readFileSync(join(DIST, FILES.simd));
  for (const create of [createAbflat, createAbflatSync])
    for (const options of [{}, { build: 'simd' }, { wasmUrl }])
      await withoutVectors(() => assert.rejects(create(options), refused));
  assert.equal((await start()).build, BEST);
});

test('where WebAssembly is switched off the sentence says so', async () => {
  const { WebAssembly: own } = globalThis;
  delete globalThis.WebAssembly;
  try {
    for (const create of [createAbflat, createAbflatSync])
      await assert.rejects(create(), {
        code: 'UnsupportedHost',
        message: /^abflat needs WebAssembly, which is switched off here/,
      });
  } finally {
    globalThis.WebAssembly = own;
  }
});

for (const build of BUILDS) {
  test(`build: '${build}' and its file alone`, async () => {
    assert.equal((await start({ build })).build, build);
    const wasmUrl = pathToFileURL(join(DIST, FILES[build]));
    assert.equal((await start({ wasmUrl })).build, build);
  });
}

const REFUSED = [
  ['an unknown build', { build: 'fast' }, 'InvalidOption', /one of simd, threads.*"fast"/],
  [
    'a build and the file of another',
    { build: 'threads', wasmUrl: join(DIST, FILES.simd) },
    'InvalidOption',
    /build is threads.*abflat-simd\.wasm is simd/,
  ],
];
for (const [what, options, code, pattern] of REFUSED) {
  test(`${what} is refused`, async () => {
    await assert.rejects(createAbflat(options), (error) => {
      assert.ok(error instanceof AbflatError);
      assert.equal(error.code, code);
      assert.match(error.message, pattern);
      return true;
    });
  });
}

test('a module without the label of this package is refused', async () => {
  const { buildOf } = await import(join(DIST, 'base/build-of.js'));
  const empty = await WebAssembly.compile(new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]));
  assert.throws(() => buildOf(empty), { name: 'AbflatError', code: 'UnreadableFile' });
});

describe('all builds give the same bytes', () => {
  let abflats;
  before(async () => {
    abflats = await Promise.all(BUILDS.map((build) => start({ build })));
  });

  const assertSame = async (mesh, options) => {
    const [expected, ...others] = await Promise.all(
      abflats.map((abflat) => abflat.flatten(mesh, { ...options, obj: true, ply: true })),
    );
    assert.ok(expected.uv.length > 0);
    const [{ history }] = expected.report.charts;
    for (const result of others) {
      // Not deepEqual: it takes 0 for -0.
      for (const name of ['uv', 'indices', 'vertexMap', 'obj', 'ply'])
        assert.ok(Buffer.compare(bytesOf(result[name]), bytesOf(expected[name])) === 0, name);
      assert.deepEqual(result.report.charts[0].history, history);
    }
  };

  for (const name of SAMPLE_NAMES) {
    test(name, async () => {
      const [mesh, ...others] = await Promise.all(abflats.map((abflat) => abflat.sample(name)));
      for (const other of others) assert.deepEqual(other, mesh);
      for (const options of [{}, { t: 1 }, { t: 1, linearSolver: 'eigen' }])
        await assertSame(mesh, options);
    });
  }
  for (const name of MILD_DISKS) {
    test(name, NEEDS_MESHES, async () => {
      await assertSame({ bytes: readFileSync(join(MESHES, name)), name }, { t: 1 });
    });
  }
});

const bytesOf = ({ buffer, byteOffset, byteLength }) => Buffer.from(buffer, byteOffset, byteLength);
