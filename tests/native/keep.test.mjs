// An existing atlas, kept with --keep, and its size: --texel-density, --udim.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { complaints, parseObj } from '../support/atlas.mjs';
import { chartDensities } from '../support/chart-densities.mjs';
import { parsePly, plyToObj } from '../support/ply.mjs';
import { parsePng } from '../support/png.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { sharedMesh, withoutShared } from '../support/shared.mjs';
import * as surfaces from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

async function unwrapped(at, input, ...options) {
  const args = ['unwrap', input, '-o', 'out.obj', '--report', 'r.json', ...options];
  const run = await runAbflat(args, { cwd: at() });
  if (run.code !== 0) return run;
  const text = readFileSync(at('out.obj'), 'utf8');
  return { ...run, text, report: JSON.parse(readFileSync(at('r.json'), 'utf8')) };
}

/** Texcoords of each corner of each face, as they are. */
const cornersOf = (text) => {
  const { texcoords, faces } = parseObj(text);
  return faces.map((face) => face.map(([, t]) => texcoords[t]));
};

/**
 * Writes before.obj, several objects in one file that has been unwrapped; returns the first one's
 * number of faces.
 */
async function severalObjects(at) {
  const one = surfaces.torus(20, 10);
  const both = surfaces.together([
    [one, [0, 0, 0]],
    [surfaces.sphere(5), [4, 0, 0]],
    [surfaces.sphere(4), [8, 0, 0]],
  ]);
  writeFileSync(at('in.obj'), surfaces.objText(both));
  const { code } = await runAbflat(['unwrap', 'in.obj', '-o', 'before.obj'], { cwd: at() });
  assert.equal(code, 0);
  return one.faces.length;
}

function assertKept(before, { code, stderr, text, report }, isKept) {
  assert.deepEqual([code, stderr], [0, '']);
  assert.deepEqual(complaints(text), []);
  const [old, now] = [before, text].map(cornersOf);
  assert.ok(old.some((_, f) => isKept(f)));
  for (const [f, corners] of old.entries())
    if (isKept(f)) assert.deepEqual(now[f], corners, `face ${f}`);
  assert.equal(report.valid, true);
  for (const { fixed, firstFace, solver } of report.charts) {
    assert.equal(fixed, isKept(firstFace));
    assert.equal(solver === 'given', fixed);
  }
}

test('a part of an atlas is kept, and the rest is packed around it', async (t) => {
  const at = tempFolder(t);
  const faces = await severalObjects(at);
  const before = readFileSync(at('before.obj'), 'utf8');
  writeFileSync(at('keep.txt'), Array.from({ length: faces }, (_, f) => `${f}\n`).join(''));
  const options = ['--keep', 'file=keep.txt', '--padding', '3'];
  const run = await unwrapped(at, 'before.obj', ...options);
  assertKept(before, run, (f) => f < faces);
  assert.ok(run.report.charts.filter((chart) => !chart.fixed).length > 1);
});

test('faces of a file keep their islands; others of the islands need not be named', async (t) => {
  const at = tempFolder(t);
  await severalObjects(at);
  const before = readFileSync(at('before.obj'), 'utf8');
  writeFileSync(at('keep.txt'), '# one face\n0\n\n');
  const run = await unwrapped(at, 'before.obj', '--keep', 'file=keep.txt');
  const fixed = run.report.charts.filter((chart) => chart.fixed);
  assert.equal(fixed.length, 1);
  const [old, now] = [before, run.text].map(cornersOf);
  const same = old.filter((corners, f) => `${corners}` === `${now[f]}`).length;
  assert.ok(same * 2 >= fixed[0].faces, `${same} of ${fixed[0].faces}`);
});

