import type { GestureKind } from '../arrange/gesture';
import { counted } from '../base/format';

/** What can be done to the selected charts, as the menu names it, and how it is said when it is done. */
const DONE = {
  move: 'Moved',
  turn: 'Turned',
  scale: 'Scaled',
  left: 'Turned',
  right: 'Turned',
  straightened: 'Straightened',
  stacked: 'Stacked',
  evened: 'Evened out',
};

export type ArrangeName = keyof typeof DONE;

export const isName = (name: string): name is ArrangeName => Object.hasOwn(DONE, name);

/** Whether the pointer or keys say how far. */
export const isGesture = (name: ArrangeName): name is GestureKind =>
  name === 'move' || name === 'turn' || name === 'scale';

/** "Moved chart 3", "Scaled 2 charts" */
export function movedText(charts: ReadonlySet<number>, how: ArrangeName): string {
  const [chart] = charts;
  return `${DONE[how]} ${charts.size === 1 ? `chart ${chart}` : counted(charts.size, 'chart')}`;
}
