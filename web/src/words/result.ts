// How good a layout is.

import { bound, count, counted, measure } from './format';

export const BADGES = {
  valid: 'Valid',
  uneven: 'Uneven',
  stretched: 'Stretched',
  notValid: 'Not valid',
  asInFile: 'As in file',
  none: 'No result',
} as const;

/** Why a result has its badge. */
export const VERDICT = {
  noCrossings: 'No flipped triangles, no crossings',
  noOverlaps: 'No flipped triangles, no overlaps',
  stacked: (charts: number) => `${counted(charts, 'island')} stacked, no other overlaps`,
  uneven: (least: number, most: number) =>
    `Texel density ${measure(least)} to ${measure(most)}: repack to even out`,
  unevenBesideKept: (least: number, most: number) =>
    `Texel density ${measure(least)} to ${measure(most)}: kept UVs keep theirs`,
  lengthsChange: (share: number) =>
    `Lengths change by ${count(100 * share)}\u202f% on average: seams would help`,
  stretched: (most: string, limit: number, charts: number, all: number) => {
    const upTo = charts > 1 ? 'up to ' : '';
    const where = all > 1 ? ` in ${count(charts)} of ${count(all)} islands` : '';
    return `Stretch ${upTo}${most}${where}; limit ${limit}`;
  },
  outside: (charts: number) =>
    `${counted(charts, 'island')} outside ${charts === 1 ? 'its tile' : 'their tiles'}`,
  overlapping: (charts: number) => counted(charts, 'island overlaps another', 'islands overlap'),
  /** `problem` is that of the first. */
  defects: (charts: number, problem: string) =>
    charts === 1
      ? `1 island is not valid: ${problem}`
      : `${count(charts)} islands are not valid. In the first, ${problem}`,
};

/** The UVs of a file. */
export const ISLANDS = {
  noFaults: 'No flipped faces, no overlaps',
  packed: (stacked: number, mirrored: number) => {
    const overlaps =
      stacked > 0 ? `${counted(stacked, 'island')} stacked, no other overlaps` : 'No overlaps';
    return mirrored > 0 ? `${overlaps}, ${count(mirrored)} mirrored` : overlaps;
  },
  summary: (islands: number, stacked: number, mirrored: number, separated: number) =>
    [
      counted(islands, 'UV island'),
      ...(stacked > 0 ? [`${count(stacked)} on others`] : []),
      ...(mirrored > 0 ? [`${count(mirrored)} mirrored`] : []),
      ...(separated > 0 ? [`${count(separated)} overlapping others slightly`] : []),
    ].join(', '),
  unmapped: (faces: number) =>
    `${counted(faces, 'face has', 'faces have')} no UVs and ${faces === 1 ? 'is' : 'are'} not drawn in the layout`,
  info: (islands: number, tiles: number) =>
    counted(islands, 'island') + (tiles > 1 ? `, ${counted(tiles, 'tile')}` : ''),
};

/** How many faces have a fault in uv. */
export const UV_FAULTS = {
  overlapping: (n: number) => counted(n, 'face overlaps', 'faces overlap'),
  outside: (n: number) => `${counted(n, 'face')} outside the square`,
  empty: (n: number) => `${counted(n, 'face')} without area`,
  stacked: (n: number) => `${counted(n, 'face')} stacked`,
  flipped: (n: number) => `${counted(n, 'face')} flipped`,
};

/** What is wrong with a chart, in the words of abflat. */
export const DEFECTS = { both: (one: string, other: string) => `${one}, and ${other}` };

/** What the user can do about a verdict. */
export const REMEDIES = {
  cut: {
    label: 'Cut further',
    title: 'Keep these seams and add automatic ones until every island is within the limit',
  },
  pack: {
    label: 'Repack',
    title: 'Pack the same islands again, all at the same texel density',
  },
  islands: { label: 'Repack', title: 'Pack the UV islands again; they keep their shapes' },
  unwrap: { label: 'Unwrap', title: 'Cut the mesh into islands that stretch less' },
};

/** The numbers of a layout in one piece. */
export const DISK_METRICS = {
  angle: {
    label: 'Angular distortion',
    title: 'Mean over all corners of ((x - α)/α)², x in the layout, α in 3D',
  },
  length: {
    label: 'Length distortion',
    title:
      'Mean over all edges of (sL/l - 1)², L in the layout, l in 3D, s the ratio of their sums',
  },
  stretch: {
    label: 'Stretch',
    title: 'Symmetric Dirichlet energy / 4, mean over the surface; 1 keeps all lengths',
  },
  crossings: { label: 'Crossings', title: 'Pairs of boundary edges that cross or touch' },
  flipped: {
    label: 'Flipped',
    title: 'Triangles of the layout that are not positively oriented',
  },
  steps: { label: 'Newton steps', title: 'Steps of the solver' },
};

