import { FETCH_FAILED } from '../words/web-sheet';
import { nameOf } from './address';

/** What goes on while files are fetched. */
export interface Watch {
  signal: AbortSignal;
  /** `total`: bytes of the file, if the server tells. */
  progress(name: string, received: number, total: number | null): void;
  /** Asks before a file of that many bytes is fetched; rejects if it is not wanted. */
  allow(name: string, bytes: number): Promise<void>;
}

/** In bytes; larger files are asked about. */
export const LARGE = 200e6;

/** Fetches one file. Throws a sentence that says what happened, where, and what to do. */
export async function fetchFile(url: URL, watch: Watch): Promise<File> {
  const name = nameOf(url);
  const response = await answerOf(url, watch.signal);
  const total = sizeOf(response);
  if (total !== null && total > LARGE) await watch.allow(name, total);
  const parts = await partsOf(response, name, total, watch);
  const file = new File(parts, name, { type: response.headers.get('Content-Type') ?? '' });
  if (file.size === 0) throw new Error(FETCH_FAILED.empty(name, url.host));
  return file;
}

/** No cookies and no address of the page go to other servers. */
async function answerOf(url: URL, signal: AbortSignal): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(url, {
      signal,
      credentials: 'same-origin',
      referrerPolicy: 'no-referrer',
    });
  } catch (error) {
    signal.throwIfAborted();
    if (!(error instanceof TypeError)) throw error;
    throw new Error(unreachable(url));
  }
  if (!response.ok) throw new Error(refusal(url, response.status));
  if (/^text\/html\b/i.test(response.headers.get('Content-Type') ?? ''))
    throw new Error(FETCH_FAILED.webPage(nameOf(url), url.host));
  return response;
}

/** Browsers do not tell pages which of these it was. */
function unreachable(url: URL): string {
  const failed = navigator.onLine ? FETCH_FAILED.unreachable : FETCH_FAILED.offline;
  return failed(nameOf(url), url.host);
}

function refusal(url: URL, status: number): string {
  const [name, host] = [nameOf(url), url.host];
  if (status === 404 || status === 410) return FETCH_FAILED.notThere(name, host, status);
  if (status === 401 || status === 403) return FETCH_FAILED.notAllowed(name, host, status);
  return FETCH_FAILED.refused(name, host, status);
}

function sizeOf({ headers }: Response): number | null {
  const text = headers.get('Content-Length');
  return text === null ? null : Number(text);
}

/** A compressed answer is larger than its length says. */
async function partsOf(
  { body }: Response,
  name: string,
  total: number | null,
  watch: Watch,
): Promise<Uint8Array<ArrayBuffer>[]> {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  const reader = body?.getReader();
  let received = 0;
  let isAllowed = total !== null && total > LARGE;
  try {
    for (;;) {
      watch.progress(name, received, total);
      const read = await reader?.read();
      if (!read || read.done) return parts;
      parts.push(read.value);
      received += read.value.length;
      if (isAllowed || received <= LARGE) continue;
      await watch.allow(name, received);
      isAllowed = true;
    }
  } catch (error) {
    watch.signal.throwIfAborted();
    if (!(error instanceof TypeError)) throw error;
    throw new Error(FETCH_FAILED.interrupted(name));
  } finally {
    await reader?.cancel().catch(() => undefined);
  }
}
