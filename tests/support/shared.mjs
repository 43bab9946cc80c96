// Real meshes and an independent judge of results, kept beside the project; not everyone has them.

import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { isInstrumented } from './run-abflat.mjs';

const SHARED = join(ROOT, '../shared');
const JUDGE = join(SHARED, 'verify/verify.mjs');

/** Pass this as the `skip` option of a test: false, or the reason to print. */
export const withoutShared = existsSync(JUDGE) ? false : 'there is no ../shared folder';

/** Disks of the collection that are valid at t = 2 and t = 1; with sanitizers without the largest by far. */
export const MILD_DISKS = [
  'nefertiti.off',
  'body.off',
  'cathead.obj',
  'mannequin.off',
  'hemisphere.obj',
  ...(isInstrumented ? [] : ['face.obj']),
  'inspired.obj',
  'woody.obj',
  'nonconvex-cap.off',
];

/** Disks with long boundaries that cross themselves if they are free. */
export const FOLDED_DISKS = ['camel-cut.obj', 'cow-cut.off'];

export const sharedMesh = (file) => join(SHARED, 'meshes', file);

/** What the judge measures in an OBJ result: an object with `valid`, `failures`, `flipped`, ... */
export function judge(input, result, t) {
  const bound = t === undefined ? [] : ['--t', String(t)];
  const { stdout, stderr } = spawnSync(process.execPath, [JUDGE, input, result, ...bound], {
    encoding: 'utf8',
  });
  if (!stdout) throw new Error(`the judge could not read the files: ${stderr}`);
  return JSON.parse(stdout);
}
