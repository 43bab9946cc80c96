// Where a mesh on the web is.

import { ADDRESSES } from '../words/web';

export interface Address {
  url: URL;
  /** Of the file, for people. */
  name: string;
  host: string;
  /** On the server of the page itself. */
  isOwn: boolean;
}

/** `page`: the address of the page. Throws with a sentence if nothing can be fetched from there. */
export function addressOf(text: string, page: string): Address {
  const url = parse(text, page);
  if (url.username || url.password) throw new Error(ADDRESSES.password(url.host));
  if (url.protocol !== 'https:' && !isOfPage(url, page))
    throw new Error(ADDRESSES.notHttps(shown(url)));
  return placeOf(url, page);
}

export const placeOf = (url: URL, page: string): Address => ({
  url,
  name: nameOf(url),
  host: url.host,
  isOwn: isOfPage(url, page),
});

const isOfPage = ({ origin }: URL, page: string) => origin === new URL(page).origin;

function parse(text: string, page: string): URL {
  try {
    return new URL(text.trim(), page);
  } catch {
    throw new Error(ADDRESSES.invalid(text));
  }
}

/** For people: both ends of a long one. */
export const shown = ({ href }: URL): string =>
  href.length > 160 ? `${href.slice(0, 100)}…${href.slice(-59)}` : href;

/** The last part of the path. */
export function nameOf({ pathname, host }: URL): string {
  const last = pathname.split('/').at(-1) ?? '';
  return decoded(last) || host;
}

/** As it is written if it is not encoded as it should be. */
export function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
