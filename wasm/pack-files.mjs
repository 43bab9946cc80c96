// Files of the repository that are also part of the package: copied beside package.json only while
// it is packed.
// Usage: pack-files.mjs add | remove

import { copyFileSync, rmSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const HERE = dirname(fileURLToPath(import.meta.url));

for (const name of ['LICENSE', 'CHANGELOG.md'])
  if (process.argv[2] === 'add') copyFileSync(join(HERE, '..', name), join(HERE, name));
  else rmSync(join(HERE, name), { force: true });
