// Compressed copies beside a file, as the build of the page writes them, and which of them a browser takes.

import { existsSync } from 'node:fs';

/** The smallest first, with the ending of its copy. */
const ENCODINGS = [
  ['br', '.br'],
  ['gzip', '.gz'],
];

/** What an Accept-Encoding header names, but for what it refuses with q=0. */
export function acceptedEncodings(header = '') {
  const isTaken = ([, ...parameters]) => !parameters.some((each) => /^q=0(\.0*)?$/i.test(each));
  const named = header.split(',').map((each) => each.split(';').map((part) => part.trim()));
  return new Set(named.filter(isTaken).map(([name]) => name.toLowerCase()));
}

/** What to send for a file: `encoding` is undefined for the file itself; `varies`: others may be sent something else. */
export function copyFor(file, acceptEncoding) {
  const copies = ENCODINGS.filter(([, ending]) => existsSync(file + ending));
  const accepted = acceptedEncodings(acceptEncoding);
  const [encoding, ending = ''] = copies.find(([name]) => accepted.has(name)) ?? [];
  return { path: file + ending, encoding, varies: copies.length > 0 };
}
