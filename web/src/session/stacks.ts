// Charts that share texels on purpose. Those that the user has stacked are unknown to abflat, unless equal charts are to
// be stacked anyway.

import type { Abflat, MeshInput, UnwrapOptions, UnwrapReport, UnwrapResult } from 'abflat';
import { copied } from '../base/buffers';
import { inOneTile } from '../mesh/in-one-tile';
import type { DisplayMesh } from '../mesh/mesh';
import { isOutside, isOverlapping } from '../model/misplaced';
import type { Helpers, Unwrapped } from '../model/model';
import { type Stack, stacksIn } from '../model/stacks';
import { DEFECTS } from '../words/result';

export type StackHelpers = Pick<Helpers, 'stacks' | 'apart' | 'restacked'>;

/** What runs on one mesh need. */
export interface Runs {
  abflat: Abflat;
  input: MeshInput;
  helpers: StackHelpers;
  signal: AbortSignal;
}

export type Judged = Pick<Unwrapped, 'result' | 'stacks'>;

/** In place of the density asked for: charts that will lie on others are to take no room beside them. */
const SMALL = 0.05;

/**
 * A result whose charts stay where they are. Those of a stack are judged apart from each other,
 * each beside all other charts.
 */
export async function judged(result: UnwrapResult, runs: Runs): Promise<Judged> {
  const { valid, options } = result.report;
  if (options.stack === 'none') return valid ? { result } : judgedApart(result, runs);
  const whole = valid ? result : await withOverlaps(result, result.uv, runs, options.stack);
  return { result: whole, stacks: stacksIn(whole.report) };
}

async function judgedApart(result: UnwrapResult, runs: Runs): Promise<Judged> {
  const found = await runs.helpers.stacks(result);
  const { atlas, charts } = result.report;
  // Only the lowest chart need not have room for more digits.
  const stacks = lowestFirst(found.stacks, (chart) => charts[chart].solver === 'given');
  const rows = Math.ceil(atlas.tiles / 10);
  const uv = stacks.length > 0 ? await runs.helpers.apart(result, stacks, rows) : null;
  if (!uv) return { result: await withOverlaps(result, result.uv, runs) };
  const placed = await inPlace({ ...result, uv }, runs);
  const { tiles, utilization } = placed.report.atlas;
  const area = utilization * tiles - found.repeated;
  const report = withVerdict(result, placed, { ...atlas, utilization: area / atlas.tiles });
  return { result: await withOverlaps({ ...result, report }, uv, runs), stacks };
}

/**
 * Abflat does not look for what charts outside their tiles overlap. So all are looked at once more,
 * as small as one tile. `uv`: where no stack overlaps itself.
 */
async function withOverlaps(
  result: UnwrapResult,
  uv: Float64Array,
  runs: Runs,
  stack: UnwrapOptions['stack'] = 'none',
): Promise<UnwrapResult> {
  const { report, chartOfTriangle } = result;
  if (!report.charts.some(({ problem }) => isOutside(problem))) return result;
  const found = await inPlace({ ...result, uv: inOneTile(uv) }, runs, stack);
  const charts = [...report.charts];
  chartOfTriangle.forEach((chart, f) => {
    const other = found.report.charts[found.chartOfTriangle[f]];
    const before = report.charts[chart];
    if (!before || !other || !isOverlapping(other.problem)) return;
    if (before.valid) charts[chart] = { ...before, valid: false, problem: other.problem };
    else if (isOutside(before.problem))
      charts[chart] = { ...before, problem: DEFECTS.both(before.problem, other.problem) };
  });
  return { ...result, report: { ...report, charts } };
}

/** Checks all charts where they are, in any number of tiles. */
export async function inPlace(
  result: UnwrapResult,
  { abflat, input, signal }: Runs,
  stack: UnwrapOptions['stack'] = 'none',
) {
  const { resolution, padding, texelDensity } = result.report.atlas;
  return abflat.unwrap(await copied(input), {
    known: result,
    fixedCharts: Uint32Array.from(result.report.charts.keys()),
    keepsPlaces: true,
    seams: 'none',
    resolution,
    padding,
    udim: true,
    stack,
    texelDensity: texelDensity > 0 ? texelDensity : 1,
    // With a file, coordinates are not rounded.
    obj: true,
    transfer: true,
    signal,
  });
}

