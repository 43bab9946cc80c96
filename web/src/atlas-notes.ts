import type { RepairReport, UnwrapReport } from 'abflat';
import { count, counted, measure, sentence } from './format';

/** Places that are named before it gets long. */
const NAMED = 3;

/** What is worth knowing about an atlas beyond its numbers, one sentence each: what is not valid, what was repaired, what was done to get it. */
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
    .map(({ firstFace, problem }) => `chart with face ${firstFace}: ${problem}`);
  const more = bad.length - named.length;
  return more > 0
    ? [...named, `${counted(more, 'more chart is', 'more charts are')} not valid`]
    : named;
}

/** One for each kind of defect. The mesh that is exported keeps all of it. */
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
        `${counted(mergedVertices, 'vertex lies', 'vertices lie')} where another one does: taken as one`,
    ],
    [
      collapsedFaces.length,
      () =>
        `${counted(collapsedFaces.length, 'face has', 'faces have')} fewer than three corners: uv of the neighbours, ${faces(collapsedFaces)}`,
    ],
    [
      splitFaces.length,
      () =>
        `${counted(splitFaces.length, 'face touches itself', 'faces touch themselves')}: split there, ${faces(splitFaces)}`,
    ],
    [
      duplicateFaces.length,
      () =>
        `${counted(duplicateFaces.length, 'face repeats', 'faces repeat')} another one: in charts of their own, ${faces(duplicateFaces.map(([face]) => face))}`,
    ],
    [
      nonManifoldEdges.length,
      () =>
        `${counted(nonManifoldEdges.length, 'edge has', 'edges have')} more than two faces: cut, ${edges(nonManifoldEdges)}`,
    ],
    [
      orientationConflicts.length,
      () =>
        `${counted(orientationConflicts.length, 'edge lies', 'edges lie')} between faces that are turned over: cut, ${edges(orientationConflicts)}`,
    ],
    [
      degenerateTriangles,
      () =>
        `${counted(degenerateTriangles, 'triangle has', 'triangles have')} no area: laid out by made-up angles`,
    ],
  ];
  return kinds.filter(([size]) => size > 0).map(([, text]) => text());
}

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
      `${counted(filledHoles, 'hole takes', 'holes take')} no seam: laid out as if filled`,
    );
  return notes;
}

/** Alike ones once, with their number. */
function fallbacks({ charts }: UnwrapReport): string[] {
  const counts = new Map<string, number>();
  for (const chart of charts)
    for (const text of new Set(chart.fallbacks)) counts.set(text, (counts.get(text) ?? 0) + 1);
  return [...counts].map(([text, number]) => `${counted(number, 'chart')}: ${text}`);
}
