// What a tighter bound of the stretch finds is found with a looser one, too: of shapes that unroll
// without stretch into right angles, seams do not get longer when more stretch is allowed.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { ordinaryShapes } from '../support/ordinary-shapes.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { objText } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const SHAPES = ['letter E', 'letter T', 'plate with studs', 'table of five boxes'];
/** Seams are chosen by what they cost, not by their length alone. */
const SLIGHTLY = 1.03;

async function unwrapped(at, maxStretch) {
  const args = ['unwrap', 'in.obj', '-o', 'out.obj', '-q', '--report', 'out.json'];
  const { code, stderr } = await runAbflat([...args, '--max-stretch', maxStretch], { cwd: at() });
  assert.deepEqual([code, stderr], [0, '']);
  const { charts, seams, valid } = JSON.parse(readFileSync(at('out.json'), 'utf8'));
  assert.ok(valid);
  return { charts: charts.length, seam: seams.relativeLength };
}

for (const name of SHAPES)
  test(`${name} is cut no more where more stretch is allowed`, async (t) => {
    const { points, faces } = ordinaryShapes().find((shape) => shape.name === name);
    const at = tempFolder(t);
    writeFileSync(at('in.obj'), objText({ positions: points, faces }));
    const tight = await unwrapped(at, '1.01');
    const usual = await unwrapped(at, '1.02');
    t.diagnostic(JSON.stringify({ tight, usual }));
    assert.ok(usual.charts <= tight.charts);
    assert.ok(usual.seam <= SLIGHTLY * tight.seam);
  });
