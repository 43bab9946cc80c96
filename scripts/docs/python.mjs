// The reference of the Python package, from the docstrings of its sources.

import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { ROOT } from '../lib/paths.mjs';
import { Failure, which } from '../lib/run.mjs';
import { write } from './stage.mjs';

const SCRIPT = join(ROOT, 'scripts/docs/describe_python.py');

/** Writes a page; returns why not, if there is no Python. */
export function writePythonReference(path) {
  const python = process.env.PYTHON ?? which('python3');
  if (python === undefined)
    return 'Python 3.9 is not installed, so the reference of the Python package is left out.';
  const args = [SCRIPT, join(ROOT, 'native/python'), 'abflat'];
  const { status, stdout, stderr } = spawnSync(python, args, { encoding: 'utf8' });
  if (status !== 0)
    throw new Failure(`The Python package could not be described:\n${stderr.trim()}`);
  write(path, stdout);
  return undefined;
}
