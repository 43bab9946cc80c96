// Above, on and below the views.

import { type Bound, bound, count, counted, measure } from './format';

export const GRID = {
  notDrawn: 'This browser cannot draw the numbered grid.',
  lines: (texels: number) => `grid ${counted(texels, 'texel')}`,
  cells: (texels: number) => `cells of ${counted(texels, 'texel')}`,
};

export const SHADINGS = {
  materials: 'Materials',
  image: (name: string) => `Image: ${name}`,
  otherImage: 'Other image\u2026',
};

/** The measures of the heat maps. */
export const HEAT_MAPS = {
  angle: {
    title: 'Angle error',
    explanation: 'Relative change of a triangle’s angles',
  },
  area: {
    title: 'Area',
    explanation: 'UV area divided by 3D area; below 1, a face has fewer texels than average',
  },
  stretch: {
    title: 'Stretch',
    explanation: 'Symmetric Dirichlet energy / 4 of each triangle; 1 keeps all lengths',
  },
  texels: {
    title: 'Texels per unit',
    explanation: 'Texels along an edge per unit of the mesh; in one piece, relative to the average',
  },
};

/** `title`: what is measured; values and shares come as texts. */
export const HEAT_LEGEND = {
  andLess: (value: string) => `${value} or less`,
  andMore: (value: string) => `${value} or more`,
  fromTo: (title: string, from: string, to: string) => `${title} ${from} to ${to}`,
  percent: (value: string) => `${value}\u202f%`,
  underPercent: (value: string) => `under ${value}\u202f%`,
  ofSurface: (range: string, share: string) => `${range}: ${share} of the surface`,
  selectBar: 'Click a bar to highlight its faces',
  worst: 'The worst 1\u202f% of the surface',
};

/** Meanings of marks. */
export const MARKS = {
  invalidCharts: (n: number) => counted(n, 'island is not valid', 'islands are not valid'),
  tightened: (n: number) => counted(n, 'tightened vertex', 'tightened vertices'),
  crossings: (n: number) => counted(n, 'crossing'),
  resisting: (n: number) => `${counted(n, 'edge')} cannot be made Delaunay`,
  delaunay: (before: number, after: number) =>
    `Delaunay: distortion ${measure(before)} \u2192 ${measure(after)}`,
};

/** What is on screen. */
export const SHOWN = {
  pageTitle: (title: string) => `${title} \u2013 abflat`,
  triangles: (triangles: number) => counted(triangles, 'triangle'),
  polygons: (faces: number, triangles: number) =>
    `${counted(faces, 'polygon')}, ${counted(triangles, 'triangle')}`,
  charts: (charts: number, tiles: number) =>
    counted(charts, 'island') + (tiles > 1 ? `, ${counted(tiles, 'tile')}` : ''),
  /** What charts look like. */
  shapes: {
    rectangle: (charts: number) => counted(charts, 'rectangle'),
    strip: (charts: number) => counted(charts, 'strip'),
    disc: (charts: number) => counted(charts, 'disc'),
    ring: (charts: number) => counted(charts, 'ring'),
  },
  symmetric: 'symmetric',
  packingCuts: (cuts: number) => `${count(cuts)} cut to pack tighter`,
  t: (t: Bound) => `t = ${bound(t)}`,
  /** `t` is null where the boundary is free, except at tightened vertices. */
  automaticT: (t: number | null, tightened: number) => {
    const but = tightened > 0 ? ` except at ${counted(tightened, 'vertex', 'vertices')}` : '';
    return `t = auto: ${t === null ? 'free' : bound(t)}${but}`;
  },
  owner: (title: string, settings: string) => `${title}, ${settings}`,
  previous: 'Previous layout',
  noLayout: 'No layout yet',
  stillShown: (what: string) => `Still showing ${what}.`,
  comparison: (method: string) => `Comparison, not exported: ${method}`,
  noMaterials: (name: string) =>
    `The materials of ${name} could not be read. To see them, open it again.`,
  noWebGl:
    'WebGL 2 is off or missing in this browser, so nothing can be drawn. Unwrapping and export still work.',
};
