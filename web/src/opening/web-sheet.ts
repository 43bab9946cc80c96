// What is asked before anything is fetched from another server.

import { WEB_SHEET } from '../words/web-sheet';
import { type Address, shown } from './address';
import { namesFiles } from './fetch-mesh';
import type { Question } from './question';

export { ask } from './question';

/** Before the first request. `bytes`: the size, if it is known. */
export function openFrom({ url, name, host }: Address, bytes: number | null): Question {
  const size = bytes === null ? '' : megabytes(bytes);
  return {
    title: WEB_SHEET.openFrom(name, host),
    paragraphs: [WEB_SHEET.whatHappens(host, size, namesFiles(name)), shown(url)],
    yes: WEB_SHEET.open,
  };
}

export const fetchLarge = (name: string, bytes: number): Question => ({
  title: WEB_SHEET.fetchLarge(megabytes(bytes)),
  paragraphs: [WEB_SHEET.large(name, megabytes(bytes))],
  yes: WEB_SHEET.fetch,
});

/** "0.3 MB", "12 MB". */
export function megabytes(bytes: number): string {
  const size = bytes / 1e6;
  return WEB_SHEET.megabytes(size < 9.95 ? Math.max(0.1, size).toFixed(1) : size.toFixed(0));
}
