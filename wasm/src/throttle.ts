import type { AnyProgress } from './messages/protocol.js';

/** About 30 a second. */
const PROGRESS_PAUSE_MS = 33;

/**
 * Passes on the first message of each stage and the last of all, and the others at most once per
 * PROGRESS_PAUSE_MS.
 */
export function throttle(post: (progress: AnyProgress) => void): (progress: AnyProgress) => void {
  let stage: AnyProgress['stage'] | undefined;
  let last = Number.NEGATIVE_INFINITY;
  return (progress) => {
    const now = performance.now();
    const isEdge = progress.stage !== stage || progress.fraction === 1;
    if (!isEdge && now - last < PROGRESS_PAUSE_MS) return;
    stage = progress.stage;
    last = now;
    post(progress);
  };
}
