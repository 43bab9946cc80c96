// Disks from harmless to hostile: the automatic t must always give a valid layout, a fixed t either
// a valid layout or the reason.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { test } from 'node:test';
import { flattened, testGeneratedDisks } from '../support/flattened-disks.mjs';
import { isInstrumented } from '../support/run-abflat.mjs';
import { FOLDED_DISKS, MILD_DISKS, sharedMesh, withoutShared } from '../support/shared.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const BOUNDS = isInstrumented ? [1.5, 0.98] : [2, 1.5, 1.05, 1, 0.98];

testGeneratedDisks(0, isInstrumented ? 10 : 60);

for (const file of [...MILD_DISKS, ...FOLDED_DISKS])
  test(`${file} at fixed and automatic t`, { skip: withoutShared }, async (t) => {
    assert.ok(existsSync(sharedMesh(file)));
    const at = tempFolder(t);
    for (const bound of BOUNDS) await flattened(at, sharedMesh(file), bound);
    const { code } = await flattened(at, sharedMesh(file), 'auto');
    assert.equal(code, 0);
  });
