// When a build step may be skipped.

import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, renameSync, rmSync, utimesSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, test } from 'node:test';
import { filesBelow, fingerprint } from '../../scripts/lib/stamp.mjs';

let folder;
const write = (name, text) => writeFileSync(join(folder, name), text);
const print = () => fingerprint(filesBelow(['src', 'one.json', 'missing.json'], folder));

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'abflat-stamp-'));
  mkdirSync(join(folder, 'src/deep/dist'), { recursive: true });
  write('one.json', '{}');
  write('src/a.ts', 'a');
  write('src/deep/b.ts', 'b');
});
afterEach(() => rmSync(folder, { recursive: true }));

test('a new date or a built file changes nothing', () => {
  const before = print();
  utimesSync(join(folder, 'src/a.ts'), 1, 1);
  write('src/deep/dist/bundle.js', 'built');
  assert.equal(print(), before);
});

test('new content, a new file, a new name and a removed file are noticed', () => {
  const seen = [print()];
  write('src/deep/b.ts', 'B');
  seen.push(print());
  write('src/c.ts', '');
  seen.push(print());
  renameSync(join(folder, 'src/c.ts'), join(folder, 'src/d.ts'));
  seen.push(print());
  rmSync(join(folder, 'one.json'));
  seen.push(print());
  assert.equal(new Set(seen).size, seen.length);
});

test('content does not wander between files unnoticed', () => {
  write('src/a.ts', 'ab');
  write('src/deep/b.ts', '');
  const before = print();
  write('src/a.ts', 'a');
  write('src/deep/b.ts', 'b');
  assert.notEqual(print(), before);
});
