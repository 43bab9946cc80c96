// What runs on a public forge is what runs here.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { GROUPS, LONG_SUITES, SUITES } from '../../scripts/suites.mjs';

const workflow = readFileSync(join(ROOT, '.github/workflows/ci.yml'), 'utf8');

test('the parts of the workflow are all that CI runs, each once', () => {
  const words = [...workflow.matchAll(/^ +suites: (.+)$/gm)].flatMap(([, names]) =>
    names.split(' '),
  );
  const suites = words.flatMap(
    (word) => GROUPS[word] ?? [...SUITES, ...LONG_SUITES].filter(({ name }) => name === word),
  );
  const titles = (list) => list.map(({ title }) => title).sort();
  assert.deepEqual(titles(suites), titles(GROUPS.ci));
});