/** The numbers of an atlas. */
export const ATLAS_METRICS = {
  charts: { label: 'Islands', title: 'Islands in the atlas; red if one is not valid' },
  seamLength: {
    label: 'Seam length',
    title:
      'Divided by the square root of the surface area, so it does not depend on the size of the mesh',
  },
  stretch: {
    label: 'Stretch',
    title:
      'Symmetric Dirichlet energy / 4, mean over the surface, each island at its own scale; 1 keeps all lengths. The stretch ratio in Details ignores changes of size; there, 1 keeps all angles',
  },
  angle: {
    label: 'Angular distortion',
    title: 'Mean over the surface of ((x - α)/α)², x in the layout, α in 3D',
  },
  utilization: {
    label: 'Space used',
    title: 'Share of the square, or of all tiles, that the islands cover',
  },
  texelDensity: {
    label: 'Texels per unit',
    title: 'Texels per mesh unit at this resolution, on average over the surface',
  },
};

/** The numbers of the UVs of a file. */
export const ISLAND_METRICS = {
  islands: {
    label: 'Islands',
    title: 'Sets of faces joined where they have an edge, with the same UVs on both sides',
  },
  overlapping: { label: 'Overlapping', title: 'Faces that overlap another one, or themselves' },
  outside: {
    label: 'Outside',
    title:
      'Faces that are not within the square or, where all islands lie in UDIM tiles, within one of them',
  },
  stacked: {
    label: 'Stacked',
    title: 'Faces of islands that lie on each other with the same outline',
  },
  flipped: { label: 'Flipped', title: 'Faces that run clockwise, be it with their whole island' },
  empty: { label: 'Empty', title: 'Faces without area in UV' },
  utilization: {
    label: 'Space used',
    title: 'Share of the square, or of all tiles around the layout, that the islands cover',
  },
};

/** The numbers of every layout. */
export const METRICS = {
  faces: { label: 'Faces', title: 'Faces of the input: triangles, quads and larger polygons' },
  energy: {
    label: 'Energy',
    title:
      'Energy minimised for the balance b, averaged over the refined surface, before and after: (1 - b)·(σ₁/σ₂ + σ₂/σ₁)/2 + b·(σ₁² + σ₂² + 1/σ₁² + 1/σ₂²)/4',
  },
  time: { label: 'Time', title: 'Total time in the worker, including reading and writing' },
  toWorst: (title: string) => `${title}. Click to see where it is worst`,
  notes: (n: number) => counted(n, 'note'),
  previous: 'Figures of the previous layout',
  ofResult: "Figures of abflat's layout",
};

/** The notes on an atlas; `places` name faces or edges. */
export const ATLAS_NOTES = {
  problem: (face: number, problem: string) => `island containing face ${face}: ${problem}`,
  moreProblems: (n: number) => `${counted(n, 'more island is', 'more islands are')} not valid`,
  merged: (n: number) =>
    `${counted(n, 'duplicate vertex was', 'duplicate vertices were')} treated as one`,
  collapsed: (n: number, places: string) =>
    `${counted(n, 'degenerate face uses', 'degenerate faces use')} the UVs of neighbouring faces: ${places}`,
  split: (n: number, places: string) =>
    `${counted(n, 'face touches itself', 'faces touch themselves')}: ${places}`,
  duplicates: (n: number, places: string) =>
    `${counted(n, 'duplicate face has its own island', 'duplicate faces have their own islands')}: ${places}`,
  nonManifold: (n: number, places: string) =>
    `${counted(n, 'edge has', 'edges have')} more than two faces and ${n === 1 ? 'became a seam' : 'became seams'}: ${places}`,
  conflicts: (n: number, places: string) =>
    `${counted(n, 'edge lies', 'edges lie')} between faces of opposite orientation and ${n === 1 ? 'became a seam' : 'became seams'}: ${places}`,
  noArea: (n: number) =>
    `${counted(n, 'triangle has', 'triangles have')} no area and ${n === 1 ? 'was' : 'were'} given artificial angles`,
  faces: (n: number, names: string) => `${n === 1 ? 'face' : 'faces'} ${names}`,
  edges: (n: number, names: string) => `${n === 1 ? 'edge' : 'edges'} ${names}`,
  andMore: (names: string, more: number) => `${names} and ${count(more)} more`,
  handles: (genus: number, loops: number, length: number) =>
    `${genus > 0 ? `genus ${genus}: ` : ''}handles are cut open by ${counted(loops, 'loop')} of length ${measure(length)}`,
  filledHoles: (n: number) =>
    counted(
      n,
      'hole was treated as filled and needs no seam',
      'holes were treated as filled and need no seams',
    ),
  fallback: (charts: number, text: string) => `${counted(charts, 'island')}: ${text}`,
};

/** The notes on a layout in one piece. */
export const DISK_NOTES = {
  delaunay: (
    edges: number,
    violated: [before: number, now: number],
    distortion: [before: number, now: number],
  ) => {
    const before = `${count(violated[0])} of ${counted(edges, 'interior edge')} before`;
    const change = `angular distortion ${measure(distortion[0])} before, ${measure(distortion[1])} now`;
    return `edges that are not Delaunay: ${before}, ${count(violated[1])} now; ${change}`;
  },
  tightened: (n: number, least: number) => {
    const vertices = counted(n, 'boundary vertex was', 'boundary vertices were');
    return `${vertices} tightened, ${n === 1 ? '' : 'down '}to t\u00a0=\u00a0${bound(least)}`;
  },
};
