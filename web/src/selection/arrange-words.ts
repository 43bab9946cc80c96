import type { GestureKind } from '../arrange/gesture';
import { ARRANGED, MOVING, SELECTION } from '../words/selection';

/** What can be done to the selected charts, as the menu names it. */
export type ArrangeName = keyof typeof ARRANGED;

export const isName = (name: string): name is ArrangeName => Object.hasOwn(ARRANGED, name);

/** Whether the pointer or keys say how far. */
export const isGesture = (name: ArrangeName): name is GestureKind =>
  name === 'move' || name === 'turn' || name === 'scale';

/** "Moved chart 3", "Scaled 2 charts" */
export function movedText(charts: ReadonlySet<number>, how: ArrangeName): string {
  const [chart] = charts;
  const done = ARRANGED[how];
  return charts.size === 1
    ? MOVING.doneToOne(done, chart)
    : MOVING.doneToSeveral(done, charts.size);
}

/** "Set density 2 on chart 3" */
export function densityText(charts: ReadonlySet<number>, density: number): string {
  const [chart] = charts;
  return charts.size === 1
    ? SELECTION.densityOfOne(chart, density)
    : SELECTION.densityOfSeveral(charts.size, density);
}
