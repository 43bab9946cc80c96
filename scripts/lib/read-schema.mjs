// The whole schema of a repository, checked.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { checkFormats } from './formats.mjs';
import { resolveStructs } from './report-schema.mjs';
import { checkSchema } from './schema.mjs';

const FILES = ['abflat', 'formats', 'report'].map((name) => `core/schema/${name}.json`);

/** Reads the schema of the repository in the folder `root`. */
export function readSchema(root) {
  const parts = FILES.map((path) => JSON.parse(readFileSync(join(root, path), 'utf8')));
  return resolveStructs(checkFormats(checkSchema(Object.assign({}, ...parts))));
}
