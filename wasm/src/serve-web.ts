// Shared by the Web Workers.

import type { Glues } from './glue.js';
import type { ToWorker } from './messages/protocol.js';
import { serve } from './serve.js';

export function serveWeb(glues: Glues): void {
  serve(
    {
      post: (message, transfer = []) => globalThis.postMessage(message, { transfer }),
      listen: (handle) => {
        globalThis.addEventListener('message', (event: MessageEvent<ToWorker>) =>
          handle(event.data),
        );
      },
    },
    glues,
  );
}
