// Charts that are selected, moved and pinned.

import { LOCKS } from './charts';
import { count, counted, measure } from './format';

/** Charts that are selected or hidden. */
export const SELECTION = {
  hidden: (charts: number) => `${counted(charts, 'island')} hidden`,
  one: (chart: number, triangles: number, stretch: number) =>
    `Island ${count(chart)}: ${counted(triangles, 'triangle')}, stretch ${measure(stretch)}`,
  several: (charts: number, triangles: number, share: number) => {
    const percent = `${(100 * share).toFixed(0)}\u202f%`;
    return `${counted(charts, 'island')}: ${counted(triangles, 'triangle')}, ${percent} of the surface`;
  },
  none: 'Select an island first',
  locked: 'Locked islands stay. Unlock them to move them',
  keptUvs: LOCKS.keptUvs,
  density: 'Density',
  mixedDensity: 'mixed',
  densityOfOne: (chart: number, density: number) => `Set density ${density} on island ${chart}`,
  densityOfSeveral: (charts: number, density: number) =>
    `Set density ${density} on ${counted(charts, 'island')}`,
};

/** What was done to charts, by the names of the menu's entries. */
export const ARRANGED = {
  move: 'Moved',
  turn: 'Rotated',
  scale: 'Scaled',
  left: 'Rotated',
  right: 'Rotated',
  straightened: 'Aligned',
  stacked: 'Stacked',
  evened: 'Evened out',
};

/** Charts that are put on each other. */
export const STACKING = {
  noneFits: 'Nothing was stacked: no two of these islands have the same shape',
  done: (stacked: number, all: number) => {
    const other = all - stacked;
    const but =
      other > 0 ? `; ${other} ${other === 1 ? 'has another shape' : 'have other shapes'}` : '';
    return `Stacked ${counted(stacked, 'island')}${but}`;
  },
};

/** Charts that are moved. Numbers come as text. */
export const MOVING = {
  doneToOne: (done: string, chart: number) => `${done} island ${chart}`,
  doneToSeveral: (done: string, charts: number) => `${done} ${counted(charts, 'island')}`,
  /** What is typed, as long as it is no number. */
  typed: (typed: string) => ` ${typed}…`,
  turn: (degrees: string) => `Rotate ${degrees}°`,
  scale: (factor: string) => `Scale ×${factor}`,
  along: (axis: string, distance: string) => `${axis} ${distance}`,
  /** `shift` is listed by axis. */
  move: (shift: string, texels: string) => `Move ${shift} (${texels} texels)`,
  failed: (message: string) => `The islands were not moved: ${message}`,
  nothingMoved: 'Nothing was moved',
};

/** Islands of a file that are packed around the others. */
export const PACKING = {
  doing: 'Repacking…',
  done: (islands: number, all: number) =>
    `Repacked ${counted(islands, 'island')}${islands < all ? `; ${count(all - islands)} stay` : ''}`,
  tiles: {
    one: 'One',
    file: 'As they are',
    object: 'Per object',
    material: 'Per material',
  },
  aboutTiles:
    'The UDIM tiles that islands are packed in: one, those that they are in, or one for each object or material',
  scope: (islands: number) => (islands === 0 ? '' : `${count(islands)} selected`),
};

/** Vertices of the layout that are pinned. */
export const PINS = {
  invitation: 'Click a vertex to pin it',
  some: (pins: number) =>
    pins === 1
      ? '1 pin. Drag it to move its island, click it to remove it'
      : `${counted(pins, 'pin')}. Drag one to bend its island, click it to remove it`,
  pinned: (chart: number) => `Pinned a vertex of island ${chart}`,
  removed: (chart: number) => `Removed a pin of island ${chart}`,
  removedAll: (pins: number) => `Removed ${counted(pins, 'pin')}`,
  moved: (chart: number) => `Moved a pin of island ${chart}`,
  notMoved: (message: string) => `The pin was not moved: ${message}`,
  locked: 'This island is locked. Unlock it to drag its pins',
  keptUvs: LOCKS.keptUvs,
};
