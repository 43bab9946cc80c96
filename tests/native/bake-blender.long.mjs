// Blender draws a baked mesh as the one before. Skipped where there is no Blender.

import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { parsePng } from '../support/png.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { texturedRing } from '../support/textured-ring.mjs';

const SCRIPT = fileURLToPath(new URL('../support/render-in-blender.py', import.meta.url));
// Its importer of glTF needs numpy, which not every package of Blender brings.
const PROBE = ['-b', '--python-exit-code', '1', '--python-expr', 'import numpy'];
const skip = spawnSync('blender', PROBE).status === 0 ? false : 'there is no Blender with numpy';

function pictures(at, file) {
  const name = `pictures of ${file}`;
  mkdirSync(at(name));
  const args = ['-b', '--factory-startup', '--python-exit-code', '1', '--python', SCRIPT];
  execFileSync('blender', [...args, '--', at(file), at(name)], { stdio: 'pipe' });
  return [0, 1, 2, 3].map((view) => parsePng(readFileSync(at(`${name}/${view}.png`))));
}

/** Whether a pixel and those around it show the mesh. */
function isInside({ at }, x, y) {
  for (let j = y - 2; j <= y + 2; j++)
    for (let i = x - 2; i <= x + 2; i++) if (at(i, j)[3] !== 255) return false;
  return true;
}

/** The mean over pixels away from outlines, and the share of such pixels. */
function difference(before, after) {
  const { width, height } = before;
  let [sum, count] = [0, 0];
  for (let y = 2; y < height - 2; y++)
    for (let x = 2; x < width - 2; x++) {
      if (!isInside(before, x, y) || !isInside(after, x, y)) continue;
      const [was, is] = [before.at(x, y), after.at(x, y)];
      for (let d = 0; d < 3; d++) sum += Math.abs(was[d] - is[d]) / 255 / 3;
      count++;
    }
  return { mean: sum / count, share: count / width / height };
}

test('Blender draws the same before and after', { skip }, async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('before.glb'), texturedRing());
  const before = pictures(at, 'before.glb');
  for (const file of ['after.glb', 'after.obj']) {
    const args = ['unwrap', 'before.glb', '-o', file, '--bake', '--bake-resolution', '2048'];
    const { code, stderr } = await runAbflat(args, { cwd: at() });
    assert.deepEqual([code, stderr], [0, '']);
    const after = pictures(at, file);
    for (const [view, picture] of before.entries()) {
      const { mean, share } = difference(picture, after[view]);
      const [off, seen] = [mean, share].map((part) => (100 * part).toFixed(2));
      t.diagnostic(`${file}, view ${view}: ${off} % off in ${seen} %`);
      assert.ok(share > 0.1, `${share}`);
      assert.ok(mean < 0.01, `${mean}`);
    }
  }
});
