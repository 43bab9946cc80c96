// The benchmark of how layouts look: its table, and that its pictures show what they should.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { parsePng } from '../support/png.mjs';
import { PROGRAM, runAbflat } from '../support/run-abflat.mjs';
import { box, turned } from '../support/shape-builders.mjs';
import { objText } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { Canvas, write } from './support/canvas.mjs';

const bench = (args, env = {}) =>
  spawnSync(process.execPath, ['tests/bench/likeness_bench.mjs', ...args], {
    cwd: ROOT,
    encoding: 'utf8',
    env: { ...process.env, ABFLAT_BIN: PROGRAM, ABFLAT_BIN_BEFORE: '', ...env },
  });

const textOf = ({ points, faces }) => objText({ positions: points, faces });

/** The words of the lines of a table that start with `name`. */
const linesOf = (text, name) =>
  text
    .split('\n')
    .filter((line) => line.startsWith(`${name} `))
    .map((line) => line.trim().split(/ +/));

const picturesIn = (page) =>
  [...page.matchAll(/src="data:image\/png;base64,([^"]+)"/g)].map(([, data]) =>
    parsePng(Buffer.from(data, 'base64')),
  );

function count({ width, at }, [left, top, size], looksLike) {
  let found = 0;
  for (let y = top; y < top + size; y++)
    for (let x = left; x < Math.min(width, left + size); x++) if (looksLike(at(x, y))) found++;
  return found;
}

const isRed = ([r, g, b]) => r > 170 && g < 60 && b < 60;
const isBlue = ([r, g, b]) => r < 80 && g < 110 && b > 150;

test('a tube with its cut and its ends, and a box beside its own layout', async (context) => {
  const path = tempFolder(context);
  const sides = [0, 8].map((y) => [1, y]);
  writeFileSync(path('tube.obj'), textOf(turned(sides, 24)));
  writeFileSync(path('plain.obj'), textOf(box([1, 2, 3])));
  const made = await runAbflat(['unwrap', 'plain.obj', '-o', 'own.obj', '-q'], { cwd: path() });
  assert.equal(made.code, 0);
  const options = ['--out', path('out'), '--max-stretch', '2', '--min-utilization', '0'];
  const run = bench([path('tube.obj'), path('own.obj'), ...options]);
  assert.equal(run.status, 0, run.stdout + run.stderr);
  const [tube] = linesOf(run.stdout, 'tube');
  assert.deepEqual(tube.slice(0, 4), ['tube', 'abflat', '48', '1']);
  assert.deepEqual(
    linesOf(run.stdout, 'own').map((words) => words[1]),
    ['artist', 'abflat'],
  );
  assert.equal(linesOf(run.stdout, 'abflat')[0][1], '2', 'meshes that medians are of');

  const page = readFileSync(path('out/index.html'), 'utf8');
  assert.ok(!/src="(?!data:)|href=/.test(page), 'the page needs no other file');
  const [first, second] = picturesIn(page);
  assert.deepEqual([second.width, second.height], [2 * first.width, first.height]);
  const size = first.height / 2;
  const views = [
    [0, 0],
    [size, 0],
    [0, size],
    [size, size],
  ].map(([x, y]) => [x, y, size]);
  for (const view of views) assert.ok(count(first, view, isBlue) > 50, 'the ends');
  const withCut = views.filter((view) => count(first, view, isRed) > 100);
  assert.ok(withCut.length > 0 && withCut.length < 4, 'the surface hides the cut');
  const { width, height } = parsePng(readFileSync(path('out/montage.png')));
  assert.ok(width > 0 && height > 0);
});

test('two programs are compared', (context) => {
  const path = tempFolder(context);
  writeFileSync(path('box.obj'), textOf(box([1, 2, 3])));
  const run = bench([path('box.obj'), '--out', path('out')], { ABFLAT_BIN_BEFORE: PROGRAM });
  assert.equal(run.status, 0, run.stdout + run.stderr);
  assert.deepEqual(
    linesOf(run.stdout, 'box').map((words) => words[1]),
    ['before', 'after'],
  );
  const [[, ...before], [, ...after]] = ['before', 'after'].map((by) => linesOf(run.stdout, by)[0]);
  // All but the seconds, before the last two.
  const looks = (words) => words.slice(0, -3);
  assert.deepEqual(looks(after), looks(before));
});

test('a mesh that is not there, or an option without its value, is named', () => {
  assert.match(bench(['nothing.obj']).stderr, /There is no file nothing\.obj/);
  assert.match(bench(['--out']).stderr, /--out needs a value/);
  assert.match(bench(['--up', 'x']).stderr, /--up is y or z/);
});

test('a canvas shows what is nearest, and shrinks', () => {
  const square = (z, color, canvas) => {
    canvas.triangle(
      [
        [0, 0, z],
        [8, 0, z],
        [0, 8, z],
      ],
      color,
    );
    canvas.triangle(
      [
        [8, 8, z],
        [8, 0, z],
        [0, 8, z],
      ],
      color,
    );
  };
  const canvas = new Canvas(8, 8);
  square(1, [200, 0, 0], canvas);
  square(0, [0, 200, 0], canvas);
  canvas.line(
    [
      [0, 4, 0.5],
      [7, 4, 0.5],
    ],
    [0, 0, 200],
  );
  canvas.line(
    [
      [0, 6, 1.5],
      [7, 6, 1.5],
    ],
    [0, 0, 0],
  );
  const full = parsePng(canvas.png());
  assert.deepEqual(
    [full.at(3, 4), full.at(3, 6)],
    [
      [200, 0, 0, 255],
      [0, 0, 0, 255],
    ],
  );
  const half = parsePng(canvas.halved().png());
  assert.deepEqual(
    [half.width, half.height, half.at(1, 1), half.at(1, 3)],
    [4, 4, [200, 0, 0, 255], [100, 0, 0, 255]],
  );
});

test('letters and digits have shapes of their own', () => {
  const shapes = [...'abcdefghijklmnopqrstuvwxyz0123456789:.,-_+'].map((letter) => {
    const canvas = new Canvas(3, 5);
    write(canvas, letter, 0, 0, [0, 0, 0], 1);
    return canvas.pixels.toString('hex');
  });
  assert.equal(new Set(shapes).size, shapes.length);
});
