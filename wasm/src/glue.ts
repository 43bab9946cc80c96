import type createNative from './abflat.js';
import type { Build } from './base/builds.js';

/** The script that Emscripten wrote for a build. Minified names may differ between builds, so each module needs its own. */
export interface Glue {
  create: typeof createNative;
  /** What a thread loads, of a build that has them. */
  threadScript?: () => string;
}

/** Those that a worker brings along: who loads one build does not load the scripts of the others. */
export type Glues = Partial<Record<Build, Glue>>;
