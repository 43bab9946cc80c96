// Baking with random material files, images and options: the documented exit code, a sentence or a
// whole result, and never a crash or files that are left behind. ABFLAT_FUZZ_RUNS=2000
// ABFLAT_FUZZ_SEED=1 makes more of them.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { tiling } from '../support/baking.mjs';
import { grey16Png, greyPng, madePng } from '../support/made-png.mjs';
import { Random } from '../support/random-surfaces.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { SCHEMA } from '../support/schema.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { texturedCube } from '../support/textured.mjs';
import { texturedObj } from '../support/textured-obj.mjs';

const RUNS = Number(process.env.ABFLAT_FUZZ_RUNS ?? (isInstrumented ? 8 : 25));
const FIRST = Number(process.env.ABFLAT_FUZZ_SEED ?? 0);
const CODES = new Map(SCHEMA.exitCodes.map(({ name, code }) => [name, code]));

const COLOURS = tiling(32);
const IMAGES = {
  'a.png': COLOURS,
  'b.png': grey16Png(9, 5, (x, y) => 7000 * x + y),
  'c d.png': madePng(16, 8, (x, y) => [x, y, 200, 16 * x]),
  'n.png': madePng(8, 8, () => [140, 120, 250]),
  'bit.png': greyPng(17, 3),
  'torn.png': COLOURS.subarray(0, 300),
  'none.tga': Buffer.from('no image'),
};
const KEYWORDS = [
  ...['map_Kd', 'map_Ka', 'map_Ks', 'map_Ke', 'map_Ns', 'map_d', 'map_Pr', 'map_Pm', 'map_Pc'],
  ...['norm', 'bump', 'map_Bump', 'disp', 'refl', 'decal', 'map_what', 'MAP_KD', 'Kd', 'd'],
];
const OPTIONS = ['-s 2 3', '-s 0 0 0', '-o 0.5', '-clamp on', '-bm 1e9', '-mm 0 1', '-x', '-s nan'];
const NAMES = [...Object.keys(IMAGES), 'lost.png', '../a.png', '', '\\a.png', 'in.mtl'];

function randomMtl(random) {
  const lines = [];
  for (const name of ['one', 'two', 'one', 'three']) {
    if (random.chance(0.8)) lines.push(`newmtl ${name}`);
    for (let i = random.below(5); i > 0; i--) {
      const options = Array.from({ length: random.below(3) }, () => random.pick(OPTIONS));
      lines.push([random.pick(KEYWORDS), ...options, random.pick(NAMES)].join(' '));
    }
  }
  return lines.join(random.pick(['\n', '\r\n', '\r']));
}

function randomObj(random) {
  const cubes = ['one', 'two'].map((material, i) => {
    const cube = texturedCube();
    return { ...cube, positions: cube.positions.map(([x, y, z]) => [x + 5 * i, y, z]), material };
  });
  const text = texturedObj(random.pick(['in.mtl', 'lost.mtl', 'in.mtl in.mtl']), cubes);
  if (random.chance(0.2)) return text.replace(/^vt .*\n/gm, '').replace(/(\d+)\/\d+/g, '$1');
  return random.chance(0.2) ? text.replace(/usemtl two/, 'usemtl') : text;
}

function randomArguments(random) {
  const output = random.pick(['out.obj', 'out.glb', 'out.gltf', 'in.obj', 'out.ply', '-', 'out']);
  const args = [random.pick(['unwrap', 'unwrap', 'pack', 'bake']), 'in.obj', '-o', output];
  if (args[0] !== 'bake') args.push('--bake');
  const add = (option, values) => random.chance(0.3) && args.push(option, `${random.pick(values)}`);
  add('--bake-resolution', [16, 17, 64, 256, 'auto', 15, 9000]);
  add('--image-format', ['png', 'jpeg', 'webp', 'gif']);
  add('--image-quality', [1, 100, 0]);
  add('--padding', [0, 1, 7]);
  return args;
}

/** What is wrong with how a run ended; empty if nothing is. */
function complaint({ code, signal, stderr }, before, after, at) {
  if (signal !== null || ![...CODES.values()].includes(code)) return `ended with ${signal ?? code}`;
  const made = after.filter((name) => !before.includes(name));
  if (made.some((name) => name.startsWith('.abflat-'))) return `left ${made}`;
  if (code > 1) {
    const last = stderr.split('\n').filter((line) => line.startsWith('abflat: '));
    return last.length === 0 || made.length > 0 ? `exit ${code} with ${made}: ${stderr}` : '';
  }
  const mtl = made.find((name) => name.endsWith('.mtl'));
  const images = made.filter((name) => /\.(png|jpg|webp)$/.test(name));
  if (!mtl) return images.length > 0 ? `images without materials: ${made}` : '';
  const text = readFileSync(at(mtl), 'utf8');
  const isUsed = images.every((image) => text.includes(image));
  return isUsed ? '' : `${images} are not in ${text}`;
}

test(`${RUNS} random materials are baked or refused`, async (t) => {
  const problems = [];
  let baked = 0;
  for (let seed = FIRST; seed < FIRST + RUNS; seed++) {
    const random = new Random(seed);
    const at = tempFolder(t);
    for (const [name, content] of Object.entries(IMAGES)) writeFileSync(at(name), content);
    writeFileSync(at('in.mtl'), randomMtl(random));
    writeFileSync(at('in.obj'), randomObj(random));
    const args = randomArguments(random);
    const before = readdirSync(at());
    const end = await runAbflat(args, { cwd: at() });
    const after = readdirSync(at());
    baked += after.some((name) => name === 'out.mtl');
    const problem = complaint(end, before, after, at);
    if (problem) problems.push(`seed ${seed}: ${args.join(' ')}: ${problem}`);
  }
  assert.deepEqual(problems, []);
  assert.ok(baked > 0, 'some are baked');
});
