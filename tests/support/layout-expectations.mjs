// Compares a layout with what a person expects of it, see ordinary-shapes.mjs.

import { looksOf } from './layout-looks.mjs';

const percent = (share) => `${(100 * share).toFixed(0)} %`;

/** What a length has to exceed to count, relative to what is allowed. */
const SLACK = 1 + 1e-9;

/** What a cut for packing has to gain, in the logarithm of the texel density. */
const GAIN_OF_FIRST_CUTS = 0.05;
const GAIN_OF_CUT = 0.02;
const FIRST_CUTS = 4;

/** The charts before they were cut for packing, if each of the cuts is worth it. */
function chartsWithoutCuts(charts, { packingCuts, texelDensity, uncutTexelDensity }) {
  const gain = Math.log(texelDensity / uncutTexelDensity);
  const first = Math.min(packingCuts, FIRST_CUTS);
  const asked = GAIN_OF_FIRST_CUTS * first + GAIN_OF_CUT * (packingCuts - first);
  return gain >= asked ? charts - packingCuts : charts;
}

/**
 * For each expectation, by name: an empty text if it is met, or else what is instead. `charted` is
 * from chartedLayout, `atlas` from the report.
 */
export function faultsOf(expect, charted, atlas) {
  const looks = looksOf(charted, { withExposed: false });
  const { cuts } = charted;
  const out = {};
  const [fewest, most] = expect.charts;
  const charts = chartsWithoutCuts(looks.charts, atlas);
  const isFine = charts >= fewest && charts <= most;
  out.charts = isFine ? '' : `${charts} charts, not ${fewest} to ${most}`;
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
