import type { Packed } from './model';

/** How many faces have each fault; those that are stacked on purpose do not count as overlapping. */
export function faultyFaces({ result, fileStacks }: Pick<Packed, 'result' | 'fileStacks'>) {
  const { faces } = result.report;
  const stacked = fileStacks?.faces ?? 0;
  return { ...faces, overlapping: faces.overlapping - stacked, stacked };
}
