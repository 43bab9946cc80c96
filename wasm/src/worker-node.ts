// Entry of the worker thread in Node.

import { parentPort } from 'node:worker_threads';
import { plain } from './glue-plain.js';
import { simd } from './glue-simd.js';
import type { ToWorker } from './messages/protocol.js';
import { serve } from './serve.js';
import { startsAny } from './start-any.js';

if (!parentPort) throw new Error('This file is the worker of abflat; import abflat instead.');
const port = parentPort;

// Threads only work in browsers.
serve(
  {
    post: (message, transfer = []) => port.postMessage(message, transfer),
    listen: (handle) => {
      port.on('message', (message: ToWorker) => handle(message));
    },
  },
  startsAny({ plain, simd }),
);
