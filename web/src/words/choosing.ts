// Charts that are chosen by an area, or by what they are.

import { count, counted, measure } from './format';

export const CHOOSING = {
  button: 'Select…',
  title: 'Select islands by an area, their material, stretch, shape and more',
  menu: 'Select islands',
  box: 'Box',
  lasso: 'Lasso',
  all: 'All',
  none: 'None',
  invert: 'Invert',
  material: 'Same material',
  group: 'Same object',
  shape: 'Same shape',
  overlapping: 'Overlapping',
  flipped: 'Flipped',
  stretched: 'Stretched beyond',
  about: {
    box: 'Drag a box: all islands that it touches are selected. Shift adds them',
    lasso: 'Draw around islands: all that it touches are selected. Shift adds them',
    invert: 'Select what is not selected, and nothing else',
    material: 'Add the islands with a material of the selected ones',
    group:
      'Add the islands of the objects that the selected ones are part of: those of an OBJ, or else connected parts',
    shape:
      'Add the islands with the outline of a selected one, turned, mirrored or of another size',
    overlapping: 'Select islands that overlap others or are stacked',
    flipped: 'Select islands with faces that are mirrored',
  },
  aboutStretched: (limit: number) => `Select islands whose stretch is above ${limit}`,
  toDraw: {
    box: 'Drag a box around islands; Esc cancels',
    lasso: 'Draw around islands; Esc cancels',
  },
  selected: (charts: number) => `Selected ${counted(charts, 'island')}`,
  noneInArea: 'No island is there',
  noneFound: {
    material: 'No other island has one of these materials',
    group: 'No other island is part of these objects',
    shape: 'No other island has this shape',
    overlapping: 'No islands overlap',
    flipped: 'No face is mirrored',
  },
  noneStretched: (limit: number, most: number) =>
    `No island is stretched beyond ${limit}; the most is ${measure(most)}`,
};

/** An edge of a chart's outline that is made level or upright. */
export const LEVELLING = {
  item: {
    text: 'Align edge',
    key: 'E',
    about: 'Rotate an island so that an edge of its outline is level or upright',
  },
  toChoose: 'Click an edge, or drag along an outline; Esc cancels',
  noEdge: 'There is no edge of an island here',
  isLevel: 'This edge is level or upright already',
  cancelled: 'Nothing was aligned',
};

/** Charts that get another shape in their place. */
export const RESHAPING = {
  rectify: {
    text: 'Rectify',
    about:
      'Make a grid of quads, or an island that is nearly a rectangle, exactly one, in its place',
  },
  relax: {
    text: 'Relax',
    about:
      'Lay each island out again, in its place, so that its lengths change as little as possible. Pins stay',
  },
  doing: { rectified: 'Rectifying…', relaxed: 'Relaxing…' },
  done: { rectified: 'Rectified', relaxed: 'Relaxed' },
  of: (done: string, charts: number[], left: number) => {
    const [chart] = charts;
    const which = charts.length === 1 ? `island ${chart}` : counted(charts.length, 'island');
    const others = left === 1 ? '; 1 stays as it is' : `; ${count(left)} stay as they are`;
    return `${done} ${which}${left > 0 ? others : ''}`;
  },
  none: (left: number) =>
    `${counted(left, 'island stays', 'islands stay')} as ${left === 1 ? 'it is' : 'they are'}`,
  /** `why` is that of each. */
  failed: ([chart, ...others]: number[], why: string) =>
    others.length === 0
      ? `Island ${chart} stays as it is: ${why}`
      : `${count(others.length + 1)} islands stay as they are, such as island ${chart}: ${why}`,
  mirrored: 'it is mirrored',
  stacked:
    'it lies on another island or on itself. Repack moves islands apart that are not stacked on purpose',
  noRectangle: 'its outline is not nearly a rectangle',
  touches: 'its outline touches itself',
};

/** Islands of a file that are mirrored in their places. */
export const FLIPPING = {
  item: {
    text: 'Flip',
    key: 'F',
    about: 'Mirror each island in its place, so that a flipped one is no longer flipped',
    isForFiles: true,
  } as const,
  done: 'Flipped',
  /** They have both kinds of faces, so a flip only changes which. */
  folded: ([island, ...others]: number[]) => {
    const still = 'faces that run either way, so some are flipped still. Try Relax';
    return others.length === 0
      ? `Island ${island} has ${still}`
      : `${count(others.length + 1)} islands, such as island ${island}, have ${still}`;
  },
};

/** Seams that are edited on both sides of a mesh. */
export const SYMMETRIC = {
  button: 'Symmetric',
  title: 'Cut and join on both sides: at the mirror image of each edge, too',
  noPlane: 'This mesh is not its own mirror image, so only the edges under the pointer change',
};
