// The documents, and the code in them.

import { readFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { filesBelow } from '../../scripts/lib/stamp.mjs';

/** Paths from the root of the repository. */
export const DOCUMENTS = filesBelow(['.'], ROOT)
  .filter((file) => file.endsWith('.md'))
  .map((file) => relative(ROOT, file));

export const textOf = (document) => readFileSync(join(ROOT, document), 'utf8');

/**
 * Blocks between fences, as `{ language, skip, code, line }`; `skip` is why tests leave a sample
 * out, written behind its language as skip="reason".
 */
export function codeBlocks(text) {
  const blocks = text.matchAll(/^```(\w*)([^\n]*)\n(.*?)^```/gms);
  return [...blocks].map(({ index, 1: language, 2: more, 3: code }) => ({
    language,
    skip: more.match(/ skip="([^"]*)"$/)?.[1],
    code,
    line: text.slice(0, index).split('\n').length,
  }));
}

/** Code within sentences, without backticks. */
export function codeSpans(text) {
  const spans = text.replace(/^```.*?^```/gms, '').matchAll(/`([^`\n]+)`/g);
  return [...spans].map(([, code]) => code);
}

/** The block below a comment `example: NAME`. */
export function exampleIn(document, name) {
  const [, after] = textOf(document).split(`<!-- example: ${name} -->`);
  return codeBlocks(after)[0].code;
}
