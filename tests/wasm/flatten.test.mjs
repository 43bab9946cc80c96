// What goes in and what comes out.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat, SAMPLE_NAMES } from 'abflat';
import { column, elementOf, PLY_FORMATS, parsePly, plyBytes } from '../support/ply.mjs';
import { binaryStl, textStl } from '../support/stl.mjs';
import {
  bytesOf,
  grid,
  objNumbers,
  objText,
  offText,
  TETRAHEDRON,
  twoGrids,
} from './support/meshes.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

function signedArea(uv, [a, b, c]) {
  const [ux, uy] = [uv[2 * b] - uv[2 * a], uv[2 * b + 1] - uv[2 * a + 1]];
  const [vx, vy] = [uv[2 * c] - uv[2 * a], uv[2 * c + 1] - uv[2 * a + 1]];
  return (ux * vy - uy * vx) / 2;
}

function areas({ uv, indices }) {
  return Array.from({ length: indices.length / 3 }, (_, f) =>
    signedArea(uv, indices.subarray(3 * f, 3 * f + 3)),
  );
}

function surfaceArea({ positions, indices }) {
  let sum = 0;
  for (let c = 0; c < indices.length; c += 3) {
    const [p, q, r] = [0, 1, 2].map((k) => {
      const v = 3 * indices[c + k];
      return [positions[v], positions[v + 1], positions[v + 2]];
    });
    const [d, e] = [q.map((x, i) => x - p[i]), r.map((x, i) => x - p[i])];
    const n = [d[1] * e[2] - d[2] * e[1], d[2] * e[0] - d[0] * e[2], d[0] * e[1] - d[1] * e[0]];
    sum += Math.hypot(...n) / 2;
  }
  return sum;
}

test('a disk of arrays gives a positively oriented layout of the same area', async () => {
  const mesh = grid(12);
  const result = await abflat.flatten(mesh);
  assert.ok(result.uv instanceof Float64Array);
  assert.equal(result.uv.length, (2 * mesh.positions.length) / 3);
  assert.deepEqual(result.indices, mesh.indices);
  assert.deepEqual(
    result.vertexMap,
    Uint32Array.from({ length: 13 ** 2 }, (_, v) => v),
  );
  assert.equal(result.positions, undefined);
  assert.equal(result.obj, undefined);
  const triangles = areas(result);
  assert.ok(triangles.every((area) => area > 0));
  const expected = surfaceArea(mesh);
  const area = triangles.reduce((sum, value) => sum + value, 0);
  assert.ok(Math.abs(area - expected) <= 1e-9 * expected, `${area} instead of ${expected}`);
  assert.equal(result.report.valid, true);
});

test('Float32 positions are the same mesh as their values in Float64', async () => {
  const single = grid(8, Float32Array);
  const double = { ...single, positions: Float64Array.from(single.positions) };
  const [a, b] = [await abflat.flatten(single), await abflat.flatten(double)];
  assert.deepEqual(a.uv, b.uv);
});

test('arrays, OBJ and OFF of one mesh give the same layout', async () => {
  const mesh = grid(8);
  const fromArrays = await abflat.flatten(mesh);
  for (const [name, text] of Object.entries({ 'a.obj': objText(mesh), 'a.off': offText(mesh) })) {
    const result = await abflat.flatten({ bytes: bytesOf(text), name });
    assert.deepEqual(result.uv, fromArrays.uv, name);
    assert.deepEqual(result.indices, mesh.indices, name);
    assert.deepEqual(result.positions, mesh.positions, name);
    assert.equal(result.report.input.path, name);
  }
});

/** The mesh in all file formats; coordinates must be exact in single precision. */
function files(mesh) {
  const points = Array.from({ length: mesh.positions.length / 3 }, (_, v) =>
    Array.from(mesh.positions.subarray(3 * v, 3 * v + 3)),
  );
  const faces = Array.from({ length: mesh.indices.length / 3 }, (_, f) =>
    Array.from(mesh.indices.subarray(3 * f, 3 * f + 3)),
  );
  const triangles = faces.map((face) => face.map((v) => points[v]));
  const xyz = ['x', 'y', 'z'].map((name) => ({ name, type: 'float' }));
  const corners = { name: 'vertex_indices', type: 'int', countType: 'uchar' };
  const elements = [
    { name: 'vertex', properties: xyz, rows: points },
    { name: 'face', properties: [corners], rows: faces.map((face) => [face]) },
  ];
  return {
    ...Object.fromEntries(
      PLY_FORMATS.map((format) => [`${format}.ply`, plyBytes({ format, elements })]),
    ),
    'binary.stl': binaryStl(triangles),
    'text.stl': textStl(triangles),
  };
}

