// Entry of a thread of the build `threads` in Node: runs Emscripten's script as a Web Worker does.

import { parentPort, type TransferListItem, workerData } from 'node:worker_threads';
import { actAsWebWorker } from './web-worker-node.js';

if (!parentPort) throw new Error('This file is a thread of abflat; import abflat instead.');
const port = parentPort;
const here = globalThis as unknown as {
  postMessage(message: unknown, transfer?: TransferListItem[]): void;
  onmessage?: (event: { data: unknown }) => void;
};

actAsWebWorker();
here.postMessage = (message, transfer) => port.postMessage(message, transfer);
// Messages that arrive while the script is being loaded wait in the port.
await import(workerData as string);
port.on('message', (data: unknown) => here.onmessage?.({ data }));
