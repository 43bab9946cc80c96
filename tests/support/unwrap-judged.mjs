// Unwraps a surface by the native program, and has the file judged by exact arithmetic.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { judgeFile } from './exact-atlas.mjs';
import { runAbflat } from './run-abflat.mjs';
import { objText } from './surfaces.mjs';
import { tempFolder } from './temp-folder.mjs';

/** Resolves to the report and the text of the OBJ, which is valid. */
export async function unwrapJudged(t, surface, ...args) {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), objText(surface));
  const run = await runAbflat(
    ['unwrap', 'in.obj', '-o', 'out.obj', '--report', 'r.json', '--quiet', ...args],
    { cwd: at() },
  );
  assert.deepEqual([run.code, run.stderr], [0, '']);
  assert.ok(judgeFile(at('out.obj')).isValid);
  return {
    report: JSON.parse(readFileSync(at('r.json'), 'utf8')),
    text: readFileSync(at('out.obj'), 'utf8'),
  };
}
