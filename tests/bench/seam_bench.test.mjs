// The benchmark that draws seams: its picture shows the seams, the surface and its boundary.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { findChrome } from '../../scripts/lib/requirements.mjs';
import { parsePng } from '../support/png.mjs';
import { objText, tube } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const bench = (...args) =>
  spawnSync(process.execPath, ['tests/bench/seam_bench.mjs', ...args], {
    cwd: ROOT,
    encoding: 'utf8',
  });

/** Counts the pixels in a part of the sheet for which `looksLike` holds. */
function count({ width, height, at }, column, row, looksLike) {
  const [w, h] = [width / 3, height / 2];
  let found = 0;
  for (let y = row * h; y < (row + 1) * h; y += 2)
    for (let x = column * w; x < (column + 1) * w; x += 2) if (looksLike(at(x, y))) found++;
  return found;
}

const isRed = ([r, g, b]) => r > 180 && g < 60 && b < 60;
const isBlue = ([r, g, b]) => r < 60 && g < 110 && b > 180;
const isPainted = ([r, g, b]) => r + g + b < 740;

test('a tube that is cut open is drawn with the cut and both ends', {
  skip: findChrome() ? false : 'there is no Chromium',
}, (context) => {
  const path = tempFolder(context);
  writeFileSync(path('tube.obj'), objText(tube(24)));
  const options = ['--max-stretch', '2', '--min-utilization', '0'];
  const { status, stdout, stderr } = bench(path(), path('tube.obj'), '--', ...options);
  assert.equal(status, 0, stdout + stderr);
  assert.match(stdout, /^tube +1 /m);
  const picture = parsePng(readFileSync(path('tube.png')));
  const parts = [0, 1].flatMap((row) => [0, 1, 2].map((column) => [column, row]));
  for (const [column, row] of parts)
    assert.ok(count(picture, column, row, isPainted) > 1000, `${column} ${row}`);
  const [, ...views] = parts;
  const seen = (looksLike) => views.filter((part) => count(picture, ...part, looksLike) > 20);
  assert.ok(seen(isRed).length > 0, 'the cut');
  assert.ok(seen(isRed).length < views.length, 'which the surface hides from the other side');
  assert.equal(seen(isBlue).length, views.length, 'the ends');
  assert.equal(count(picture, 0, 0, isRed), 0, 'outlines of the layout are black');
});

test('without a mesh, or with one that is not there, it says so', () => {
  assert.match(bench().stderr, /Usage: .*FOLDER MESH/);
  assert.match(bench('.', 'nothing.obj').stderr, /There is no file nothing\.obj/);
});
