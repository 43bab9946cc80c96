// Outlines that are nearly straight become exactly so: --rectify.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { parseObj } from '../support/atlas.mjs';
import { chartedLayout } from '../support/charted-layout.mjs';
import { judgeFile } from '../support/exact-atlas.mjs';
import { looksOf } from '../support/layout-looks.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { objText, tube } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

/** How the layout of a mesh looks. */
async function looks(t, mesh, ...options) {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), objText(mesh));
  const { code, stderr } = await runAbflat(
    ['unwrap', 'in.obj', '-o', 'out.obj', '-q', ...options],
    { cwd: at() },
  );
  assert.deepEqual([code, stderr], [0, '']);
  const { isValid, ...invalid } = judgeFile(at('out.obj'));
  assert.ok(isValid, JSON.stringify(invalid));
  const layout = chartedLayout(parseObj(readFileSync(at('out.obj'), 'utf8')));
  return looksOf(layout, { withExposed: false });
}

const bulging = tube(24, (z) => 1 + 0.08 * Math.sin(Math.PI * z));
const tapered = tube(24, (z) => 1 - 0.15 * z);

test('the side of a barrel becomes a rectangle', async (t) => {
  const now = await looks(t, bulging);
  assert.equal(now.charts, 1);
  assert.ok(now.axis > 0.99, `${now.axis} of the outline is level`);
  assert.ok(now.sd < 1.02, `a stretch of ${now.sd}`);
});

test('it stays as it comes out when asked', async (t) => {
  const now = await looks(t, bulging, '--rectify', 'never');
  assert.ok(now.axis < 0.9, `${now.axis} of the outline is level`);
});

test('what unrolls without stretch stays exact, unless rectangles are wanted in any case', async (t) => {
  const exact = await looks(t, tapered);
  assert.ok(exact.sd - 1 < 1e-6, `a stretch of ${exact.sd}`);
  const rectangle = await looks(t, tapered, '--rectify', 'always');
  assert.ok(rectangle.axis > 0.99, `${rectangle.axis} of the outline is level`);
});
