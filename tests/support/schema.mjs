// The definition of options and codes that program, package and documents are generated from.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { checkSchema } from '../../scripts/lib/schema.mjs';

export const SCHEMA = checkSchema(
  JSON.parse(readFileSync(join(ROOT, 'core/schema/abflat.json'), 'utf8')),
);

/** Every option of flattening with its default, as reports show them. */
export const DEFAULT_OPTIONS = Object.fromEntries(
  SCHEMA.flattenOptions.map(({ name, default: value }) => [name, value]),
);
