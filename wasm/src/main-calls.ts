// The calls of the main module in the calling thread.

import {
  compareCall,
  flattenCall,
  inspectCall,
  loadCall,
  pinWeightsCall,
  sampleCall,
  unwrapCall,
} from './calls.js';
import { checkVersion } from './load-module.js';
import type { LocalModule } from './local-module.js';
import type { Description } from './messages/protocol.js';
import type { AbflatSingle } from './types/index.js';

export function mainCalls(main: LocalModule): AbflatSingle {
  const request = { kind: 'describe' } as const;
  const description = main.answer<Description>({ request, settings: {} });
  checkVersion(description);
  return {
    build: description.build,
    flatten: (mesh, settings = {}) => main.answer(flattenCall(main, mesh, settings)),
    unwrap: (mesh, settings = {}) => main.answer(unwrapCall(main, mesh, settings)),
    compare: (mesh, settings = {}) => main.answer(compareCall(main, mesh, settings)),
    inspect: (mesh, settings = {}) => main.answer(inspectCall(main, mesh, settings)),
    pinWeights: (mesh, pins, settings = {}) =>
      main.answer(pinWeightsCall(main, mesh, pins, settings)),
    load: (file, settings = {}) => main.answer(loadCall(main, file, settings)),
    sample: (name, settings = {}) => main.answer(sampleCall(main, name, settings)),
    terminate: () => main.terminate(),
  };
}
