import { UV_FAULT } from 'abflat';
import { CHART_COLORS } from './chart-colors';

/** A bit beside those of UV_FAULT: the triangle overlaps what it is stacked with. */
export const STACKED = 16;

const BITS = { ...UV_FAULT, stacked: STACKED } as const;

/** Also what is none: to be stacked on purpose. */
export type UvFault = keyof typeof BITS;

/** What a face with several faults is painted as comes first; often a whole island is mirrored on purpose. */
export const FAULTS: readonly UvFault[] = ['overlapping', 'outside', 'empty', 'stacked', 'flipped'];

/** The colours of charts, then those of faults. */
export const FACE_COLORS = CHART_COLORS + FAULTS.length;

/** The number of the colour for these faults; undefined if there are none. */
export function faultColor(bits: number): number | undefined {
  const first = FAULTS.findIndex((fault) => bits & BITS[fault]);
  return first < 0 ? undefined : CHART_COLORS + first;
}
