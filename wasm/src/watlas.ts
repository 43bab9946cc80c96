// Entry for browsers, workers and bundlers: the names of watlas, with the layouts of abflat.

import { createAbflatSync } from './sync.js';
import type { AtlasOf } from './watlas/atlas.js';
import { watlasModule } from './watlas/module.js';

export { ChartType } from './watlas/chart-type.js';
export { createWatlas, type Watlas } from './watlas/create.js';
export type { Chart, Mesh } from './watlas/mesh.js';
export type * from './watlas/types.js';

export const { Initialize, Atlas } = watlasModule(createAbflatSync);
export type Atlas = AtlasOf;