test('PLY and STL of one mesh give the same layout', async () => {
  const mesh = grid(8, Float32Array);
  const fromArrays = await abflat.flatten(mesh);
  for (const [name, bytes] of Object.entries(files(mesh))) {
    const result = await abflat.flatten({ bytes, name });
    if (name.endsWith('ply')) assert.deepEqual(result.uv, fromArrays.uv, name);
    assert.equal(result.report.valid, true);
    assert.equal(result.report.input.vertices, 81);
    const { indices } = await abflat.load({ bytes, name });
    assert.equal(indices.length, mesh.indices.length);
  }
});

test('ply: true gives the file back with the texcoords of the layout', async () => {
  for (const [name, bytes] of Object.entries(files(grid(4, Float32Array)))) {
    const { ply, obj, uv } = await abflat.flatten({ bytes, name }, { ply: true });
    assert.equal(obj, undefined);
    const after = parsePly(Buffer.from(ply));
    assert.equal(after.format, name.endsWith('ply') ? name.slice(0, -4) : PLY_FORMATS[1]);
    assert.deepEqual(column(elementOf(after, 'vertex'), 's', 't').flat(), [...uv], name);
    assert.deepEqual(uv, Float64Array.from(Float32Array.from(uv)), 'single precision');
  }
});

test('the format is found without a name, and bytes may be an ArrayBuffer', async () => {
  const mesh = grid(4);
  const { uv } = await abflat.flatten(mesh);
  const { buffer } = bytesOf(offText(mesh));
  assert.deepEqual((await abflat.flatten({ bytes: buffer })).uv, uv);
});

test('a view of a larger buffer is read from where it begins', async () => {
  const mesh = grid(4);
  const larger = new Float64Array(mesh.positions.length + 20).fill(Number.NaN);
  larger.set(mesh.positions, 10);
  const positions = larger.subarray(10, 10 + mesh.positions.length);
  const result = await abflat.flatten({ ...mesh, positions });
  assert.deepEqual(result.uv, (await abflat.flatten(mesh)).uv);
});

test('vertexMap leads from output vertices to input vertices', async () => {
  const { positions, indices } = grid(5);
  // Two vertices that no triangle uses, before the others.
  const shifted = {
    positions: Float64Array.from([9, 9, 9, 8, 8, 8, ...positions]),
    indices: indices.map((v) => v + 2),
  };
  const result = await abflat.flatten(shifted);
  assert.deepEqual(
    result.indices.map((v) => result.vertexMap[v]),
    shifted.indices,
  );
  assert.equal(result.vertexMap.length, positions.length / 3);
});

test('polygons of a file are triangulated', async () => {
  const text = 'v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 3 0\nv 0 2 0\nf 1 2 3 4 5\n';
  const { indices, positions, report } = await abflat.flatten({
    bytes: bytesOf(text),
    name: 'p.obj',
  });
  assert.equal(indices.length, 9);
  assert.equal(positions.length, 15);
  assert.equal(report.input.faces, 1);
  assert.equal(report.input.triangles, 3);
});

