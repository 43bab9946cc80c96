#!/usr/bin/env node
// Opens the next version: sets it in every file that names it, and heads the changelog with it.
// Usage: version.mjs 0.2.0

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from './lib/paths.mjs';
import { Failure, runMain } from './lib/run.mjs';
import { isVersion, openVersion, PLACES } from './lib/version.mjs';

function rewrite(file, change) {
  const path = join(ROOT, file);
  writeFileSync(path, change(readFileSync(path, 'utf8')));
  console.log(`wrote ${file}`);
}

await runMain(async () => {
  const [version = ''] = process.argv.slice(2);
  if (!isVersion(version)) throw new Failure('Usage: version.mjs VERSION, such as 0.2.0');
  for (const [file, place] of Object.entries(PLACES))
    rewrite(file, (text) => text.replace(place, version));
  rewrite('CHANGELOG.md', (text) => openVersion(text, version));
});
