import type { RepairReport, UnwrapReport } from 'abflat';
import { count, counted, measure, sentence } from '../base/format';

/** The most places to name before the list gets too long. */
const NAMED = 3;

/**
 * What is worth knowing about an atlas beyond its numbers, one sentence each: what is not valid,
 * what was repaired, and what was done to get it.
 */
export function atlasNotes(report: UnwrapReport): string[] {
  const all = [
    ...problems(report),
    ...repairs(report.repair),
    ...topology(report),
    ...report.notes,
    ...fallbacks(report),
  ];
  return all.map((note) => `${sentence(note).replace(/\.$/, '')}.`);
}

function problems({ charts }: UnwrapReport): string[] {
  const bad = charts.filter(({ valid }) => !valid);
  const named = bad
    .slice(0, NAMED)
    .map(({ firstFace, problem }) => `chart containing face ${firstFace}: ${problem}`);
  const more = bad.length - named.length;
  return more > 0
    ? [...named, `${counted(more, 'more chart is', 'more charts are')} not valid`]
    : named;
}

/** One note per kind of defect. The exported mesh keeps all defects. */
function repairs(repair: RepairReport): string[] {
  const faces = (list: number[]) => places('face', list.map(String));
  const edges = (list: [number, number][]) =>
    places(
      'edge',
      list.map((ends) => ends.join('\u2013')),
    );
  const { mergedVertices, collapsedFaces, splitFaces, duplicateFaces } = repair;
  const { nonManifoldEdges, orientationConflicts, degenerateTriangles } = repair;
  const kinds: [number, () => string][] = [
    [
      mergedVertices,
      () =>
        `${counted(mergedVertices, 'duplicate vertex was', 'duplicate vertices were')} treated as one`,
    ],
    [
      collapsedFaces.length,
      () =>
        `${counted(collapsedFaces.length, 'degenerate face uses', 'degenerate faces use')} the UVs of neighbouring faces: ${faces(collapsedFaces)}`,
    ],
    [
      splitFaces.length,
      () =>
        `${counted(splitFaces.length, 'face touches itself and was split', 'faces touch themselves and were split')} there: ${faces(splitFaces)}`,
    ],
    [
      duplicateFaces.length,
      () =>
        `${counted(duplicateFaces.length, 'duplicate face has its own chart', 'duplicate faces have their own charts')}: ${faces(duplicateFaces.map(([face]) => face))}`,
    ],
    [
      nonManifoldEdges.length,
      () =>
        `${counted(nonManifoldEdges.length, 'edge has', 'edges have')} more than two faces and ${became(nonManifoldEdges)}: ${edges(nonManifoldEdges)}`,
    ],
    [
      orientationConflicts.length,
      () =>
        `${counted(orientationConflicts.length, 'edge lies', 'edges lie')} between faces of opposite orientation and ${became(orientationConflicts)}: ${edges(orientationConflicts)}`,
    ],
    [
      degenerateTriangles,
      () =>
        `${counted(degenerateTriangles, 'triangle has', 'triangles have')} no area and got artificial angles`,
    ],
  ];
  return kinds.filter(([size]) => size > 0).map(([, text]) => text());
}

const became = ({ length }: unknown[]) => (length === 1 ? 'became a seam' : 'became seams');

function places(what: string, names: string[]): string {
  const shown = names.slice(0, NAMED).join(', ');
  const more = names.length > NAMED ? ` and ${count(names.length - NAMED)} more` : '';
  return `${what}${names.length === 1 ? '' : 's'} ${shown}${more}`;
}

function topology({
  seams: { genus, handleLoops, handleLength, filledHoles },
}: UnwrapReport): string[] {
  const notes: string[] = [];
  if (handleLoops > 0)
    notes.push(
      `${genus > 0 ? `genus ${genus}: ` : ''}handles are cut open by ${counted(handleLoops, 'loop')} of length ${measure(handleLength)}`,
    );
  if (filledHoles > 0)
    notes.push(
      `${counted(filledHoles, 'hole was treated as filled and needs no seam', 'holes were treated as filled and need no seams')}`,
    );
  return notes;
}

/** Lists equal ones once, with their count. */
function fallbacks({ charts }: UnwrapReport): string[] {
  const counts = new Map<string, number>();
  for (const chart of charts)
    for (const text of new Set(chart.fallbacks)) counts.set(text, (counts.get(text) ?? 0) + 1);
  return [...counts].map(([text, number]) => `${counted(number, 'chart')}: ${text}`);
}
