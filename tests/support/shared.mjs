// Real meshes and an independent judge of results, kept beside the project; not everyone has them.

import { existsSync, readFileSync } from 'node:fs';
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

export const sharedFinding = (file) => join(SHARED, 'findings', file);

class Exit extends Error {}

/** The judge's script as a function: a process of its own for each result takes longer than judging it. */
const compiled = () => {
  const text = readFileSync(JUDGE, 'utf8')
    .replace(/^#!.*/, '')
    .replace("import { readFileSync } from 'node:fs';", '');
  return new Function('process', 'console', 'readFileSync', text);
};
let script;

/** What the judge measures in an OBJ result: an object with `valid`, `failures`, `flipped`, ... */
export function judge(input, result, t) {
  const bound = t === undefined ? [] : ['--t', String(t)];
  const said = [];
  const say = (text) => said.push(text);
  const exit = () => {
    throw new Exit();
  };
  script ??= compiled();
  try {
    const argv = [process.execPath, JUDGE, input, result, ...bound];
    script({ argv, exit }, { log: say, error: say }, readFileSync);
  } catch (error) {
    if (!(error instanceof Exit)) throw error;
  }
  if (!said.at(-1)?.startsWith('{')) throw new Error(`the judge could not read the files: ${said}`);
  return JSON.parse(said.at(-1));
}
