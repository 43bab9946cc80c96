import type { RepairReport, UnwrapReport } from 'abflat';
import type { Unwrapped } from '../model/model';
import { ended, sentence } from '../words/format';
import { ATLAS_NOTES } from '../words/result';

/** The most places to name before the list gets too long. */
const NAMED = 3;

/**
 * What is worth knowing about an atlas beyond its numbers, one sentence each: what is not valid,
 * what there is to say about its file, what was repaired, and what was done to get it.
 */
export function atlasNotes({ result: { report }, gltf }: Unwrapped): string[] {
  const all = [
    ...problems(report),
    ...(gltf?.notes ?? []),
    ...repairs(report.repair),
    ...topology(report),
    ...report.notes,
    ...fallbacks(report),
  ];
  return all.map((note) => ended(sentence(note)));
}

function problems({ charts }: UnwrapReport): string[] {
  const bad = charts.filter(({ valid }) => !valid);
  const named = bad
    .slice(0, NAMED)
    .map(({ firstFace, problem }) => ATLAS_NOTES.problem(firstFace, problem));
  const more = bad.length - named.length;
  return more > 0 ? [...named, ATLAS_NOTES.moreProblems(more)] : named;
}

/** One note per kind of defect. The exported mesh keeps all defects. */
function repairs(repair: RepairReport): string[] {
  const faces = (list: number[]) => ATLAS_NOTES.faces(list.length, namesOf(list.map(String)));
  const edges = (list: [number, number][]) =>
    ATLAS_NOTES.edges(list.length, namesOf(list.map((ends) => ends.join('\u2013'))));
  const { mergedVertices, collapsedFaces, splitFaces, duplicateFaces } = repair;
  const { nonManifoldEdges, orientationConflicts, degenerateTriangles } = repair;
  const kinds: [number, (n: number) => string][] = [
    [mergedVertices, ATLAS_NOTES.merged],
    [collapsedFaces.length, (n) => ATLAS_NOTES.collapsed(n, faces(collapsedFaces))],
    [splitFaces.length, (n) => ATLAS_NOTES.split(n, faces(splitFaces))],
    [
      duplicateFaces.length,
      (n) => ATLAS_NOTES.duplicates(n, faces(duplicateFaces.map(([face]) => face))),
    ],
    [nonManifoldEdges.length, (n) => ATLAS_NOTES.nonManifold(n, edges(nonManifoldEdges))],
    [orientationConflicts.length, (n) => ATLAS_NOTES.conflicts(n, edges(orientationConflicts))],
    [degenerateTriangles, ATLAS_NOTES.noArea],
  ];
  return kinds.filter(([size]) => size > 0).map(([size, text]) => text(size));
}

/** The first names, and how many more there are. */
function namesOf(names: string[]): string {
  const shown = names.slice(0, NAMED).join(', ');
  return names.length > NAMED ? ATLAS_NOTES.andMore(shown, names.length - NAMED) : shown;
}

function topology({
  seams: { genus, handleLoops, handleLength, filledHoles },
}: UnwrapReport): string[] {
  const notes: string[] = [];
  if (handleLoops > 0) notes.push(ATLAS_NOTES.handles(genus, handleLoops, handleLength));
  if (filledHoles > 0) notes.push(ATLAS_NOTES.filledHoles(filledHoles));
  return notes;
}

/** Lists equal ones once, with their count. */
function fallbacks({ charts }: UnwrapReport): string[] {
  const counts = new Map<string, number>();
  for (const chart of charts)
    for (const text of new Set(chart.fallbacks)) counts.set(text, (counts.get(text) ?? 0) + 1);
  return [...counts].map(([text, number]) => ATLAS_NOTES.fallback(number, text));
}
