import { AbflatError, type LostPart } from 'abflat';

/**
 * A part of the page could not be loaded or has stopped, so trying again may help. `detail`: what
 * was reported about it.
 */
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
    'its worker stopped, possibly because memory ran out. Close other tabs, then try again.',
    detail,
  );

/** The name of such an error from a worker: its class does not survive the message. */
export const NOT_LOADED = 'NotLoaded';

export const NO_WORKER = 'A worker could not be loaded.';

const OF_PART: Record<LostPart, (sentence: string) => Lost> = {
  module: notLoaded,
  worker: () => notLoaded(NO_WORKER),
  stopped,
};

/**
 * The part of abflat itself that an error is about; null if it is about a mesh. Anything after its
 * first sentence is meant for developers who build a page.
 */
export function lostOf(error: unknown): Lost | null {
  if (error instanceof Lost) return error;
  if (!(error instanceof AbflatError && error.lost)) return null;
  const [first] = error.message.split(/(?<=\.)\s/);
  return OF_PART[error.lost](first);
}
