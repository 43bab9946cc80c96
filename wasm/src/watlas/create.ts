// What watlas exports, for an engine that is there or will be.

import { checkAbflat } from '../messages/validate.js';
import type { AbflatSync } from '../types/index.js';
import { AtlasOf, type MoreOptions } from './atlas.js';

/** What `unwrap({ watlas })` of glTF-Transform takes. */
export interface Watlas {
  /** Does nothing: the engine is there. */
  Initialize(): Promise<void>;
  Atlas: new () => AtlasOf;
}

/** The same as the module, with an engine and options of abflat that are the caller's. */
export function createWatlas(
  abflat: Pick<AbflatSync, 'unwrap' | 'pack'>,
  options: MoreOptions = {},
): Watlas {
  checkAbflat(abflat, 'unwrap');
  return {
    Initialize: () => Promise.resolve(),
    Atlas: class Atlas extends AtlasOf {
      constructor() {
        super(abflat, options);
      }
    },
  };
}
