// Entry of the worker thread in Node.

import { parentPort } from 'node:worker_threads';
import { isModule } from './base/build-of.js';
import { simd } from './glue-simd.js';
import { threads } from './glue-threads.js';
import type { ToWorker } from './messages/protocol.js';
import { serve } from './serve.js';
import { startsAny } from './start-any.js';
import { actAsWebWorker } from './web-worker-node.js';

if (!parentPort) throw new Error('This file is the worker of abflat; import abflat instead.');
const port = parentPort;
const start = startsAny({ simd, threads });

serve(
  {
    post: (message, transfer = []) => port.postMessage(message, transfer),
    listen: (handle) => {
      port.on('message', (message: ToWorker) => handle(message));
    },
  },
  (module, maxMemory) => {
    if (isModule(module, 'threads')) actAsWebWorker();
    return start(module, maxMemory);
  },
);
