// The WebAssembly package and the command line program give the same bytes.

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
import { assertSameShape, assertSameText, withoutSeconds } from './support/same.mjs';

const T = [2, 1];

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
  // 1 means written, but not valid, which can happen with a free boundary.
  assert.ok(status === 0 || status === 1, stderr);
  return { obj: readFileSync(out, 'utf8'), report: JSON.parse(readFileSync(report, 'utf8')) };
}

async function assertSame(path, t) {
  const native = flattenNatively(path, t);
  const wasm = await abflat.flatten({ bytes: readFileSync(path), name: path }, { t, obj: true });
  const text = new TextDecoder().decode(wasm.obj);
  assert.match(text, /^vt /m);
  assertSameText(text, native.obj);
  assertSameShape(wasm.report, native.report, 'report');
  assert.deepEqual(wasm.report.input, native.report.input);
  assert.deepEqual(wasm.report.options, native.report.options);
  assert.deepEqual(withoutSeconds(wasm.report.charts), withoutSeconds(native.report.charts));
  assert.equal(wasm.report.valid, native.report.valid);
  return wasm;
}

describe('generated samples', () => {
  for (const name of SAMPLE_NAMES) {
    for (const t of T) {
      test(`${name} at t = ${t}`, async () => {
        const path = join(folder, `${name}.obj`);
        writeFileSync(path, objText(await abflat.sample(name)));
        await assertSame(path, t);
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

test('PLY files are the same, written afresh and from a PLY', async () => {
  const source = join(folder, 'head.obj');
  writeFileSync(source, objText(await abflat.sample('head')));
  for (const path of [source, join(folder, 'first.ply')]) {
    const out = join(folder, path === source ? 'first.ply' : 'second.ply');
    const report = join(folder, 'report.json');
    const args = ['flatten', path, '-o', out, '--report', report, '--quiet'];
    const { status, stderr } = spawnSync(NATIVE, args, { encoding: 'utf8' });
    assert.equal(status, 0, stderr);
    const wasm = await abflat.flatten({ bytes: readFileSync(path), name: path }, { ply: true });
    assert.ok(Buffer.compare(readFileSync(out), wasm.ply) === 0, path);
    const { charts } = JSON.parse(readFileSync(report, 'utf8'));
    assert.deepEqual(withoutSeconds(wasm.report.charts), withoutSeconds(charts));
  }
});

test('positions of an OFF file become the same text, which reads back as the same numbers', async () => {
  const n = 30;
  const positions = [];
  // + 0 because text has no negative zero.
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
  assertSameText(text, native);
  assert.deepEqual(objNumbers(text, 'v'), positions);
  // A layout's texcoords are not round numbers, yet they come back as the package returns them.
  const uv = objNumbers(text, 'vt');
  assert.deepEqual(uv, [...wasm.uv]);
});
