// Pins and straight runs: the package and the command line program give the same bytes.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { plate, objText as surfaceText } from '../support/surfaces.mjs';
import { grid, objText } from './support/meshes.mjs';
import { NATIVE } from './support/paths.mjs';
import { assertSameText, withoutSeconds } from './support/same.mjs';

let abflat;
let folder;
before(async () => {
  assert.ok(existsSync(NATIVE), 'build/native/abflat is missing; run: npm run build:native');
  folder = mkdtempSync(join(tmpdir(), 'abflat-pins-'));
  abflat = await createAbflat();
});
after(() => {
  abflat?.terminate();
  if (folder) rmSync(folder, { recursive: true });
});

/** Runs both on an OBJ text, with files for the program's options, and compares the results. */
async function assertSame(command, text, options, files) {
  const name = (file) => join(folder, file);
  writeFileSync(name('in.obj'), text);
  const args = [command, name('in.obj'), '-o', name('out.obj'), '--report', name('r.json')];
  for (const [option, content] of Object.entries(files)) {
    writeFileSync(name(option), content);
    args.push(`--${option}`, name(option));
  }
  const { status, stderr } = spawnSync(NATIVE, args, { encoding: 'utf8' });
  assert.ok(status === 0 || status === 1, stderr);
  const file = { bytes: readFileSync(name('in.obj')), name: name('in.obj') };
  const result = await abflat[command](file, { ...options, obj: true });
  assertSameText(new TextDecoder().decode(result.obj), readFileSync(name('out.obj'), 'utf8'));
  const { charts } = JSON.parse(readFileSync(name('r.json'), 'utf8'));
  assert.deepEqual(withoutSeconds(result.report.charts), withoutSeconds(charts));
  return result;
}

test('flatten with pins', async () => {
  const pins = [
    { vertex: 0, uv: [0, 0] },
    { vertex: 8, uv: [1.1, 0.05] },
    { vertex: 80, uv: [1, 0.9], face: 127 },
    { vertex: 40, uv: [0.5, 0.45] },
  ];
  const lines = '0 0 0\n8 1.1 0.05\n80 1 0.9 127\n40 0.5 0.45\n';
  const { uv, report } = await assertSame('flatten', objText(grid(8)), { pins }, { pins: lines });
  for (const pin of pins)
    assert.deepEqual([...uv.slice(2 * pin.vertex, 2 * pin.vertex + 2)], pin.uv);
  assert.equal(report.charts[0].pins.count, 4);
  assert.equal(report.valid, true);
});

test('flatten with straight sides', async () => {
  const straight = [
    { from: 0, to: 8 },
    { from: 80, to: 72 },
  ];
  const files = { straight: '0 8\n80 72 # above\n' };
  const { report } = await assertSame('flatten', objText(grid(8)), { straight }, files);
  assert.equal(report.charts[0].straight.vertices, 14);
  assert.ok(report.charts[0].straight.deviation < 1e-8);
});

test('unwrap with pins', async () => {
  const text = surfaceText(plate(1, 3));
  const mesh = { bytes: new TextEncoder().encode(text), name: 'a.obj' };
  const free = await abflat.unwrap(mesh, { minUtilization: 0 });
  // The first chart again, at half its size.
  const [a, b] = [0, 1].map((corner) => free.indices[corner]);
  const place = (v) => [0.3 + free.uv[2 * v] / 8, 0.3 + free.uv[2 * v + 1] / 8];
  const pins = [a, b].map((v) => ({ vertex: free.vertexMap[v], uv: place(v), face: 0 }));
  const lines = pins.map(({ vertex, uv, face }) => `${vertex} ${uv.join(' ')} ${face}\n`).join('');
  const { report } = await assertSame('unwrap', text, { pins }, { pins: lines });
  assert.equal(report.charts.filter((chart) => chart.pins).length, 1);
  assert.equal(report.valid, true);
});
