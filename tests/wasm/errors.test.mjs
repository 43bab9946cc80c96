// However a call fails, the error says what is wrong, and the next call works.

import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { AbflatError, createAbflat, STATUS_NAMES } from 'abflat';
import { bytesOf, grid, objText, TETRAHEDRON, twoGrids } from './support/meshes.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

const isSentence = (message) => message.length > 10 && /\s/.test(message);

/** `lost`: the part of abflat that is missing. */
async function assertFails(call, code, pattern = /./, lost = null) {
  await assert.rejects(call, (error) => {
    assert.ok(error instanceof AbflatError, `${error}`);
    assert.ok(error instanceof Error);
    assert.equal(error.name, 'AbflatError');
    assert.equal(error.code, code, error.message);
    assert.ok(STATUS_NAMES.includes(error.code));
    assert.ok(isSentence(error.message), error.message);
    assert.match(error.message, pattern);
    assert.equal(error.lost, lost, error.message);
    return true;
  });
}

async function assertStillWorks() {
  assert.equal((await abflat.flatten(grid(2))).report.valid, true);
}

const file = (text, name = 'mesh.obj') => ({ bytes: bytesOf(text), name });
const triangle = {
  positions: new Float64Array([0, 0, 0, 1, 0, 0, 0, 1, 0]),
  indices: new Uint32Array([0, 1, 2]),
};
const fourFaces = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\n';

const REFUSED = [
  ['two components', twoGrids(2), 'MultipleComponents', /2/],
  ['a closed surface', TETRAHEDRON, 'ClosedSurface'],
  ['no faces', { positions: triangle.positions, indices: new Uint32Array(0) }, 'EmptyMesh'],
  ['a repeated vertex', { ...triangle, indices: new Uint32Array([0, 1, 1]) }, 'DegenerateFace'],
  [
    'an index out of range',
    { ...triangle, indices: new Uint32Array([0, 1, 3]) },
    'InvalidMesh',
    /3/,
  ],
  [
    'a coordinate that is not finite',
    { ...triangle, positions: new Float32Array([0, 0, 0, 1, Number.NaN, 0, 0, 1, 0]) },
    'InvalidMesh',
    /1/,
  ],
  ['an edge with three faces', file(`${fourFaces}f 1 2 3\nf 1 2 4\nf 2 1 5\n`), 'NonManifoldEdge'],
  [
    'faces of opposite orientation',
    file(`${fourFaces}f 1 2 3\nf 1 2 5\n`),
    'InconsistentOrientation',
  ],
  ['a line that is no number', file('v 0 0 0\nv 1 x 0\n'), 'ParseError', /mesh\.obj.*2/s],
  ['a truncated OFF', file('OFF\n3 1 0\n0 0 0\n', 'mesh.off'), 'ParseError', /mesh\.off/],
  ['an unknown format', file('hello', 'mesh.xyz'), 'UnreadableFile', /mesh\.xyz/],
];

for (const [what, mesh, code, pattern] of REFUSED) {
  test(`${what}: ${code}`, async () => {
    await assertFails(abflat.flatten(mesh), code, pattern);
    await assertStillWorks();
  });
}

test('t that cannot be met: InfeasibleBound with the least t', async () => {
  await assertFails(abflat.flatten(triangle, { t: 0.1 }), 'InfeasibleBound', /0\.33/);
  await assertStillWorks();
});

const OPTIONS = [
  [{ T: 1 }, /"?T"?/],
  [{ t: Number.NaN }, /t/],
  [{ t: Number.POSITIVE_INFINITY }, /t/],
  [{ t: 0 }, /above 0/],
  [{ t: -1 }, /above 0/],
  [{ t: '1' }, /t/],
  [{ untangle: 'sideways' }, /untangle must be one of/],
  [{ bounds: [{ vertex: -1, t: 1 }] }, /bounds\[0\]\.vertex/],
  [{ bounds: [{ vertex: 1, t: 0 }] }, /bounds\[0\]\.t must be a number above 0/],
  [{ straight: 5 }, /straight must be an array/],
  [{ straight: [{ from: 0 }] }, /straight\[0\]\.to must be a vertex number/],
  [{ straight: [{ from: 0, to: 0 }] }, /begins and ends at vertex 0/],
  [{ pins: {} }, /pins must be an array/],
  [{ pins: [null] }, /pins\[0\]\.vertex/],
  [{ pins: [{ vertex: 0 }] }, /pins\[0\]\.uv must be an array of two numbers/],
  [{ pins: [{ vertex: 0, uv: [1] }] }, /pins\[0\]\.uv must be an array of two numbers/],
  [{ pins: [{ vertex: 0, uv: [0, Number.NaN] }] }, /pins\[0\]\.uv\[1\] must be a number that/],
  [{ pins: [{ vertex: 0, uv: [0, 0], face: -1 }] }, /pins\[0\]\.face/],
  [{ pins: [{ vertex: 0, uv: [0, 0] }] }, /vertex 0 is the only pinned vertex/],
  [{ t: null }, /t/],
  [{ obj: 'yes' }, /obj/],
  [{ ply: 1 }, /ply/],
  [{ transfer: 1 }, /transfer/],
  [{ onProgress: true }, /onProgress/],
  [{ signal: {} }, /signal/],
];

