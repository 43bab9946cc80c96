// The layer check finds cycles and dependencies that point up, in C++ and in TypeScript.

import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { layerFaults } from '../../scripts/lib/layers.mjs';

const REPO = fileURLToPath(new URL('../..', import.meta.url));

const TABLES = `# House

| layers of \`core/src\` | public headers |
|---|---|
| \`top\` | \`top.h\` |
| \`left\`, \`right\` | |
| \`base\` | |

| layers of \`web/src\` |
|---|
| \`.\` |
| \`view\` |
`;

const FILES = {
  'ARCHITECTURE.md': TABLES,
  'core/include/abflat/top.h': '#include "abflat/data.h"\n',
  'core/include/abflat/data.h': '',
  'core/src/top/top.cpp': '#include "abflat/top.h"\n#include "left/a.h"\n#include "base/b.h"\n',
  'core/src/left/a.h': '#include <vector>\n#include "abflat/data.h"\n#include "base/b.h"\n',
  'core/src/left/c.h': '#include "left/a.h"\n',
  'core/src/right/d.h': '#include "base/b.h"\n',
  'core/src/base/b.h': '',
  'web/src/main.ts': "import './view/view.js';\nimport type { Item } from './view/item.js';\n",
  'web/src/view/view.ts': "import { item } from './item.js';\nimport * as three from 'three';\n",
  'web/src/view/item.ts': 'export const item = 1;\nexport type Item = number;\n',
};

let folder;
before(() => {
  folder = mkdtempSync(join(tmpdir(), 'abflat-layers-'));
});
after(() => rmSync(folder, { recursive: true }));

function faultsWith(changes) {
  rmSync(folder, { recursive: true });
  for (const [path, text] of Object.entries({ ...FILES, ...changes })) {
    mkdirSync(dirname(join(folder, path)), { recursive: true });
    writeFileSync(join(folder, path), text);
  }
  return layerFaults(folder);
}

test('the layers of the repository hold', () => {
  assert.deepEqual(layerFaults(REPO), []);
});

test('a house whose arrows all point down has no faults', () => {
  assert.deepEqual(faultsWith({}), []);
});

const PLANTED = {
  'an include of a room above': [
    { 'core/src/base/b.h': '#include "left/a.h"\n' },
    /^core\/src\/base\/b\.h uses core\/src\/left\/a\.h, which is not below it$/,
  ],
  'an include of a room beside': [
    { 'core/src/right/d.h': '#include "left/c.h"\n' },
    /^core\/src\/right\/d\.h uses core\/src\/left\/c\.h, which is not below it$/,
  ],
  'an include of the public header of a room above': [
    { 'core/src/left/a.h': '#include "abflat/top.h"\n' },
    /^core\/src\/left\/a\.h uses core\/include\/abflat\/top\.h, which is not below it$/,
  ],
  'a circle within a room': [
    { 'core/src/left/a.h': '#include "left/c.h"\n' },
    /^these use each other: core\/src\/left\/a\.h -> core\/src\/left\/c\.h -> core\/src\/left\/a\.h$/,
  ],
  'an import of what is above': [
    { 'web/src/view/item.ts': "export { main } from '../main.js';\n" },
    /^web\/src\/view\/item\.ts uses web\/src\/main\.ts, which is not below it$/,
  ],
  'an import that is carried out later': [
    { 'web/src/view/item.ts': "export const later = () => import('../main.js');\n" },
    /^web\/src\/view\/item\.ts uses web\/src\/main\.ts, which is not below it$/,
  ],
  'a room that no table names': [
    { 'core/src/attic/e.h': '' },
    /^core\/src\/attic is in no layer of ARCHITECTURE\.md$/,
  ],
  'a file beside the rooms': [
    { 'core/src/loose.h': '' },
    /^core\/src\/\. is in no layer of ARCHITECTURE\.md$/,
  ],
};
for (const [name, [changes, expected]] of Object.entries(PLANTED))
  test(`${name} is a fault`, () => {
    const faults = faultsWith(changes);
    assert.ok(
      faults.some((fault) => expected.test(fault)),
      faults.join('\n'),
    );
  });

test('a layer where nothing is is a fault, and so is a document without any', () => {
  const more = TABLES.replace('`base`', '`base`, `cellar`');
  assert.deepEqual(faultsWith({ 'ARCHITECTURE.md': more }), [
    'ARCHITECTURE.md has a layer for core/src/cellar, where nothing is',
  ]);
  assert.deepEqual(faultsWith({ 'ARCHITECTURE.md': '# House\n' }), [
    'ARCHITECTURE.md has no table of layers',
  ]);
});
