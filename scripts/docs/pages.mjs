// The pages of the site: the documents of the repository, in the order of the sidebar.

import { readFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { ROOT } from '../lib/paths.mjs';
import { Failure } from '../lib/run.mjs';
import { filesBelow } from '../lib/stamp.mjs';

/** Documents outside of docs/ and docs/decisions/, and where they are on the site. */
const ELSEWHERE = {
  'README.md': 'overview.md',
  'wasm/README.md': 'javascript.md',
  'ARCHITECTURE.md': 'architecture.md',
  'CONTRIBUTING.md': 'contributing.md',
  'SECURITY.md': 'security.md',
  'CHANGELOG.md': 'changes.md',
};

const DECISIONS = 'docs/decisions/';

const SIDEBAR = [
  { title: 'abflat', files: ['docs/index.md', 'README.md', 'docs/migrating.md', 'CHANGELOG.md'] },
  {
    title: 'Doors',
    files: [
      'docs/page.md',
      'docs/command-line.md',
      'wasm/README.md',
      'docs/python.md',
      'docs/cpp.md',
    ],
  },
  {
    title: 'Subjects',
    files: [
      'docs/unwrapping.md',
      'docs/packing.md',
      'docs/verify.md',
      'docs/batch.md',
      'docs/clusters.md',
      'docs/baking.md',
      'docs/formats.md',
      'docs/report.md',
      'docs/methods.md',
      'docs/algorithm.md',
    ],
  },
  { title: 'Inside', files: ['ARCHITECTURE.md', 'CONTRIBUTING.md', 'SECURITY.md'] },
];

/** The title is the first heading, except where two documents have the same. */
const TITLES = {
  'docs/index.md': 'Start',
  'README.md': 'Overview',
  'wasm/README.md': 'JavaScript',
};

/** Where a document is on the site. */
export function placeOf(file) {
  if (ELSEWHERE[file]) return ELSEWHERE[file];
  return file.replace(/^docs\//, '').replace(/README\.md$/, 'index.md');
}

/** The first heading of a document, as plain text. */
export function headingOf(text) {
  return (text.match(/^# (.*)$/m)?.[1] ?? '').replaceAll('`', '');
}

const titleOf = (file) => TITLES[file] ?? headingOf(readFileSync(join(ROOT, file), 'utf8'));

const pageOf = (file) => ({ file, place: placeOf(file), title: titleOf(file) });

/** Every document of the site by groups: `[{ title, isFolded, pages: [{ file, place, title }] }]`. */
export function pageGroups() {
  const documents = filesBelow(['docs'])
    .map((file) => relative(ROOT, file))
    .filter((file) => file.endsWith('.md'));
  const decisions = documents.filter((file) => file.startsWith(DECISIONS));
  const named = new Set([...SIDEBAR.flatMap(({ files }) => files), ...decisions]);
  const lost = documents.find((file) => !named.has(file));
  if (lost) throw new Failure(`${lost} is not on the site: name it in scripts/docs/pages.mjs.`);
  // The index comes first.
  const ordered = decisions.sort(
    (a, b) => Number(b.endsWith('README.md')) - Number(a.endsWith('README.md')),
  );
  return [
    ...SIDEBAR.map(({ title, files }) => ({ title, pages: files.map(pageOf) })),
    { title: 'Decisions', isFolded: true, pages: ordered.map(pageOf) },
  ];
}