for (const [options, pattern] of OPTIONS) {
  test(`the options ${JSON.stringify(options)}: InvalidOption`, async () => {
    await assertFails(abflat.flatten(triangle, options), 'InvalidOption', pattern);
  });
}

test('options of flatten are unknown to inspect', async () => {
  await assertFails(abflat.inspect(triangle, { t: 1 }), 'InvalidOption', /t/);
});

const NO_MESHES = [
  [undefined, /mesh|positions/],
  [null, /mesh|positions/],
  ['mesh.obj', /mesh|positions/],
  [{}, /positions/],
  [
    { positions: 'v 0 0 0', indices: [0, 1, 2] },
    /positions must be an array.*Float32Array.*String/,
  ],
  [{ positions: [[0, 0, 0]], indices: [0, 0, 0] }, /positions\[0\] must be a number, not Array/],
  [{ positions: new Float64Array(9), indices: new Float32Array(3) }, /indices.*Uint32Array/],
  [{ positions: new Float64Array(9), indices: [0, 1, 1.5] }, /indices\[2\].*whole.*1\.5/],
  [{ positions: new Float64Array(9), indices: Int32Array.of(0, -1, 2) }, /indices\[1\].*-1/],
  [{ positions: new Float64Array(12) }, /Without indices, every three vertices.*4 vertices/],
  [{ positions: new Float64Array(10), indices: new Uint32Array(3) }, /positions.*3/],
  [{ positions: new Float64Array(9), indices: new Uint32Array(4) }, /indices.*3/],
  [{ ...triangle, texcoords: [0, 0] }, /texcoords has 2 elements, not 6/],
  [{ ...triangle, texcoords: 'uv' }, /texcoords.*Float/],
  [{ ...triangle, texcoords: new Float32Array(5) }, /texcoords has 5 elements, not 6/],
  [{ ...triangle, normals: [0, 0, 1] }, /normals has 3 elements, not 9: 3 per vertex/],
  [{ ...triangle, normals: 'up' }, /normals.*Float/],
  [{ ...triangle, cornerNormals: new Float32Array(8) }, /cornerNormals has 8 elements, not 9/],
  [{ ...triangle, materials: new Float32Array(1) }, /materials.*Uint32Array/],
  [{ ...triangle, materials: [-1] }, /materials\[0\].*-1/],
  [{ ...triangle, materials: new Uint32Array(2) }, /materials has 2 elements, not 1/],
  [{ ...triangle, vertexObjects: [0, 0] }, /vertexObjects has 2 elements, not 3: 1 per vertex/],
  [{ bytes: 'v 0 0 0' }, /bytes/],
  [{ bytes: new Uint8Array(1), name: 5 }, /name/],
];

for (const [mesh, pattern] of NO_MESHES) {
  test(`${JSON.stringify(mesh)} is no mesh: InvalidMesh`, async () => {
    await assertFails(abflat.flatten(mesh), 'InvalidMesh', pattern);
    await assertFails(abflat.inspect(mesh), 'InvalidMesh', pattern);
  });
}

test('an unknown sample: InvalidOption with the known ones', async () => {
  await assertFails(abflat.sample('teapot'), 'InvalidOption', /teapot.*hemisphere/);
});

test('load refuses what is no file', async () => {
  await assertFails(abflat.load(triangle), 'InvalidMesh', /bytes|file/);
  await assertFails(abflat.load(file('f 1 2 3\n')), 'ParseError', /mesh\.obj/);
});

