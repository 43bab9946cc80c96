// The module's own engine, which Initialize loads.

import { AbflatError } from '../base/errors.js';
import { startOnce } from '../base/start-once.js';
import type { AbflatSync, CreateSyncOptions } from '../types/index.js';
import { AtlasOf } from './atlas.js';

export interface WatlasModule {
  /**
   * Loads the engine, once; `options` are those of `createAbflatSync`. Needed before the first
   * atlas.
   */
  Initialize(options?: CreateSyncOptions): Promise<void>;
  Atlas: new () => AtlasOf;
}

export function watlasModule(
  create: (options: CreateSyncOptions) => Promise<AbflatSync>,
): WatlasModule {
  let engine: AbflatSync | undefined;
  let options: CreateSyncOptions = {};
  const starting = startOnce(async () => {
    engine = await create({ also: ['pack'], ...options });
  });
  return {
    Initialize: (given = {}) => {
      options = given;
      return starting.get();
    },
    Atlas: class Atlas extends AtlasOf {
      constructor() {
        if (!engine)
          throw new AbflatError('InvalidOption', 'Call Initialize() and await it before this.');
        super(engine, {});
      }
    },
  };
}
