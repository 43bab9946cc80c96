// Atlases that are not square. Texels are, so charts keep their shapes and distances in texels.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, test } from 'node:test';
import { parseObj } from '../support/atlas.mjs';
import { judge } from '../support/exact-atlas.mjs';
import { parsePng } from '../support/png.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { leastGap, meanShear } from '../support/scene-atlas.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const at = tempFolder({ after });

async function ran(args) {
  const { code, stderr } = await runAbflat(args);
  assert.equal(code, 0, stderr);
}

/** The triangles of an OBJ, each face as a fan. */
function trianglesIn(path) {
  const { positions, texcoords, faces } = parseObj(readFileSync(path, 'utf8'));
  return faces.flatMap((face) =>
    face.slice(2).map((_, k) => {
      const corners = [face[0], face[k + 1], face[k + 2]];
      return {
        object: '',
        places: corners.map(([v]) => positions[v]),
        uv: corners.map(([, t]) => texcoords[t]),
      };
    }),
  );
}

async function sampled(kind) {
  const path = at(`${kind}.obj`);
  await ran(['sample', kind, '-o', path]);
  return path;
}

/** Runs a command for a size, judges what it wrote, and returns the triangles and the report. */
async function laid(command, input, size, more = []) {
  const [output, report] = [at('out.obj'), at('report.json')];
  const resolution = size.join('x');
  await ran([
    command,
    input,
    '-o',
    output,
    '--resolution',
    resolution,
    ...more,
    '--report',
    report,
  ]);
  const triangles = trianglesIn(output);
  const { flipped, flat, outside, overlaps } = judge(triangles.map(({ uv }) => uv));
  assert.deepEqual(
    { flipped, flat, outside, overlaps },
    { flipped: [], flat: [], outside: [], overlaps: [] },
  );
  return { triangles, report: JSON.parse(readFileSync(report, 'utf8')) };
}

const SIZES = [
  [512, 256],
  [256, 512],
  ...(isInstrumented
    ? []
    : [
        [300, 170],
        [768, 96],
      ]),
];

for (const kind of isInstrumented ? ['head'] : ['head', 'three-balls'])
  test(`${kind}: charts of a wide or high atlas keep shapes and distances in texels`, async () => {
    const input = await sampled(kind);
    const square = await laid('unwrap', input, [384, 384]);
    const usual = meanShear(square.triangles, [384, 384]);
    const shares = new Map();
    for (const size of SIZES) {
      const { triangles, report } = await laid('unwrap', input, size, ['--padding', '4']);
      assert.equal(leastGap(triangles, size, 4), 4, `${size}`);
      const shear = meanShear(triangles, size);
      assert.ok(shear < 1.02 * usual, `${size}: ${shear}, not ${usual}`);
      const { atlas } = report;
      assert.deepEqual([atlas.width, atlas.height, atlas.resolution], [...size, Math.max(...size)]);
      assert.deepEqual(report.options.resolution, size);
      assert.ok(Math.abs(report.quasiConformalMean / shear - 1) < 0.02);
      shares.set(`${size}`, atlas.utilization);
    }
    const [wide, high] = [shares.get('512,256'), shares.get('256,512')];
    assert.ok(Math.abs(wide - high) < 0.1, `${wide} and ${high}`);
    assert.ok(wide > square.report.atlas.utilization - 0.15);
  });

test('a width that is the height is the side of a square: the same bytes', async () => {
  const input = await sampled('head');
  const written = [];
  for (const size of ['256', '256x256', '256 X 256']) {
    await ran([
      'unwrap',
      input,
      '-o',
      at('same.obj'),
      '--resolution',
      size,
      '--report',
      at('same.json'),
    ]);
    written.push(readFileSync(at('same.obj'), 'utf8'));
    assert.equal(JSON.parse(readFileSync(at('same.json'), 'utf8')).options.resolution, 256);
  }
  assert.deepEqual(new Set(written).size, 1);
});

test('a texel density, and tiles of that shape', async () => {
  const input = await sampled('three-balls');
  const { report } = await laid('unwrap', input, [512, 256]);
  const density = report.atlas.texelDensity;
  const half = await laid('unwrap', input, [512, 256], ['--texel-density', `${density / 2}`]);
  assert.ok(Math.abs(half.report.atlas.utilization / (report.atlas.utilization / 4) - 1) < 0.05);
  const more = ['--texel-density', `${2 * density}`];
  const none = await runAbflat([
    'unwrap',
    input,
    '-o',
    at('none.obj'),
    '--resolution',
    '512x256',
    ...more,
  ]);
  assert.equal(none.code, 4);
  assert.match(none.stderr, /one tile of 512 x 256 texels.*raise the resolution to \d+ x \d+/);
  await ran([
    'unwrap',
    input,
    '-o',
    at('tiles.obj'),
    '--resolution',
    '512x256',
    ...more,
    '--udim',
    '--report',
    at('tiles.json'),
  ]);
  const { atlas } = JSON.parse(readFileSync(at('tiles.json'), 'utf8'));
  assert.ok(atlas.tiles > 1);
  const triangles = trianglesIn(at('tiles.obj'));
  assert.ok(
    meanShear(triangles, [512, 256]) <
      1.02 * meanShear((await laid('unwrap', input, [512, 512])).triangles, 512),
  );
});

