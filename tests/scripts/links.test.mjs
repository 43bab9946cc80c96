// Links between the documents lead somewhere: every relative path exists, every anchor is a heading.

import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, relative, resolve } from 'node:path';
import { test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { filesBelow } from '../../scripts/lib/stamp.mjs';

/** Documents that npm packs: their links must not leave the package. */
const PACKED = ['wasm/README.md', 'CHANGELOG.md'];

const documentsBelow = (root) => filesBelow(['.'], root).filter((file) => file.endsWith('.md'));

/** Code contains brackets that are not links. */
const withoutCode = (text) => text.replace(/^```.*?^```/gms, '').replace(/`[^`\n]*`/g, 'code');

/** Anchors as GitHub and npm name them. */
function anchorsIn(text) {
  const seen = new Map();
  const headings = text.replace(/^```.*?^```/gms, '').matchAll(/^#+ (.*)$/gm);
  return [...headings].map(([, heading]) => {
    const slug = heading
      .toLowerCase()
      .replace(/[^\p{L}\p{N}\s_-]/gu, '')
      .trim()
      .replace(/\s/g, '-');
    const before = seen.get(slug) ?? 0;
    seen.set(slug, before + 1);
    return before > 0 ? `${slug}-${before}` : slug;
  });
}

function linksIn(text) {
  const found = withoutCode(text).matchAll(/(?:\]\(|\bsrc(?:set)?=")([^()"\s]+)[)"]/g);
  const targets = [...found].map(([, target]) => target);
  return targets.filter((target) => !/^[a-z]+:/.test(target));
}

function fault(file, target) {
  const [path, anchor] = target.split('#');
  const other = path === '' ? file : resolve(dirname(file), path);
  if (!existsSync(other)) return 'no such file';
  if (anchor === undefined) return undefined;
  return anchorsIn(readFileSync(other, 'utf8')).includes(anchor) ? undefined : 'no such heading';
}

function faultsBelow(root) {
  const faults = [];
  for (const file of documentsBelow(root))
    for (const target of linksIn(readFileSync(file, 'utf8'))) {
      const found = fault(file, target);
      if (found) faults.push(`${relative(root, file)}: ${target}: ${found}`);
    }
  return faults;
}

test('every link of a document leads to a file and a heading', () => {
  assert.ok(documentsBelow(ROOT).length > 10);
  assert.deepEqual(faultsBelow(ROOT), []);
});

test('every decision is in the index', () => {
  const folder = join(ROOT, 'docs/decisions');
  const index = readFileSync(join(folder, 'README.md'), 'utf8');
  for (const file of documentsBelow(folder)) {
    const name = relative(folder, file);
    if (name === 'README.md') continue;
    const [title] = readFileSync(file, 'utf8').split('\n');
    assert.ok(index.includes(`[${title.replace(/^# /, '')}](${name})`), `${name}: ${title}`);
  }
});

test('what is packed for npm links to itself and to the web only', () => {
  for (const path of PACKED) {
    const links = linksIn(readFileSync(join(ROOT, path), 'utf8'));
    assert.deepEqual(
      links.filter((target) => !target.startsWith('#')),
      [],
      path,
    );
  }
});

test('a link that leads nowhere is found', () => {
  const folder = mkdtempSync(join(tmpdir(), 'abflat-links-'));
  const text =
    '# One `two`\n[a](b.md) [c](#one-two) [d](#two) [e](a.md#one-two) `[f](g.md)`\n<img src="h.webp">\n';
  try {
    writeFileSync(join(folder, 'a.md'), text);
    assert.deepEqual(faultsBelow(folder), [
      'a.md: b.md: no such file',
      'a.md: #two: no such heading',
      'a.md: h.webp: no such file',
    ]);
  } finally {
    rmSync(folder, { recursive: true });
  }
});
