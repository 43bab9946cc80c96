// The table of the UV islands of a file.

import { count, counted, listed } from './format';

export const ISLAND_COLUMNS = {
  island: { name: 'Island', title: 'Sort by number' },
  triangles: { name: 'Faces', title: 'Number of triangles' },
  area: { name: 'Area', title: "Share of the surface's area" },
  density: {
    name: 'Texels',
    title: 'Texels per mesh unit at this resolution, on average over the island',
  },
  faults: { name: 'Faults', title: 'Triangles with faults, and islands at the same place' },
};

/** Triangles with each fault, in the order in which they are listed. */
const FAULTS = {
  overlapping: (n: number) => counted(n, 'overlaps', 'overlap'),
  outside: (n: number) => `${count(n)} outside`,
  empty: (n: number) => `${count(n)} empty`,
  flipped: (n: number) => `${count(n)} flipped`,
};

export const ISLAND_LIST = {
  caption: 'UV islands of the file',
  faults: (faults: Record<keyof typeof FAULTS, number>, stackedWith: number[]) => {
    const names = Object.keys(FAULTS) as (keyof typeof FAULTS)[];
    const found = names.flatMap((name) => (faults[name] > 0 ? [FAULTS[name](faults[name])] : []));
    const stacked =
      stackedWith.length > 0 ? [`stacked with ${listed(stackedWith.map(count))}`] : [];
    return [...found, ...stacked].join(', ');
  },
};
