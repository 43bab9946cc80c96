import { FLIPPING, RESHAPING } from '../words/choosing';
import type { Workshop } from '../workshop/workshop';
import type { Change } from './placement';

export interface FlipEvents {
  /** What takes longer to read. */
  noted(sentences: string[]): void;
}

/** Mirrors islands in their places. */
export const flip =
  (islands: number[], workshop: Pick<Workshop, 'flipped'>, { noted }: FlipEvents): Change =>
  async ({ result }) => {
    const { uv, folded } = await workshop.flipped(result, Uint32Array.from(islands));
    if (folded.length > 0) noted([FLIPPING.folded(folded)]);
    return { uv, what: RESHAPING.of(FLIPPING.done, islands, 0) };
  };
