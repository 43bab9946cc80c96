import type { AbortSignalLike } from './types/index.js';

/** What to do when a signal aborts. */
class Acts extends Set<() => void> {
  readonly tell = () => {
    for (const act of this) act();
  };
}

const actsOf = new WeakMap<AbortSignalLike, Acts>();

/**
 * Has `act` called once the signal aborts. Returns what takes that back. All calls that have a signal
 * share a listener: Node warns of more than ten.
 */
export function onAbort(signal: AbortSignalLike | undefined, act: () => void): () => void {
  if (!signal) return () => undefined;
  const acts = actsOf.get(signal) ?? new Acts();
  if (acts.size === 0) signal.addEventListener('abort', acts.tell);
  actsOf.set(signal, acts.add(act));
  return () => {
    acts.delete(act);
    if (acts.size === 0) signal.removeEventListener('abort', acts.tell);
  };
}
