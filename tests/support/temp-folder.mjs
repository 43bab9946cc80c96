// A folder of its own for a test, removed when the test ends.

import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/**
 * Creates the folder and returns a function that maps a name to its path in it ('' for the folder
 * itself).
 */
export function tempFolder(context) {
  const folder = mkdtempSync(join(tmpdir(), 'abflat-test-'));
  context.after(() => rmSync(folder, { recursive: true, force: true }));
  return (name = '') => join(folder, name);
}
