// The WebAssembly package and the command line program give the same layouts.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { createAbflat, SAMPLE_NAMES } from 'abflat';
import { MILD_DISKS } from '../support/shared.mjs';
import { objNumbers, objText } from './support/meshes.mjs';
import { MESHES, NATIVE, NEEDS_MESHES } from './support/paths.mjs';

const T = [2, 1];
/** Of the layout's size. */
const TOLERANCE = 1e-9;

let abflat;
let folder;
before(async () => {
  assert.ok(existsSync(NATIVE), 'build/native/abflat is missing; run: npm run build:native');
  folder = mkdtempSync(join(tmpdir(), 'abflat-native-'));
  abflat = await createAbflat();
});
after(() => {
  abflat?.terminate();
  if (folder) rmSync(folder, { recursive: true });
});

/** The OBJ and the report that the command line program writes. */
function flattenNatively(path, t) {
  const [out, report] = [join(folder, 'out.obj'), join(folder, 'report.json')];
  const args = ['flatten', path, '-o', out, '--t', String(t), '--report', report, '--quiet'];
  const { status, stderr } = spawnSync(NATIVE, args, { encoding: 'utf8' });
  // 1: written, but not valid, as a free boundary may be.
  assert.ok(status === 0 || status === 1, stderr);
  return { obj: readFileSync(out, 'utf8'), report: JSON.parse(readFileSync(report, 'utf8')) };
}

function extentOf(uv) {
  const [us, vs] = [0, 1].map((k) => uv.filter((_, i) => i % 2 === k));
  const extent = (values) =>
    values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b));
  return Math.max(extent(us), extent(vs));
}

/** Moves and turns `uv` onto `target` with the least squared distance. */
function align(uv, target) {
  const count = uv.length / 2;
  const center = (values, k) =>
    values.reduce((sum, x, i) => sum + (i % 2 === k ? x : 0), 0) / count;
  const [from, to] = [uv, target].map((values) => [center(values, 0), center(values, 1)]);
  let [re, im] = [0, 0];
  for (let i = 0; i < uv.length; i += 2) {
    const [x, y] = [uv[i] - from[0], uv[i + 1] - from[1]];
    const [u, v] = [target[i] - to[0], target[i + 1] - to[1]];
    re += x * u + y * v;
    im += x * v - y * u;
  }
  const angle = Math.atan2(im, re);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return uv.map((_, i) => {
    const [x, y] = [uv[i - (i % 2)] - from[0], uv[i - (i % 2) + 1] - from[1]];
    return i % 2 === 0 ? to[0] + c * x - s * y : to[1] + s * x + c * y;
  });
}

const withoutTexcoords = (text) => text.replace(/^vt .*$/gm, 'vt');

/** `isSymmetric`: rounding may decide which of several equally good positions the layout gets. */
async function assertSame(path, t, { isSymmetric = false } = {}) {
  const native = flattenNatively(path, t);
  const wasm = await abflat.flatten({ bytes: readFileSync(path), name: path }, { t, obj: true });
  const text = new TextDecoder().decode(wasm.obj);
  const expected = objNumbers(native.obj, 'vt');
  const found = objNumbers(text, 'vt');
  assert.equal(found.length, expected.length);
  assert.ok(found.length > 0);
  const uv = isSymmetric ? align(found, expected) : found;
  const allowed = TOLERANCE * extentOf(expected);
  const largest = uv.reduce((most, value, i) => Math.max(most, Math.abs(value - expected[i])), 0);
  assert.ok(largest <= allowed, `uv differ by ${largest}, allowed are ${allowed}`);
  assert.equal(withoutTexcoords(text), withoutTexcoords(native.obj));
  assertSameShape(wasm.report, native.report, 'report');
  assert.deepEqual(wasm.report.input, native.report.input);
  assert.deepEqual(wasm.report.options, native.report.options);
  assert.equal(wasm.report.valid, native.report.valid);
  return wasm;
}

/** The same keys in the same order, all the way down; of lists the first entry. */
function assertSameShape(a, b, path) {
  assert.equal(typeof a, typeof b, path);
  if (typeof a !== 'object' || a === null) return;
  if (Array.isArray(a)) {
    assertSameShape(a[0], b[0], `${path}[0]`);
    return;
  }
  assert.deepEqual(Object.keys(a), Object.keys(b), path);
  for (const key of Object.keys(a)) assertSameShape(a[key], b[key], `${path}.${key}`);
}

describe('generated samples', () => {
  for (const name of SAMPLE_NAMES) {
    for (const t of T) {
      test(`${name} at t = ${t}`, async () => {
        const path = join(folder, `${name}.obj`);
        writeFileSync(path, objText(await abflat.sample(name)));
        await assertSame(path, t, { isSymmetric: true });
      });
    }
  }
});

describe('real meshes', () => {
  for (const name of MILD_DISKS) {
    for (const t of T) {
      test(`${name} at t = ${t}`, NEEDS_MESHES, async () => {
        const { report } = await assertSame(join(MESHES, name), t);
        assert.equal(report.charts[0].converged, true);
        assert.equal(report.valid, true);
      });
    }
  }
});

test('positions of an OFF file become the same text, which reads back as the same numbers', async () => {
  const n = 30;
  const positions = [];
  // + 0: text has no negative zero.
  for (let y = 0; y <= n; ++y)
    for (let x = 0; x <= n; ++x)
      positions.push(
        x + Math.sin(y) / 7,
        y + Math.cos(x) / 7,
        Math.sin(x * y + 1) * 10 ** -(x * y) + 0,
      );
  const faces = [];
  for (let y = 0; y < n; ++y)
    for (let x = 0; x < n; ++x) {
      const a = y * (n + 1) + x;
      faces.push(`4 ${a} ${a + 1} ${a + n + 2} ${a + n + 1}`);
    }
  const path = join(folder, 'numbers.off');
  const points = positions.map((x, i) => `${x}${i % 3 === 2 ? '\n' : ' '}`).join('');
  writeFileSync(
    path,
    `OFF\n${positions.length / 3} ${faces.length} 0\n${points}${faces.join('\n')}\n`,
  );
  const native = flattenNatively(path, 2).obj;
  const wasm = await abflat.flatten({ bytes: readFileSync(path), name: path }, { t: 2, obj: true });
  const text = new TextDecoder().decode(wasm.obj);
  assert.equal(withoutTexcoords(text), withoutTexcoords(native));
  assert.deepEqual(objNumbers(text, 'v'), positions);
  // Texcoords of a layout are no round numbers, and come back as what the package returns.
  const uv = objNumbers(text, 'vt');
  assert.deepEqual(uv, [...wasm.uv]);
});
