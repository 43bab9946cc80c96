// The recipe for Ray, with a stand-in for Ray itself: results of all meshes, no more at a time than
// asked for, and errors that can cross processes.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { BUILD } from '../../scripts/lib/paths.mjs';
import { findPython } from '../../scripts/lib/requirements.mjs';
import { RECIPES, run } from './support/batches.mjs';

const SCRIPT = fileURLToPath(new URL('support/with_stand_in.py', import.meta.url));

test('meshes of a generator', async () => {
  const { code, stdout, stderr } = await run(findPython(), [SCRIPT, RECIPES], {
    env: { PYTHONPATH: join(BUILD, 'native/python') },
  });
  assert.equal(code, 0, stderr);
  assert.equal(stdout, 'all done\n');
});
