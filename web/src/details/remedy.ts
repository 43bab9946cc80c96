import type { BADGES } from '../words/result';

/** What would help: more seams, seams at all, or packing all charts, or the islands of the file, anew. */
export type Remedy = 'cut' | 'unwrap' | 'pack' | 'islands';

export interface Verdict {
  badge: (typeof BADGES)[Exclude<keyof typeof BADGES, 'none'>];
  /** One sentence on why. */
  reason: string;
  /** What the user can do about it; null if no single click helps. */
  remedy: Remedy | null;
}