test('uv: what has texcoords keeps them, what is new finds room', async (t) => {
  const at = tempFolder(t);
  const faces = await severalObjects(at);
  const before = readFileSync(at('before.obj'), 'utf8');
  let f = 0;
  const half = before.replaceAll(/^f .*/gm, (line) =>
    f++ < faces ? line : line.replaceAll(/\/\d+/g, ''),
  );
  writeFileSync(at('half.obj'), half);
  assertKept(before, await unwrapped(at, 'half.obj', '--keep', 'uv'), (face) => face < faces);
});

test('what is new has the texel density of what is kept, or less where it does not fit', async (t) => {
  const at = tempFolder(t);
  const ball = surfaces.sphere(5);
  writeFileSync(at('ball.obj'), surfaces.objText(ball));
  assert.equal((await runAbflat(['unwrap', 'ball.obj', '-o', 'uv.obj'], { cwd: at() })).code, 0);
  const old = parseObj(readFileSync(at('uv.obj'), 'utf8'));
  const lineOf = (key, rows) => rows.map((row) => `${key} ${row.join(' ')}\n`).join('');
  const moved = old.positions.map(([x, y, z]) => [x + 4, y, z]);
  const count = old.positions.length;
  for (const size of [0.3, 1]) {
    const texcoords = old.texcoords.map((uv) => uv.map((x) => x * size));
    const kept = old.faces.map((face) => face.map(([v, k]) => `${v + 1}/${k + 1}`));
    const added = old.faces.map((face) => face.map(([v]) => v + 1 + count));
    const lines = [
      ['v', old.positions],
      ['v', moved],
      ['vt', texcoords],
      ['f', kept],
      ['f', added],
    ];
    writeFileSync(at('in.obj'), lines.map((line) => lineOf(...line)).join(''));
    const { code, text, report } = await unwrapped(at, 'in.obj', '--keep', 'uv');
    assert.deepEqual([code, complaints(text)], [0, []]);
    const all = chartDensities(text, 1024).map(({ density }) => density);
    const isKept = report.charts.map(({ fixed }) => fixed);
    const [before, now] = [true, false].map((is) => all.filter((_, i) => isKept[i] === is));
    // Pieces of a chart share its scale, so those of one atlas differ a little.
    const most = Math.max(...before) * 1.01;
    assert.ok(
      now.every((density) => density < most),
      `${now} beside ${before}`,
    );
    // At full size the kept islands leave room for crumbs only.
    const [least] = [...now].sort((a, b) => a - b);
    assert.equal(least > 0.95 * Math.min(...before), size < 1, `${now} beside ${before}`);
    assert.ok(Math.abs(report.atlas.texelDensity / now[0] - 1) < 0.02);
  }
});

test('material: faces of materials keep their uv, those of others are made new', async (t) => {
  const at = tempFolder(t);
  const faces = await severalObjects(at);
  const before = readFileSync(at('before.obj'), 'utf8');
  let f = 0;
  const painted = before.replaceAll(/^f .*/gm, (line) => {
    const material = { 0: 'old wood#2', [faces]: 'new', [faces + 20]: 'metal' }[f++];
    return material ? `usemtl ${material}\n${line}` : line;
  });
  writeFileSync(at('painted.obj'), painted);
  const one = await unwrapped(at, 'painted.obj', '--keep', 'material=old wood#2');
  assertKept(before, one, (face) => face < faces);
  const { code } = await runAbflat(['unwrap', 'painted.obj', '-o', 'painted.glb'], { cwd: at() });
  assert.equal(code, 0);
  const list = 'material=old wood#2,material=new,material=metal';
  assertKept(before, await unwrapped(at, 'painted.obj', '--keep', list), () => true);
  for (const [input, known] of [
    ['painted.obj', /no material 'gold' to keep: the mesh has 'old wood#2', 'new', 'metal'\.\n/],
    ['painted.glb', /no material 'gold' to keep: the mesh has 'old wood#2', 'new', 'metal'\.\n/],
    ['before.obj', /no material 'gold' to keep: the materials of the mesh have no names\.\n/],
  ]) {
    const none = await unwrapped(at, input, '--keep', 'uv,material=gold');
    assert.deepEqual([none.code, known.test(none.stderr)], [2, true], none.stderr);
  }
});

