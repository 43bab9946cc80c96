// Compares the results of two builds of the same code.

import assert from 'node:assert/strict';

/** Fails with the first line that differs. */
export function assertSameText(text, expected) {
  if (text === expected) return;
  const [found, wanted] = [text.split('\n'), expected.split('\n')];
  const i = wanted.findIndex((line, n) => line !== found[n]);
  assert.fail(`line ${i + 1} is "${found[i]}", expected "${wanted[i]}"`);
}

/** Times differ between runs. */
export const withoutSeconds = (value) =>
  JSON.parse(JSON.stringify(value, (key, each) => (/seconds$/i.test(key) ? undefined : each)));

/** The same keys in the same order, at every level; for lists, only of the first entry. */
export function assertSameShape(a, b, path) {
  assert.equal(typeof a, typeof b, path);
  if (typeof a !== 'object' || a === null) return;
  if (Array.isArray(a)) {
    assertSameShape(a[0], b[0], `${path}[0]`);
    return;
  }
  assert.deepEqual(Object.keys(a), Object.keys(b), path);
  for (const key of Object.keys(a)) assertSameShape(a[key], b[key], `${path}.${key}`);
}
