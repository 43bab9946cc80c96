// Cuts for packing, on three.js shapes whose few charts would waste much of an atlas.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import * as three from 'three';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

/** The geometry, and the smallest share of the tile that charts must cover: by themselves, since what
 * lies well is not cut in plain sight, and where a little more than the second number is asked for. */
const SHAPES = {
  'box of 12 triangles': [() => new three.BoxGeometry(1, 1, 1), 0.6, 0.6],
  box: [() => new three.BoxGeometry(1, 1, 1, 4, 4, 4), 0.62, 0.62],
  sphere: [() => new three.SphereGeometry(1, 32, 16), 0.45, 0.65],
  'open tube': [() => new three.CylinderGeometry(0.1, 0.1, 6, 24, 100, true), 0.6, 0.6],
  'torus knot': [() => new three.TorusKnotGeometry(1, 0.3, 128, 16), 0.45, 0.5],
  'thin torus': [() => new three.TorusGeometry(1, 0.05, 12, 120), 0.5, 0.5],
  'flat ring': [() => new three.RingGeometry(0.9, 1, 96, 2), 0.4, 0.4],
  dodecahedron: [() => new three.DodecahedronGeometry(1), 0.56, 0.56],
  cone: [() => new three.ConeGeometry(1, 2, 32, 8), 0.5, 0.5],
  // Its side lies level, so what is as long as the tile is wide leaves room above.
  cylinder: [() => new three.CylinderGeometry(1, 1, 2, 32, 8), 0.46, 0.55],
  plane: [() => new three.PlaneGeometry(1, 1, 8, 8), 0.95, 0.95],
};

function objOf(geometry) {
  const { array } = geometry.attributes.position;
  const index =
    geometry.index?.array ?? Uint32Array.from({ length: array.length / 3 }, (_, i) => i);
  const rows = (letter, values, plus) =>
    Array.from(
      { length: values.length / 3 },
      (_, i) => `${letter} ${[0, 1, 2].map((k) => values[3 * i + k] + plus).join(' ')}\n`,
    ).join('');
  return rows('v', array, 0) + rows('f', index, 1);
}

for (const [name, [geometry, least, leastAsked]] of Object.entries(SHAPES))
  test(`auto packs at least as many texels per unit, and fills the tile: ${name}`, async (t) => {
    const at = tempFolder(t);
    writeFileSync(at('in.obj'), objOf(geometry()));
    const unwrapped = async (balance, maxStretch, minUtilization) => {
      const args = ['unwrap', 'in.obj', '-o', 'out.obj', '--report', 'report.json', '--quiet'];
      args.push('--balance', balance, '--max-stretch', maxStretch);
      args.push('--min-utilization', minUtilization);
      const run = await runAbflat(args, { cwd: at() });
      assert.deepEqual([run.code, run.stderr], [0, '']);
      return JSON.parse(readFileSync(at('report.json'), 'utf8'));
    };
    const settings = [
      ['0.2', '1.02'],
      ['0', '1.04'],
    ];
    for (const [balance, maxStretch] of settings.slice(0, isInstrumented ? 1 : 2)) {
      const whole = await unwrapped(balance, maxStretch, '0');
      const cut = await unwrapped(balance, maxStretch, 'auto');
      assert.ok(cut.valid);
      assert.ok(cut.atlas.texelDensity >= whole.atlas.texelDensity);
      assert.equal(cut.charts.length, whole.charts.length + cut.atlas.packingCuts);
      assert.ok(cut.atlas.utilization >= least, `${balance}: ${cut.atlas.utilization}`);
      const asked = await unwrapped(balance, maxStretch, `${Math.min(leastAsked + 0.05, 0.9)}`);
      assert.ok(asked.atlas.utilization >= leastAsked, `asked: ${asked.atlas.utilization}`);
      for (const chart of cut.charts) assert.ok(chart.symmetricDirichlet <= Number(maxStretch));
    }
  });
