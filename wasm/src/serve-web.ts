// Shared by the Web Workers.

import type { ToWorker } from './messages/protocol.js';
import { type Start, serve } from './serve.js';

export function serveWeb(start: Start): void {
  serve(
    {
      post: (message, transfer = []) => globalThis.postMessage(message, { transfer }),
      listen: (handle) => {
        globalThis.addEventListener('message', (event: MessageEvent<ToWorker>) =>
          handle(event.data),
        );
      },
    },
    start,
  );
}
