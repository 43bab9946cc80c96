import { type Remote, wrap } from 'comlink';
import { NOT_LOADED, notLoaded, stopped } from '../base/lost';
import { LOST } from '../words/base';
import type { Tasks } from './worker';

export interface Running {
  tasks: Remote<Tasks>;
  /** Rejects if the worker cannot be loaded or stops. */
  lost: Promise<never>;
  end: () => void;
}

export function startWorker(name: string, onLost: () => void): Running {
  const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module', name });
  const lost = new Promise<never>((_, reject) => {
    worker.onerror = (event) => {
      event.preventDefault();
      worker.terminate();
      onLost();
      // A script that cannot be loaded has no message.
      reject(event.message ? stopped(event.message) : notLoaded(LOST.noWorker));
    };
  });
  lost.catch(() => undefined); // callers that wait for the worker get this error
  return { tasks: wrap<Tasks>(worker), lost, end: () => worker.terminate() };
}

/**
 * Work in a worker of its own: its memory is freed with it, and what would keep it busy forever can
 * be cancelled.
 */
export async function inOwnWorker<R>(
  name: string,
  work: (tasks: Remote<Tasks>) => Promise<R>,
  signal: AbortSignal,
): Promise<R> {
  signal.throwIfAborted();
  const { tasks, lost, end } = startWorker(name, () => undefined);
  const aborted = new Promise<never>((_, reject) => {
    signal.addEventListener('abort', () => reject(signal.reason));
  });
  try {
    return await Promise.race([work(tasks), lost, aborted]);
  } catch (error) {
    return explained(error as Error);
  } finally {
    end();
  }
}

/** The class of an error does not survive the message. */
export function explained(error: Error): never {
  throw error.name === NOT_LOADED ? notLoaded(error.message) : error;
}