test('PLY keeps the texcoords that it has, in single precision', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), surfaces.objText(surfaces.torus(20, 10)));
  for (const args of [
    ['unwrap', 'in.obj', '-o', 'a.ply'],
    ['unwrap', 'a.ply', '-o', 'b.ply', '--keep', 'uv'],
  ]) {
    const { code, stderr } = await runAbflat(args, { cwd: at() });
    assert.deepEqual([code, stderr], [0, '']);
  }
  const [a, b] = ['a.ply', 'b.ply'].map((name) =>
    cornersOf(plyToObj(parsePly(readFileSync(at(name))))),
  );
  assert.deepEqual(b, a);
});

test('the atlas of a real mesh is kept', { skip: withoutShared }, async (t) => {
  const at = tempFolder(t);
  const spot = await unwrapped(at, sharedMesh('spot-uv.obj'), '--keep', 'uv');
  assert.deepEqual(
    [spot.code, /1\.00065\) is outside the unit square/.test(spot.stderr)],
    [2, true],
  );
  const { text } = await unwrapped(at, sharedMesh('suzanne-quads.obj'));
  writeFileSync(at('before.obj'), text);
  assertKept(text, await unwrapped(at, 'before.obj', '--keep', 'uv'), () => true);
});

test('what cannot be kept is one sentence, and nothing is written', async (t) => {
  const at = tempFolder(t);
  await severalObjects(at);
  const before = readFileSync(at('before.obj'), 'utf8');
  const changed = (change) =>
    before.replaceAll(/^vt (\S+) (\S+)/gm, (_, u, v) => `vt ${change(Number(u), Number(v))}`);
  writeFileSync(
    at('mirrored.obj'),
    changed((u, v) => `${1 - u} ${v}`),
  );
  writeFileSync(
    at('outside.obj'),
    changed((u, v) => `${u + 0.7} ${v}`),
  );
  writeFileSync(at('bad.txt'), '1 2\n');
  writeFileSync(at('many.txt'), '99999\n');
  for (const [input, keep, code, wanted] of [
    ['in.obj', 'uv', 2, /in\.obj: the mesh has no texcoords to keep/],
    ['before.obj', 'all', 2, /--keep: 'all' is not uv, material=NAME or one file=PATH/],
    ['before.obj', 'file=none.txt', 3, /none\.txt/],
    ['before.obj', 'file=bad.txt', 3, /bad\.txt:1: expected a face number, such as '17'/],
    ['before.obj', 'file=many.txt', 2, /face 99999 .* the mesh has only/],
    ['mirrored.obj', 'uv', 2, /mirrored\.obj: face 0's texcoords are mirrored/],
    ['outside.obj', 'uv', 2, /outside\.obj: face \d+'s texcoord .* is outside the unit square/],
  ]) {
    const run = await unwrapped(at, input, '--keep', keep);
    assert.deepEqual([run.code, wanted.test(run.stderr)], [code, true], run.stderr);
  }
  assert.throws(() => readFileSync(at('out.obj')), { code: 'ENOENT' });
});

test('two meshes at one texel density are at one scale, in as many tiles as it takes', async (t) => {
  const at = tempFolder(t);
  const lengthOf = ([a, b]) => Math.hypot(b[0] - a[0], b[1] - a[1], (b[2] ?? 0) - (a[2] ?? 0));
  /** Scale of uv relative to the surface, averaged over all edges. */
  const scaleOf = (text) => {
    const { positions, texcoords, faces } = parseObj(text);
    let [uv, xyz] = [0, 0];
    for (const face of faces)
      for (const [i, [v, at]] of face.entries()) {
        const [w, to] = face[(i + 1) % face.length];
        uv += lengthOf([texcoords[at], texcoords[to]]);
        xyz += lengthOf([positions[v], positions[w]]);
      }
    return uv / xyz;
  };
  const scales = [];
  for (const [name, surface, least] of [
    ['tori.obj', surfaces.together([0, 4, 8].map((x) => [surfaces.torus(24, 12), [x, 0, 0]])), 2],
    ['sphere.obj', surfaces.sphere(6), 1],
  ]) {
    writeFileSync(at(name), surfaces.objText(surface));
    const options = ['--texel-density', '60', '--udim', '--resolution', '512', '--rotate', 'none'];
    const run = await unwrapped(at, name, ...options, '--layout', 'l.png');
    const { tiles, texelDensity, utilization } = run.report.atlas;
    assert.equal(texelDensity, 60);
    assert.ok(tiles >= least && tiles <= 10 && utilization <= 1, `${tiles} tiles`);
    assert.deepEqual(complaints(run.text, tiles), []);
    scales.push(scaleOf(run.text));
    const png = parsePng(readFileSync(at('l.png')));
    assert.deepEqual([png.width, png.height], [512 * tiles, 512]);
    const { texcoords, faces } = parseObj(run.text);
    for (const face of faces) {
      const uv = face.map(([, t]) => texcoords[t]);
      const [x, y] = [0, 1].map((d) => uv.reduce((sum, p) => sum + p[d], 0) / uv.length);
      assert.equal(png.at(Math.floor(512 * x), Math.floor(512 * (1 - y)))[3], 255);
    }
    const svg = await unwrapped(at, name, ...options, '--layout', 'l.svg');
    assert.equal(svg.code, 0);
    assert.match(
      readFileSync(at('l.svg'), 'utf8'),
      new RegExp(`width="${512 * tiles}" height="512" viewBox="0 0 ${100000 * tiles} 100000"`),
    );
  }
  assert.ok(Math.abs(scales[0] / scales[1] - 1) < 0.05, `${scales}`);
});

test('a texel density that does not fit says which would', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), surfaces.objText(surfaces.torus(24, 12)));
  const run = await unwrapped(at, 'in.obj', '--texel-density', '1000', '--resolution', '256');
  assert.equal(run.code, 4);
  const [, density] = run.stderr.match(/do not fit one tile .* Lower the density to (\S+), /);
  const again = await unwrapped(at, 'in.obj', '--texel-density', density, '--resolution', '256');
  assert.equal(again.code, 0);
  assert.deepEqual(complaints(again.text), []);
  // Without automatic seams, the chart is not cut to fit. At the second density, no allowed
  // resolution has room.
  for (const [density, isAllowed] of [
    ['300', true],
    ['9999', false],
  ]) {
    const whole = ['--udim', '--seams', 'none'];
    const huge = await unwrapped(at, 'in.obj', '--texel-density', density, ...whole);
    assert.equal(huge.code, 4);
    const [, less] = huge.stderr.match(
      /does not fit a tile .*Lower the density to (\d[\d.e+-]*\d|\d)/,
    );
    const coarser = ['--texel-density', less, ...whole];
    assert.equal((await unwrapped(at, 'in.obj', ...coarser)).code, 0);
    const side = huge.stderr.match(/raise the resolution to (\d+)/)?.[1];
    assert.equal(side !== undefined, isAllowed, huge.stderr);
    const finer = ['--texel-density', density, ...whole, '--resolution', side ?? '32768'];
    assert.equal((await unwrapped(at, 'in.obj', ...finer)).code, isAllowed ? 0 : 4);
    if (isAllowed)
      assert.equal((await unwrapped(at, 'in.obj', '--texel-density', density, '--udim')).code, 0);
  }
  const none = await unwrapped(at, 'in.obj', '--udim');
  assert.deepEqual([none.code, /--texel-density/.test(none.stderr)], [2, true], none.stderr);
});
