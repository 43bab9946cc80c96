import type { ChartReport } from 'abflat';
import { create, element } from './dom';
import { counted } from './format';

/** Says what the marks in the views are, as far as there are any. */
export function showMarksLegend({ bounds, boundaryCrossings }: ChartReport): void {
  const lines: [string, string][] = [];
  if (bounds.length > 0)
    lines.push(['dot', counted(bounds.length, 'tightened vertex', 'tightened vertices')]);
  if (boundaryCrossings > 0) lines.push(['ring', counted(boundaryCrossings, 'crossing')]);
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