/** The report with what was found out about each chart elsewhere. */
export function withVerdict(
  { report, chartOfTriangle }: UnwrapResult,
  found: UnwrapResult,
  atlas: UnwrapReport['atlas'],
): UnwrapReport {
  const charts = [...report.charts];
  chartOfTriangle.forEach((chart, f) => {
    const other = found.report.charts[found.chartOfTriangle[f]];
    if (!charts[chart] || !other) return;
    const { valid, problem } = other;
    charts[chart] = { ...report.charts[chart], valid, problem };
  });
  return { ...report, charts, atlas, valid: found.report.valid };
}

/**
 * Unwraps so that charts which were stacked are packed as one and stacked again. A stack whose
 * charts are cut anew is given up; then `unwrap` runs without any.
 */
export async function keepingStacks(
  earlier: Unwrapped,
  stacks: Stack[],
  options: UnwrapOptions,
  unwrap: (options: UnwrapOptions) => Promise<UnwrapResult>,
  runs: Runs,
): Promise<Judged> {
  const fixed = new Set(options.fixedCharts);
  // What is locked, or as in the file, stays, so the others come to it.
  const { charts } = earlier.result.report;
  const stays = (chart: number) => fixed.has(chart) || charts[chart].solver === 'given';
  const ordered = lowestFirst(stacks, stays);
  const upper = new Set(ordered.flatMap(([, ...others]) => others));
  const fixedCharts = options.fixedCharts?.filter((chart) => !upper.has(chart));
  const faceDensities = smallIn(earlier, upper, options.faceDensities);
  const packed = await unwrap({ ...options, fixedCharts, faceDensities });
  const uv = await runs.helpers.restacked(earlier.result, packed, ordered);
  if (!uv) return { result: await unwrap(options) };
  // The files are of the charts before they were stacked.
  const { obj: _obj, ply: _ply, ...rest } = packed;
  const placed = await judgedApart({ ...rest, uv }, runs);
  return placed.stacks ? withLocks(placed, earlier, fixed) : { result: await unwrap(options) };
}

const lowestFirst = (stacks: Stack[], isLowest: (chart: number) => boolean): Stack[] =>
  stacks.map((stack) => [...stack].sort((a, b) => Number(isLowest(b)) - Number(isLowest(a))));

/** Locked charts that lie on others have stayed with them. */
function withLocks({ result, stacks }: Judged, earlier: Unwrapped, locked: Set<number>): Judged {
  const isLocked = new Set<number>();
  earlier.result.chartOfTriangle.forEach((chart, f) => {
    if (locked.has(chart)) isLocked.add(result.chartOfTriangle[f]);
  });
  const charts = result.report.charts.map((chart, i) => ({
    ...chart,
    fixed: chart.fixed || isLocked.has(i),
  }));
  return { result: { ...result, report: { ...result.report, charts } }, stacks };
}

/** The densities asked for, where some charts are to be small. */
function smallIn(
  { result, mesh }: { result: UnwrapResult; mesh: DisplayMesh },
  small: Set<number>,
  asked: UnwrapOptions['faceDensities'],
): Float32Array {
  const { chartOfTriangle } = result;
  const { faces } = mesh;
  const count = faces ? faces[faces.length - 1] + 1 : chartOfTriangle.length;
  const out = asked ? Float32Array.from(asked) : new Float32Array(count).fill(1);
  const isDone = new Uint8Array(out.length);
  chartOfTriangle.forEach((chart, f) => {
    const face = faces ? faces[f] : f;
    if (!small.has(chart) || isDone[face]) return;
    isDone[face] = 1;
    out[face] *= SMALL;
  });
  return out;
}