test('glTF is refused with the entries that take it', async () => {
  const binary = { bytes: Uint8Array.of(0x67, 0x6c, 0x54, 0x46, 2, 0, 0, 0), name: 'model' };
  for (const mesh of [binary, { bytes: binary.bytes.buffer }, file('{}', 'model.gltf')])
    for (const method of ['unwrap', 'flatten', 'inspect', 'load'])
      await assertFails(
        abflat[method](mesh),
        'UnreadableFile',
        /is a glTF.*abflat\/gltf.*abflat\/three/,
      );
});

test('inspect describes what flatten refuses, with the same code and words', async () => {
  for (const [, mesh, code] of REFUSED.slice(0, 4)) {
    const { disk } = await abflat.inspect(mesh);
    assert.equal(disk.code, code);
    await assertFails(abflat.flatten(mesh), code, new RegExp(literal(disk.message)));
  }
});

function literal(text) {
  return text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
}

test('unknown settings of createAbflat: InvalidOption', async () => {
  await assertFails(createAbflat({ memory: 1 }), 'InvalidOption', /memory/);
  await assertFails(createAbflat({ maxMemory: -1 }), 'InvalidOption', /maxMemory/);
  await assertFails(createAbflat({ maxMemory: 1 }), 'InvalidOption', /maxMemory/);
  await assertFails(createAbflat({ maxMemory: 2 ** 40 }), 'InvalidOption', /maxMemory/);
});

test('a wrong wasmUrl: UnreadableFile that names it', async () => {
  const assertMissing = (wasmUrl, pattern) =>
    assertFails(createAbflat({ wasmUrl }), 'UnreadableFile', pattern, 'module');
  await assertMissing('/nowhere/abflat-simd.wasm', /nowhere/);
  await assertMissing(new URL('./errors.test.mjs', import.meta.url), /errors\.test\.mjs/);
});

test('a wrong workerUrl: UnreadableFile', async () => {
  const call = createAbflat({ workerUrl: '/nowhere/worker.js' });
  await assertFails(call, 'UnreadableFile', /nowhere/, 'worker');
});

const CRASHES = [
  ['ends', 'process.exit(3);'],
  ['throws while it is loaded', 'throw new Error("boom");'],
  [
    'throws when it is called',
    `require('node:worker_threads').parentPort.on('message', () => { throw new Error('boom'); });`,
  ],
];

for (const [what, script] of CRASHES) {
  test(`a worker that ${what}: Internal, no hung promise`, async () => {
    const folder = mkdtempSync(join(tmpdir(), 'abflat-crash-'));
    try {
      const workerUrl = join(folder, 'worker.cjs');
      writeFileSync(workerUrl, script);
      await assertFails(createAbflat({ workerUrl }), 'Internal', /boom|3/, 'stopped');
    } finally {
      rmSync(folder, { recursive: true });
    }
  });
}

test('memory that does not suffice: OutOfMemory, and smaller meshes still work', async () => {
  const small = await createAbflat({ maxMemory: 32 * 2 ** 20 });
  const large = grid(220);
  for (const mesh of [large, { bytes: bytesOf(objText(large)), name: 'large.obj' }]) {
    await assertFails(small.flatten(mesh), 'OutOfMemory', /32 MB/);
    assert.equal((await small.flatten(grid(4))).report.valid, true);
  }
  small.terminate();
});

test('a mesh that does not even fit in: OutOfMemory', async () => {
  const small = await createAbflat({ maxMemory: 16 * 2 ** 20 });
  const mesh = { ...triangle, positions: new Float64Array(3e6) };
  await assertFails(small.flatten(mesh), 'OutOfMemory');
  await assertFails(small.inspect(mesh), 'OutOfMemory');
  assert.equal((await small.inspect(triangle)).disk.ok, true);
  small.terminate();
});

test('wherever memory gives out: a result or OutOfMemory, and the next call works', async () => {
  const mesh = grid(100);
  const outcomes = new Set();
  for (let megabytes = 16; megabytes <= 64; megabytes += 4) {
    const limited = await createAbflat({ maxMemory: megabytes * 2 ** 20 });
    const outcome = await limited.flatten(mesh).then(
      ({ report }) => report.valid,
      ({ code }) => code,
    );
    assert.ok(outcome === true || outcome === 'OutOfMemory', `${outcome} with ${megabytes} MB`);
    outcomes.add(outcome);
    assert.equal((await limited.flatten(grid(2))).report.valid, true);
    limited.terminate();
  }
  assert.equal(outcomes.size, 2);
});
