// Compares published figures of other unwrappers with ours: marks where a row is worse than its
// reference.

import { readFileSync } from 'node:fs';

const TABLES = JSON.parse(readFileSync(new URL('published.json', import.meta.url), 'utf8'));

/** How much angular quality may be lost to gain area quality. */
const ANGULAR_SLACK = 0.015;
/** How much longer the seams of one mesh may be than those of OptCuts. */
const SEAM_SLACK = 1.2;
/** How many times faster than each program it must be. */
const FASTER = { PartUV: 10, OptCuts: 50 };

const rowOf = (columns, figures) =>
  Object.fromEntries(columns.map((column, i) => [column, figures[i]]));

/** [{ mesh, rows: [{ program, seconds, charts, ... }] }] and where the figures come from. */
export function publishedUnwrappers() {
  const { source, columns, meshes } = TABLES.unwrappers;
  const tables = Object.entries(meshes).map(([mesh, programs]) => ({
    mesh,
    rows: Object.entries(programs).map(([program, figures]) => ({
      program,
      ...rowOf(columns, figures),
    })),
  }));
  return { source, tables };
}

/** [{ mesh, seconds, charts, seam3, sd }] and where the figures come from. */
export function publishedOptCuts() {
  const { source, columns, meshes } = TABLES.optcuts;
  const rows = Object.entries(meshes).map(([mesh, figures]) => ({
    mesh,
    ...rowOf(columns, figures),
  }));
  return { source, rows };
}

/**
 * Names of the columns in which a row of ours is worse than PartUV's, as far as both are printed.
 */
export function worseThanPartUv(row, reference) {
  const atMost = ['charts', 'seam', 'area', 'areaOverall'].filter(
    (column) => row[column] > reference[column],
  );
  if (row.angular < reference.angular - ANGULAR_SLACK) atMost.push('angular');
  if (row.seconds > reference.seconds / FASTER.PartUV) atMost.push('seconds');
  return atMost;
}

/** The same compared with OptCuts. The number of charts is judged by the mean over all meshes. */
export function worseThanOptCuts(row, reference) {
  const worse = row.seam3 > SEAM_SLACK * reference.seam3 ? ['seam3'] : [];
  if (row.sd > reference.sd) worse.push('sd');
  if (row.seconds > reference.seconds / FASTER.OptCuts) worse.push('seconds');
  return worse;
}

/**
 * Among runs with several bounds, the one with the largest bound that is not stretched more than
 * the reference, or else the least stretched.
 */
export function mostStretched(runs, reference) {
  const good = runs.filter(({ sd }) => sd <= reference.sd);
  if (good.length === 0) return runs.toSorted((a, b) => a.sd - b.sd)[0];
  return good.toSorted((a, b) => b.maxStretch - a.maxStretch)[0];
}

/** The arguments without these options and their values. */
export function withoutOptions(args, names) {
  return args.filter((arg, i) => {
    const isOne = (text) => names.some((name) => text === name || text?.startsWith(`${name}=`));
    return !isOne(arg) && !names.includes(args[i - 1]);
  });
}
