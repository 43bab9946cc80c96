// Compares a layout with what a person expects of it, see ordinary-shapes.mjs.

import { looksOf } from './layout-looks.mjs';

const percent = (share) => `${(100 * share).toFixed(0)} %`;

/** What a length has to exceed to count, relative to what is allowed. */
const SLACK = 1 + 1e-9;

/**
 * For each expectation, by name: an empty text if it is met, or else what is instead. `charted` is
 * from chartedLayout.
 */
export function faultsOf(expect, charted) {
  const looks = looksOf(charted, { withExposed: false });
  const { cuts } = charted;
  const out = {};
  const [fewest, most] = expect.charts;
  const isFine = looks.charts >= fewest && looks.charts <= most;
  out.charts = isFine ? '' : `${looks.charts} charts, not ${fewest} to ${most}`;
  out.sd = looks.sd <= expect.sd ? '' : `a stretch of ${looks.sd}, not ${expect.sd}`;
  out.flat =
    looks.flat === 0 ? '' : `cuts within flat regions of ${looks.flat.toFixed(3)} of the size`;
  if (expect.level !== undefined)
    out.level =
      looks.axis >= expect.level
        ? ''
        : `${percent(looks.axis)} of outlines are level, not ${percent(expect.level)}`;
  if (expect.isSeam) {
    const wrong = cuts.filter((cut) => !expect.isSeam(cut)).length;
    out.isSeam = wrong === 0 ? '' : `${wrong} of ${cuts.length} cut edges are no place for a seam`;
  }
  if (expect.cut !== undefined) {
    const length = cuts.reduce((sum, cut) => sum + cut.length, 0);
    out.cut = length <= expect.cut * SLACK ? '' : `cuts of length ${length}, not ${expect.cut}`;
  }
  return out;
}
