// What people read names the formats of the schema.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import {
  coreFormats,
  filesOf,
  namesOf,
  titleOf,
  writtenFormats,
} from '../../scripts/lib/formats.mjs';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { readSchema } from '../../scripts/lib/read-schema.mjs';

const { formats } = readSchema(ROOT);
const titles = (some) => some.map(({ title }) => title);

const EXPORTED = writtenFormats(formats).map((format) => titleOf(filesOf([format])[0]));

/** What a sentence may list: what the core reads, all formats, all by every name, what is exported. */
const LISTS = [titles(coreFormats(formats)), titles(formats), namesOf(formats), EXPORTED].map(
  (names) => names.toSorted().join(),
);

const NAME = `(?:${namesOf(formats).join('|')})`;
const LIST = new RegExp(`\\b${NAME}(?:, ${NAME})+,? (?:or|and) ${NAME}\\b`, 'g');

/** Whether a list is of all that is read or exported, and not of formats that have something. */
function isOfAll(names) {
  const onlyRead = titles(formats.filter(({ precision }) => !precision));
  return (
    names.some((name) => onlyRead.includes(name)) || names.every((name) => EXPORTED.includes(name))
  );
}

const DOCUMENTS = [
  'README.md',
  'wasm/README.md',
  'web/index.html',
  'wasm/src/types/mesh.ts',
  ...readdirSync(join(ROOT, 'docs'))
    .filter((name) => name.endsWith('.md'))
    .map((name) => `docs/${name}`),
];

test('sentences that list the formats list all of them', () => {
  const found = DOCUMENTS.flatMap((path) =>
    [...readFileSync(join(ROOT, path), 'utf8').matchAll(LIST)].map(([list]) => ({
      path,
      names: list.match(new RegExp(NAME, 'g')),
    })),
  ).filter(({ names }) => isOfAll(names));
  assert.ok(found.length > 5);
  const wrong = found.filter(({ names }) => !LISTS.includes(names.toSorted().join()));
  assert.deepEqual(wrong, []);
});

test('the page on file formats has a row for each', () => {
  const text = readFileSync(join(ROOT, 'docs/formats.md'), 'utf8');
  for (const { title } of formats)
    assert.match(text, new RegExp(`^\\| ${title}[ \\w.]* \\| [^|]`, 'm'));
});
