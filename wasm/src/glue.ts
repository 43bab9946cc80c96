import type createNative from './abflat.js';
import type { Build } from './base/builds.js';

/** The script that Emscripten wrote for a build. Minified names may differ between builds, so each module needs its own. */
export interface Glue {
  create: typeof createNative;
  /** The script that each thread loads, for a build with threads. */
  threadScript?: () => string;
}

/** The builds that a worker brings along: loading one does not load the scripts of the others. */
export type Glues = Partial<Record<Build, Glue>>;