test('pack: islands keep their shapes in texels, those of a square layout as well', async () => {
  const input = await sampled('head');
  await ran(['unwrap', input, '-o', at('square.obj'), '--resolution', '384']);
  await ran(['unwrap', input, '-o', at('wide.obj'), '--resolution', '512x256']);
  const usual = meanShear(trianglesIn(at('square.obj')), 384);
  for (const [name, isNoted] of [
    ['square.obj', true],
    ['wide.obj', false],
  ]) {
    const { triangles, report } = await laid('pack', at(name), [512, 256], ['--padding', '3']);
    assert.ok(report.valid);
    assert.ok(meanShear(triangles, [512, 256]) < 1.001 * usual, name);
    assert.equal(leastGap(triangles, [512, 256], 3), 3);
    assert.equal(
      report.notes.some((note) => /square texture/.test(note)),
      isNoted,
    );
    assert.deepEqual([report.width, report.height, report.resolution], [512, 256, 512]);
    const [flat, solid] = [512 * 256 * report.utilization, report.texelDensity ** 2];
    assert.ok(flat > 0 && solid > 0);
  }
  await ran([
    'pack',
    at('wide.obj'),
    '-o',
    at('kept.obj'),
    '--keep-places',
    '--resolution',
    '512x256',
    '--report',
    at('kept.json'),
  ]);
  const kept = JSON.parse(readFileSync(at('kept.json'), 'utf8'));
  assert.equal(kept.scale, 1);
  assert.equal(
    readFileSync(at('kept.obj'), 'utf8')
      .match(/^vt.*$/gm)
      .join(),
    readFileSync(at('wide.obj'), 'utf8')
      .match(/^vt.*$/gm)
      .join(),
  );
});

test('pictures have a pixel per texel', async () => {
  const input = await sampled('head');
  const drawn = (...pictures) =>
    ran(['unwrap', input, '-o', at('drawn.obj'), '--resolution', '300x170', ...pictures]);
  await drawn('--layout', at('layout.png'), '--heat-map', at('heat.png'));
  for (const name of ['layout.png', 'heat.png']) {
    const { width, height } = parsePng(readFileSync(at(name)));
    assert.deepEqual([width, height], [300, 170]);
  }
  await drawn('--layout', at('layout.svg'));
  const [, width, height, right, bottom] = readFileSync(at('layout.svg'), 'utf8').match(
    /width="([\d.]+)" height="([\d.]+)" viewBox="0 0 ([\d.]+) ([\d.]+)"/,
  );
  assert.deepEqual([width, height], ['300', '170']);
  assert.ok(Math.abs(right / bottom - 300 / 170) < 1e-3);
});

test('pins are places in uv', async () => {
  const input = await sampled('head');
  const places = new Map([
    [0, [0.47, 0.5]],
    [40, [0.5, 0.525]],
  ]);
  writeFileSync(at('pins.txt'), [...places].map((row) => `${row.flat().join(' ')}\n`).join(''));
  const more = ['--pins', at('pins.txt'), '--seams', 'none'];
  await laid('unwrap', input, [600, 500], more);
  const { faces, texcoords } = parseObj(readFileSync(at('out.obj'), 'utf8'));
  for (const [vertex, place] of places) {
    const corners = faces.flat().filter(([v]) => v === vertex);
    assert.ok(corners.length > 0);
    for (const [, t] of corners) assert.deepEqual(texcoords[t].slice(0, 2), place);
  }
});

test('extremes, and sizes that are none', async () => {
  const input = await sampled('head');
  const { triangles } = await laid('unwrap', input, [4096, 64]);
  assert.equal(leastGap(triangles, [4096, 64], 2), 2);
  await laid('unwrap', input, [64, 4096]);
  await laid('unwrap', input, [16, 16], ['--padding', '0']);
  for (const size of [
    '1x1',
    '0',
    '0x512',
    '512x0',
    '-512',
    '-512x512',
    '512x',
    'x512',
    '512x512x512',
    'wide',
    '65536x64',
    '512.5x512',
    '134218240',
    'nan',
    'infx512',
  ]) {
    const { code, stderr } = await runAbflat([
      'unwrap',
      input,
      '-o',
      at('no.obj'),
      `--resolution=${size}`,
    ]);
    assert.equal(code, 2, `${size}: ${stderr}`);
    assert.match(stderr, /--resolution.*at least 16 and at most 32768.*2048x1024/, size);
    assert.equal(stderr.trim().split('\n').length <= 2, true, stderr);
  }
});
