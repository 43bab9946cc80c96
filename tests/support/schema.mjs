// The definition of options and codes that program, package and documents are generated from.

import { ROOT } from '../../scripts/lib/paths.mjs';
import { readSchema } from '../../scripts/lib/read-schema.mjs';

export const SCHEMA = readSchema(ROOT);

/** Every option of flattening with its default, as reports show them. */
export const DEFAULT_OPTIONS = Object.fromEntries(
  SCHEMA.flattenOptions.map(({ name, default: value }) => [name, value]),
);