test('obj: true gives the file back with texcoords', async () => {
  const mesh = grid(3);
  const source = `# a comment\n${objText(mesh)}\n`;
  const { obj, uv } = await abflat.flatten(
    { bytes: bytesOf(source), name: 'a.obj' },
    { obj: true },
  );
  const text = new TextDecoder().decode(obj);
  assert.match(text, /^# a comment$/m);
  assert.deepEqual(objNumbers(text, 'vt'), [...uv]);
  assert.deepEqual(objNumbers(text, 'v'), [...mesh.positions]);
});

test('normalize fits arrays, OBJ and PLY into the unit square, with the same shape', async () => {
  const mesh = grid(9);
  const large = { ...mesh, positions: mesh.positions.map((x) => 339 * x - 7) };
  const plain = await abflat.flatten(mesh);
  const options = { normalize: true, obj: true };
  const { uv, obj, report } = await abflat.flatten(large, options);
  assert.ok(report.valid);
  assert.deepEqual([Math.min(...uv), Math.max(...uv)], [0, 1]);
  assert.deepEqual(objNumbers(new TextDecoder().decode(obj), 'vt'), [...uv]);
  const before = areas(plain);
  const after = areas({ ...plain, uv });
  after.forEach((area, f) => {
    assert.ok(area > 0);
    assert.ok(Math.abs(area / before[f] / (after[0] / before[0]) - 1) < 1e-9);
  });
  for (const rounding of [{ ply: true }, { roundsForGltf: true }]) {
    const rounded = await abflat.flatten(large, { normalize: true, ...rounding });
    assert.deepEqual([Math.min(...rounded.uv), Math.max(...rounded.uv)], [0, 1]);
    const rows = [...rounded.uv].map((x, i) => (rounding.ply || i % 2 === 0 ? x : 1 - x));
    assert.deepEqual(rows, rows.map(Math.fround));
  }
  const pins = [0, 1].map((vertex) => ({ vertex, uv: [vertex, 0] }));
  await assert.rejects(abflat.flatten(mesh, { normalize: true, pins }), {
    code: 'InvalidOption',
    message: /pins/,
  });
});

test('obj: true also writes arrays', async () => {
  const mesh = grid(3);
  const { obj, uv } = await abflat.flatten(mesh, { obj: true });
  const text = new TextDecoder().decode(obj);
  assert.deepEqual(objNumbers(text, 'vt'), [...uv]);
  assert.deepEqual(objNumbers(text, 'v'), [...mesh.positions]);
  const corners = text
    .match(/^f .*$/gm)
    .join(' ')
    .match(/\d+\/\d+/g);
  assert.deepEqual(
    corners,
    [...mesh.indices].map((v) => `${v + 1}/${v + 1}`),
  );
});

test('the same call gives the same bytes, on this worker and on another', async () => {
  const mesh = grid(10);
  const first = await abflat.flatten(mesh, { t: 1.1, obj: true });
  const second = await abflat.flatten(mesh, { t: 1.1, obj: true });
  const other = await createAbflat();
  const third = await other.flatten(mesh, { t: 1.1, obj: true });
  other.terminate();
  for (const result of [second, third]) {
    assert.deepEqual(result.uv, first.uv);
    assert.deepEqual(result.obj, first.obj);
    assert.deepEqual(result.report.charts, first.report.charts);
  }
});

test('t bounds the boundary angles', async () => {
  const mesh = grid(6);
  for (const t of [0.95, 1, 1.5]) {
    const { report } = await abflat.flatten(mesh, { t });
    assert.equal(report.options.t, t);
    assert.ok(report.charts[0].maxBoundaryAngle <= t * Math.PI + 1e-9, `t = ${t}`);
  }
});

test('the report has times of every stage, and the total covers them', async () => {
  const file = { bytes: bytesOf(objText(grid(20))), name: 'a.obj' };
  const { timings } = (await abflat.flatten(file, { obj: true })).report;
  const { total, ...stages } = timings;
  const names = ['read', 'connectivity', 'solve', 'layout', 'refine', 'check', 'write'];
  assert.deepEqual(Object.keys(stages).sort(), names.sort());
  assert.ok(Object.values(timings).every((seconds) => seconds >= 0));
  // Clocks in browsers and Node are coarse: a stage may be rounded up.
  const sum = Object.values(stages).reduce((a, b) => a + b, 0);
  assert.ok(total > 0 && total >= sum - 0.001, `${total} is less than ${sum}`);
});

test('inspect tells a disk from what is none', async () => {
  const disk = await abflat.inspect(grid(4));
  assert.deepEqual(disk.disk, { ok: true, code: 'Ok', message: '' });
  assert.equal(disk.faces, 32);
  assert.equal(disk.boundaryEdges, 16);
  const closed = await abflat.inspect(TETRAHEDRON);
  assert.equal(closed.disk.ok, false);
  assert.equal(closed.disk.code, 'ClosedSurface');
  assert.notEqual(closed.disk.message, '');
  const two = await abflat.inspect({ bytes: bytesOf(objText(twoGrids(2))), name: 'two.obj' });
  assert.equal(two.components, 2);
  assert.equal(two.path, 'two.obj');
});

test('load gives the triangles of a file that is no disk', async () => {
  const mesh = twoGrids(3);
  const loaded = await abflat.load({ bytes: bytesOf(offText(mesh)), name: 'two.off' });
  assert.deepEqual(loaded.positions, mesh.positions);
  assert.deepEqual(loaded.indices, mesh.indices);
  const quads = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 4 3 2\n';
  assert.equal((await abflat.load({ bytes: bytesOf(quads), name: 'q.obj' })).indices.length, 12);
});

test('every sample is a disk that flattens', async () => {
  for (const name of SAMPLE_NAMES) {
    const mesh = await abflat.sample(name);
    assert.ok(mesh.positions.length > 0 && mesh.indices.length > 0, name);
    const { disk } = await abflat.inspect(mesh);
    assert.equal(disk.code, 'Ok', `${name}: ${disk.message}`);
  }
});

test('with little memory there is the same layout, and the report says what was missing', async () => {
  const mesh = grid(70);
  const enough = await abflat.flatten(mesh, { t: 2 });
  assert.deepEqual(enough.report.charts[0].fallbacks, []);
  const little = await abflat.flatten(mesh, { t: 2, memory: 1 });
  assert.match(
    little.report.charts[0].fallbacks[0],
    /needs \d.* MB, but only 1 MB are allowed.*multigrid/,
  );
  little.uv.forEach((x, i) => {
    assert.ok(Math.abs(x - enough.uv[i]) < 1e-6);
  });
  await assert.rejects(abflat.flatten(mesh, { memory: 0 }), { code: 'InvalidOption' });
});
