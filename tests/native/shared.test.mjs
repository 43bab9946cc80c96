// Real meshes, measured by a judge that is independent of the project.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { runAbflat } from '../support/run-abflat.mjs';
import { judge, MILD_DISKS, sharedMesh, withoutShared } from '../support/shared.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const close = (a, b, tolerance) => Math.abs(a - b) <= tolerance * Math.max(1, Math.abs(b));

async function flattened(at, file, t) {
  const args = [
    'flatten',
    sharedMesh(file),
    '-o',
    'out.obj',
    '--t',
    String(t),
    '--report',
    'r.json',
  ];
  const run = await runAbflat(args, { cwd: at() });
  return { ...run, report: JSON.parse(readFileSync(at('r.json'), 'utf8')) };
}

for (const file of MILD_DISKS)
  for (const bound of [2, 1])
    test(`${file} at t = ${bound} is valid and measures as reported`, {
      skip: withoutShared,
    }, async (t) => {
      const at = tempFolder(t);
      const { code, stderr, report } = await flattened(at, file, bound);
      assert.deepEqual([code, stderr], [0, '']);
      const measured = judge(sharedMesh(file), at('out.obj'), bound);
      assert.deepEqual(measured.failures, []);
      assert.equal(measured.valid, true);
      const [chart] = report.charts;
      for (const key of ['angularDistortion', 'lengthDistortion'])
        assert.ok(close(chart[key], measured[key], 1e-6), `${key}: ${chart[key]} ${measured[key]}`);
      assert.ok(close(chart.maxBoundaryAngle, measured.maxBoundaryAngleOverPi * Math.PI, 1e-6));
      assert.ok(close(chart.quasiConformal.max, measured.quasiConformal.max, 1e-4));
    });

test('the crossing of camel-cut.obj at t = 2 is found', { skip: withoutShared }, async (t) => {
  const at = tempFolder(t);
  const { code, stderr, report } = await flattened(at, 'camel-cut.obj', 2);
  assert.equal(code, 1);
  assert.match(stderr, /crosses itself at 1 place/);
  assert.equal(report.charts[0].boundaryCrossings, 1);
  assert.equal(report.charts[0].converged, true);
  assert.equal(judge(sharedMesh('camel-cut.obj'), at('out.obj'), 2).boundaryCrossings, 1);
});

/** What the collection says about meshes that are not disks. */
const OTHERS = [
  ['bunny-closed.off', 'ClosedSurface', /closed surface/],
  ['fertility-genus4.off', 'ClosedSurface', /genus 4/],
  ['halftunnel-quads.off', 'MultipleBoundaryLoops', /3 boundary loops/],
  ['suzanne-quads.obj', 'MultipleComponents', /3 components/],
  ['teapot-5parts.obj', 'MultipleComponents', /5 components/],
  ['beetle-nonmanifold.obj', 'NonManifoldEdge', /edge \d+-\d+ has 3 faces.*47/],
];

for (const [file, status, sentence] of OTHERS)
  test(`${file} is refused as ${status}`, { skip: withoutShared }, async (t) => {
    const { code, stderr, report } = await flattened(tempFolder(t), file, 1);
    assert.equal(code, 4);
    assert.match(stderr, sentence);
    assert.equal(report.error.code, status);
  });
