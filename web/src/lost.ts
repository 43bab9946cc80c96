/** A part of the page could not be loaded or has stopped: trying again may help. `detail`: what was said about it. */
export class Lost extends Error {
  constructor(
    sentence: string,
    readonly detail: string,
  ) {
    super(sentence);
  }
}

export const notLoaded = (detail: string) =>
  new Lost(
    'a part of this page could not be loaded. Check the connection, then try again.',
    detail,
  );

export const stopped = (detail: string) =>
  new Lost(
    'its worker stopped, perhaps for want of memory. Close other tabs, then try again.',
    detail,
  );

export const NO_WORKER = 'A worker cannot be loaded.';

/** An error of abflat that says so, which is meant for whoever builds a page; null: another. */
export function lostOf(error: unknown): Lost | null {
  if (error instanceof Lost) return error;
  if (!(error instanceof Error)) return null;
  const [first] = error.message.split(/(?<=\.)\s/);
  if (/^Cannot load the worker /.test(first)) return notLoaded(NO_WORKER);
  if (/^Cannot load |^The browser does not start /.test(first)) return notLoaded(first);
  if (/^The worker of abflat stopped/.test(first)) return stopped(first);
  return null;
}
