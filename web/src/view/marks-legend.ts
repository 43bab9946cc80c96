import type { DelaunayReport, VertexBound } from 'abflat';
import { create, element } from '../base/dom';
import { FAULTS, type UvFault } from '../colors/fault-colors';
import { ownBoundsText } from '../words/format';
import { UV_FAULTS } from '../words/result';
import { MARKS } from '../words/view';

/** The part of a report that is shown beside the layout. */
export interface Marked {
  bounds: VertexBound[];
  /** Vertices whose bound the user has chosen. */
  ownBounds?: number;
  boundaryCrossings: number;
  delaunay: DelaunayReport | null;
  angularDistortion: number | null;
  /** Charts of an atlas that overlap, are flipped or leave their tile. */
  invalidCharts?: number;
  /** Faces with faults in uv, which have the colours of these. */
  faults?: Partial<Record<UvFault, number>>;
}

/** Explains the marks in the views, if there are any, and what the Delaunay condition costs. */
export function showMarksLegend(marked: Marked | null): void {
  const lines = marked ? linesOf(marked) : [];
  const box = element('marks', HTMLElement);
  box.replaceChildren(
    ...lines.map(([mark, text]) => {
      const line = create('p', '');
      line.append(create('span', `mark ${mark}`), text);
      return line;
    }),
  );
  box.hidden = lines.length === 0;
}

/** Per line, the kind of mark and its meaning. */
function linesOf(marked: Marked): [string, string][] {
  const { bounds, boundaryCrossings, delaunay } = marked;
  const lines: [string, string][] = [];
  const { invalidCharts = 0, ownBounds = 0, faults = {} } = marked;
  for (const fault of FAULTS) {
    const faces = faults[fault] ?? 0;
    if (faces > 0) lines.push([fault, UV_FAULTS[fault](faces)]);
  }
  if (invalidCharts > 0) lines.push(['line', MARKS.invalidCharts(invalidCharts)]);
  if (ownBounds > 0) lines.push(['own', ownBoundsText(ownBounds)]);
  if (bounds.length > 0) lines.push(['dot', MARKS.tightened(bounds.length)]);
  if (boundaryCrossings > 0) lines.push(['ring', MARKS.crossings(boundaryCrossings)]);
  if (delaunay) lines.push(delaunayLine(marked.angularDistortion ?? 0, delaunay));
  return lines;
}

function delaunayLine(
  angularDistortion: number,
  { resisting, angularDistortionBefore }: DelaunayReport,
): [string, string] {
  if (resisting.length > 0) return ['line', MARKS.resisting(resisting.length)];
  return ['edge', MARKS.delaunay(angularDistortionBefore, angularDistortion)];
}
