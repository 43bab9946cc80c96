import { UV_FAULT } from 'abflat';
import { CHART_COLORS } from './chart-colors';

export type UvFault = keyof typeof UV_FAULT;

/** What a face with several faults is painted as comes first; often a whole island is mirrored on purpose. */
export const FAULTS: readonly UvFault[] = ['overlapping', 'outside', 'empty', 'flipped'];

/** The colours of charts, then those of faults. */
export const FACE_COLORS = CHART_COLORS + FAULTS.length;

/** The number of the colour for these faults; undefined if there are none. */
export function faultColor(bits: number): number | undefined {
  const first = FAULTS.findIndex((fault) => bits & UV_FAULT[fault]);
  return first < 0 ? undefined : CHART_COLORS + first;
}
