// Strong tags of contents: a browser that names the tag of what it has is not sent the same again.

import { createHash } from 'node:crypto';
import { readFileSync, statSync } from 'node:fs';

const known = new Map();

export function etagOf(file) {
  const { mtimeMs, size } = statSync(file);
  const state = `${mtimeMs} ${size}`;
  const last = known.get(file);
  if (last?.state === state) return last.tag;
  const tag = `"${createHash('sha256').update(readFileSync(file)).digest('base64url')}"`;
  known.set(file, { state, tag });
  return tag;
}

/** Whether an If-None-Match header names the tag. Caches on the way may have marked it as weak. */
export function names(header, tag) {
  const tags = (header ?? '').split(',').map((each) => each.trim().replace(/^W\//, ''));
  return tags.includes('*') || tags.includes(tag);
}
