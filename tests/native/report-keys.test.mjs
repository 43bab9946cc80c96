// Every key of every report of the program is in the schema, and every key of the schema is in a report.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, test } from 'node:test';
import { drum, objWithGroups, objWithNormals } from '../support/drums.mjs';
import { madePng } from '../support/made-png.mjs';
import { ReportKeys } from '../support/report-keys.mjs';
import {
  EMPTY_IN_UV,
  foldingPins,
  MIRROR_IMAGES,
  NEEDLE,
  overlappingIslands,
  rough,
  stellated,
  TOUCHING,
} from '../support/report-meshes.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { CUBE, CUBE_OF_PARTS, grid } from '../support/small-meshes.mjs';
import { defects, knot, objText, sphere, torus, tube, windows } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { oneTexture, texturedCube, texturedGlb } from '../support/textured.mjs';

const keys = new ReportKeys('cli');

/** Runs a command on the mesh with these additional files, and checks its report. */
async function run(t, struct, command, mesh, options = [], files = {}) {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), mesh);
  for (const [name, text] of Object.entries(files)) writeFileSync(at(name), text);
  const args = [command, 'in.obj', '-o', 'out.obj', '--report', 'r.json', ...options];
  const { stderr } = await runAbflat(args, { cwd: at() });
  const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  const results = report.charts?.length ?? report.islands;
  assert.equal('error' in report, !('valid' in report && results > 0), stderr);
  keys.check(report, struct);
  return report;
}

async function sampleText(t, name) {
  const at = tempFolder(t);
  await runAbflat(['sample', name, '-o', 'in.obj'], { cwd: at() });
  return readFileSync(at('in.obj'), 'utf8');
}

const textOf = (pins) => pins.map(({ vertex, uv }) => `${vertex} ${uv.join(' ')}\n`).join('');

const flatten = (t, ...rest) => run(t, 'Report', 'flatten', ...rest);
const unwrap = (t, ...rest) => run(t, 'UnwrapReport', 'unwrap', ...rest);

test('flatten: bounds, the Delaunay condition, edges that resist it', async (t) => {
  const bounds = { bounds: '0 0.6\n3 0.9\n' };
  await flatten(t, await sampleText(t, 'head'), ['--t', '1', '--delaunay']);
  await flatten(t, grid(6), ['--bounds', 'bounds'], bounds);
  await flatten(t, stellated(), ['--t', '1', '--delaunay']);
  await flatten(t, rough(2), ['--t', '1']);
  await flatten(t, NEEDLE);
});

test('flatten: pins, straight runs, refining and what limits it', async (t) => {
  const pins = { pins: '0 0.1 0.2\n6 0.7 0.3\n48 0.8 0.9\n42 0.05 0.85\n' };
  await flatten(t, grid(6), ['--pins', 'pins'], pins);
  const straight = { straight: '0 6\n48 42\n' };
  await flatten(t, grid(6), ['--straight', 'straight', '--balance', '0.5'], straight);
});

test('flatten: fallbacks, research solvers, a layout that is not valid', async (t) => {
  await flatten(t, grid(70), ['--t', '2', '--memory', '1M']);
  await flatten(t, grid(6), ['--linear-solver', 'minres', '--t', '1']);
  await flatten(t, await sampleText(t, 'alpha-band'), ['--t', '2', '--untangle', 'none']);
  const folding = { pins: textOf(foldingPins(4)) };
  await flatten(t, grid(4), ['--pins', 'pins'], folding);
});

test('flatten and unwrap: no result', async (t) => {
  await flatten(t, CUBE);
  await flatten(t, 'v 0 0\n');
  await unwrap(t, 'f 1 2 3\n');
});

test('unwrap: everything that is repaired, and notes', async (t) => {
  await unwrap(t, objText(defects()));
  await unwrap(t, objText(defects()), ['--orient']);
  await unwrap(t, NEEDLE);
  await unwrap(t, TOUCHING);
  await unwrap(t, objText(knot()), ['--straight-seams', '--max-stretch', '1.02']);
});

