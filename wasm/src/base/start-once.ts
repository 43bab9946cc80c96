/** Starts something when it is first asked for, and again if that failed. */
export function startOnce<T>(start: () => Promise<T>): {
  get: () => Promise<T>;
  /** Does something with it, if it was started. */
  whenStarted: (use: (started: T) => void) => void;
} {
  let started: Promise<T> | undefined;
  return {
    get: () => {
      started ??= start().catch((error: unknown) => {
        started = undefined;
        throw error;
      });
      return started;
    },
    whenStarted: (use) => {
      started?.then(use, () => undefined);
    },
  };
}
