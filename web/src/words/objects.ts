// The tab of objects and materials.

import { count } from './format';

/** A kind of part: its column, its table, and what stands for a name that is missing. */
export interface PartWords {
  name: string;
  title: string;
  caption: string;
  unnamed(number: number): string;
  none: string;
}

export const PARTS: Record<'objects' | 'materials', PartWords> = {
  objects: {
    name: 'Object',
    title: 'By their names in the file. Copies of a mesh share its layout',
    caption: 'Objects',
    unnamed: (number) => `Object ${number}`,
    none: 'No object',
  },
  materials: {
    name: 'Material',
    title: 'By their names in the file',
    caption: 'Materials',
    unnamed: (number) => `Material ${number}`,
    none: 'No material',
  },
};

/** The other columns. */
export const PART_COLUMNS = {
  triangles: { name: 'Triangles', title: 'Number of triangles' },
  islands: { name: 'Islands', title: 'Islands that have triangles of it' },
  density: {
    name: 'Density',
    title: 'Texel density relative to the rest: 2 is twice as many texels along an edge',
  },
  actions: 'Visibility',
};

/** What can be done to a part, by its name. */
export const PART = {
  copies: (name: string, copies: number) => `${name} ×${count(copies)}`,
  shared: (copies: number) => `${count(copies)} copies, one layout`,
  aboutSelect: 'Click to select its islands, Shift-click to add or remove them',
  hide: (name: string) => `Hide ${name}`,
  isolate: (name: string) => `Isolate ${name}`,
  density: (name: string) => `Density of ${name}`,
  mixed: 'mixed',
  more: (n: number) => `${count(n)} more are not listed`,
};