test('unwrap: holes, pins, parts that stay, cuts for packing', async (t) => {
  await unwrap(t, objText(windows(3)), ['--balance', '1']);
  await unwrap(t, objText(tube(40, () => 0.3)), ['--min-utilization', '0.7']);
  await unwrap(t, MIRROR_IMAGES, ['--stack', 'mirrored']);
  const pins = { pins: '0 0.1 0.2\n6 0.4 0.2\n' };
  await unwrap(t, grid(6), ['--pins', 'pins', '--memory', '1M'], pins);
  const folding = { pins: textOf(foldingPins(4)) };
  await unwrap(t, grid(4), ['--pins', 'pins'], folding);
  await unwrap(t, objText(sphere()), ['--memory', '1M', '--symmetric-seams', 'always']);
});

test('pack: stacks, islands that overlap or are mirrored, faces without texcoords', async (t) => {
  await run(t, 'PackReport', 'pack', overlappingIslands());
  await run(t, 'PackReport', 'pack', CUBE);
  for (const mesh of [overlappingIslands(), EMPTY_IN_UV])
    await run(t, 'PackReport', 'pack', mesh, ['--keep-places']);
});

test('unwrap, pack and bake: textures in a new layout', async (t) => {
  const cube = texturedCube();
  // The last side has no second set.
  const parts = [
    { ...cube, uv1: cube.uv, triangles: cube.triangles.slice(0, 10) },
    { ...cube, triangles: cube.triangles.slice(10) },
  ];
  const { images, ...json } = oneTexture(madePng(16, 16, (x, y) => [16 * x, 16 * y, 128]));
  const at = tempFolder(t);
  writeFileSync(at('in.glb'), texturedGlb(parts, { images, ...json }));
  for (const [struct, command, ...options] of [
    ['UnwrapReport', 'unwrap', '--bake', '--image-format', 'jpeg'],
    ['PackReport', 'pack', '--bake'],
    ['BakeReport', 'bake', '--threads', '1'],
  ]) {
    const args = [command, 'in.glb', '-o', 'out.glb', '--report', 'r.json', ...options];
    const { code, stderr } = await runAbflat(args, { cwd: at() });
    assert.deepEqual([code, stderr], [0, '']);
    keys.check(JSON.parse(readFileSync(at('r.json'), 'utf8')), struct);
  }
  writeFileSync(at('in.glb'), texturedGlb([cube], { images, ...json }));
  await runAbflat(['bake', 'in.glb', '-o', 'out.glb', '--report', 'r.json'], { cwd: at() });
  keys.check(JSON.parse(readFileSync(at('r.json'), 'utf8')), 'BakeReport');
});

test('inspect', async (t) => {
  const shaded = [objWithNormals(drum()), objWithGroups(drum())];
  for (const mesh of [CUBE_OF_PARTS, NEEDLE, ...shaded, objText(torus()), objText(defects())]) {
    const at = tempFolder(t);
    writeFileSync(at('in.obj'), mesh);
    const { stdout } = await runAbflat(['inspect', 'in.obj', '--json'], { cwd: at() });
    keys.check(JSON.parse(stdout), 'MeshSummary');
  }
});

test('compare', async (t) => {
  const at = tempFolder(t);
  for (const mesh of [await sampleText(t, 'alpha-band'), rough(2)]) {
    writeFileSync(at('in.obj'), mesh);
    const { stdout } = await runAbflat(['compare', 'in.obj', '--json', '-'], { cwd: at() });
    keys.check(JSON.parse(stdout), 'ComparisonReport');
  }
});

after(() => {
  const unseen = keys.unseen(
    'Report',
    'UnwrapReport',
    'PackReport',
    'BakeReport',
    'ComparisonReport',
  );
  assert.deepEqual(unseen, [], 'fields that no report has');
});
