// Ordinary shapes get valid layouts that look as a person expects: so many charts, seams along
// creases, level outlines.
//
// Not all expectations are met yet; those that are, are listed in met-expectations.json and have to
// stay met. ABFLAT_LOOKS_ALL=1 asks for all; ABFLAT_LOOKS_UPDATE=1 adds those that are met to the
// list.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { after, test } from 'node:test';
import { parseObj } from '../support/atlas.mjs';
import { chartedLayout } from '../support/charted-layout.mjs';
import { judgeFile } from '../support/exact-atlas.mjs';
import { faultsOf } from '../support/layout-expectations.mjs';
import { ordinaryShapes } from '../support/ordinary-shapes.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { objText } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const LIST = new URL('../support/met-expectations.json', import.meta.url);
const MET = JSON.parse(readFileSync(LIST, 'utf8'));
const isSet = (name) => process.env[name] === '1';
const foundMet = structuredClone(MET);

const SHAPES = ordinaryShapes().filter((_, i) => !isInstrumented || i % 8 === 0);

for (const { name, points, faces, expect } of SHAPES)
  test(`${name} unwraps as expected`, async (t) => {
    const at = tempFolder(t);
    writeFileSync(at('in.obj'), objText({ positions: points, faces }));
    const args = ['unwrap', 'in.obj', '-o', 'out.obj', '-q', '--report', 'out.json'];
    const { code, stderr } = await runAbflat(args, { cwd: at() });
    assert.deepEqual([code, stderr], [0, '']);
    const { isValid, ...invalid } = judgeFile(at('out.obj'));
    assert.ok(isValid, JSON.stringify(invalid));

    const charted = chartedLayout(parseObj(readFileSync(at('out.obj'), 'utf8')));
    const { atlas } = JSON.parse(readFileSync(at('out.json'), 'utf8'));
    const faults = faultsOf(expect, charted, atlas);
    const met = MET[name] ?? [];
    foundMet[name] = Object.keys(faults).filter((key) => faults[key] === '' || met.includes(key));
    const asked = isSet('ABFLAT_LOOKS_ALL') ? Object.keys(faults) : met;
    const unmet = asked.filter((key) => faults[key] !== '');
    assert.deepEqual(
      unmet.map((key) => faults[key]),
      [],
    );
  });

test('the list of what is met names only shapes and their expectations', () => {
  const shapes = new Map(ordinaryShapes().map((shape) => [shape.name, shape]));
  for (const [name, keys] of Object.entries(MET))
    for (const key of keys)
      assert.ok(shapes.get(name)?.expect[key] !== undefined, `${name} ${key}`);
});

after(() => {
  if (!isSet('ABFLAT_LOOKS_UPDATE')) return;
  const listed = (keys) => `[${keys.map((key) => JSON.stringify(key)).join(', ')}]`;
  const lines = Object.entries(foundMet).map(([name, keys]) => `  "${name}": ${listed(keys)}`);
  writeFileSync(LIST, `{\n${lines.join(',\n')}\n}\n`);
});
