import { AbflatError, type LostPart } from 'abflat';
import { LOST } from '../words/base';

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

export const notLoaded = (detail: string) => new Lost(LOST.notLoaded, detail);

export const stopped = (detail: string) => new Lost(LOST.stopped, detail);

/** The name of such an error from a worker: its class does not survive the message. */
export const NOT_LOADED = 'NotLoaded';

const OF_PART: Record<LostPart, (sentence: string) => Lost> = {
  module: notLoaded,
  worker: () => notLoaded(LOST.noWorker),
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
