// What the documents name exists: files, npm scripts, functions. links.test.mjs checks links,
// tests/native/documents.test.mjs options and commands.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { basename, join, relative } from 'node:path';
import { test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { filesBelow } from '../../scripts/lib/stamp.mjs';
import { codeSpans, DOCUMENTS, textOf } from '../support/documents.mjs';

const FOLDERS = ['core', 'docs', 'native', 'scripts', 'tests', 'wasm', 'web'];
const FILES = filesBelow(['.'], ROOT).map((file) => relative(ROOT, file));
const SOURCES = FILES.filter((file) => /\.(cpp|h|mjs|ts|js|json|html|txt)$/.test(file));

/** Documents for those who change abflat: the other ones name files of their readers, too. */
const INSIDE = DOCUMENTS.filter((file) =>
  /^(ARCHITECTURE|CONTRIBUTING|SECURITY|docs\/)/.test(file),
);

/** A name in capitals stands for any. What a build writes need not be there. */
const isPlaceholder = (path) => /[A-Z]{3}|\/dist\b/.test(path);

const isPath = (span) =>
  /^[\w./-]+$/.test(span) &&
  (FOLDERS.some((folder) => span.startsWith(`${folder}/`)) || /\w\.(cpp|h|mjs|ts)$/.test(span));

/** A file or folder may be named by the end of its path. */
const isThere = (path) =>
  FILES.some((file) => `/${file}/`.includes(`/${path.replace(/\/$/, '')}/`));

/** Sections of decisions on what others do. */
const withoutDropped = (text) =>
  text.replace(/^## (Tried and dropped|Dropped)$.*?(?=^## |$(?![\s\S]))/gms, '');

function identifiersIn(text) {
  const spans = codeSpans(withoutDropped(text)).map((span) => span.replace(/\(.*\)$/, ''));
  return spans
    .filter((span) => /^[A-Za-z]\w*(::\w+)*$/.test(span))
    .flatMap((span) => span.split('::'));
}

test('every npm script that a document names exists', () => {
  const { scripts } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8'));
  for (const document of DOCUMENTS)
    for (const [, name] of textOf(document).matchAll(/\bnpm run ([\w:-]+)/g))
      assert.ok(name in scripts, `${document}: npm run ${name}`);
});

test('every file that a document for developers names exists', () => {
  for (const document of INSIDE)
    for (const span of codeSpans(textOf(document)))
      if (isPath(span) && !isPlaceholder(span)) assert.ok(isThere(span), `${document}: ${span}`);
});

test('what records of decisions call by its name is in the sources', () => {
  const texts = SOURCES.map((file) => readFileSync(join(ROOT, file), 'utf8'));
  const known = new Set(texts.flatMap((text) => text.match(/[A-Za-z_]\w*/g) ?? []));
  for (const file of FILES) known.add(basename(file).split('.')[0]);
  for (const document of INSIDE.filter((file) => /^docs\/decisions|^ARCH|algorithm/.test(file)))
    for (const name of identifiersIn(textOf(document)))
      assert.ok(known.has(name), `${document}: ${name}`);
});
