// Entry of the Web Worker.

import type { ToWorker } from './protocol.js';
import { serve } from './serve.js';

serve({
  post: (message, transfer = []) => globalThis.postMessage(message, { transfer }),
  listen: (handle) => {
    globalThis.addEventListener('message', (event: MessageEvent<ToWorker>) => handle(event.data));
  },
});
