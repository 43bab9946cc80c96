// The worker's side of the protocol, the same in browsers and Node.

import { AbflatError, messageOf } from './base/errors.js';
import { KEPT_MEMORY } from './base/memory.js';
import type { Answer, AnyProgress, FromWorker, Request, ToWorker } from './messages/protocol.js';

/** About 30 a second. */
const PROGRESS_PAUSE_MS = 33;

export interface Port {
  post(message: FromWorker, transfer?: ArrayBuffer[]): void;
  listen(handle: (message: ToWorker) => void): void;
}

/** What answers calls. */
interface Engine {
  readonly heapBytes: number;
  readonly isBroken: boolean;
  run(request: Request, onProgress?: (progress: AnyProgress) => void): Answer;
}

export type Start = (module: WebAssembly.Module, maxMemory: number) => Promise<Engine>;

export function serve(port: Port, start: Start): void {
  let engine: Promise<Engine> | undefined;
  port.listen((message) => {
    if (message.type === 'start') {
      engine = start(message.module, message.maxMemory);
      engine.catch(() => undefined); // the first call reports it
    } else {
      void answer(port, message.request, engine);
    }
  });
}

async function answer(port: Port, request: Request, starting?: Promise<Engine>): Promise<void> {
  let engine: Engine | undefined;
  try {
    engine = await starting;
    if (!engine) throw new Error('the worker was not started');
    const wantsProgress = 'wantsProgress' in request && request.wantsProgress;
    const post = (progress: AnyProgress) => port.post({ type: 'progress', progress });
    const value = engine.run(request, wantsProgress ? throttle(post) : undefined);
    const isSpent = engine.heapBytes > KEPT_MEMORY;
    port.post({ type: 'done', answer: value, isSpent }, buffersOf(value));
  } catch (error) {
    const code = error instanceof AbflatError ? error.code : 'Internal';
    const isSpent = engine === undefined || engine.isBroken || engine.heapBytes > KEPT_MEMORY;
    port.post({ type: 'failed', code, message: messageOf(error), isSpent });
  }
}

/**
 * Passes on the first message of each stage and the last of all, and the others at most once per
 * PROGRESS_PAUSE_MS.
 */
function throttle(post: (progress: AnyProgress) => void): (progress: AnyProgress) => void {
  let stage: AnyProgress['stage'] | undefined;
  let last = Number.NEGATIVE_INFINITY;
  return (progress) => {
    const now = performance.now();
    const isEdge = progress.stage !== stage || progress.fraction === 1;
    if (!isEdge && now - last < PROGRESS_PAUSE_MS) return;
    stage = progress.stage;
    last = now;
    post(progress);
  };
}

function buffersOf(value: Answer): ArrayBuffer[] {
  const layouts = 'methods' in value ? value.methods.map(({ uv }) => uv) : [];
  return [...Object.values(value), ...layouts]
    .filter((field) => ArrayBuffer.isView(field))
    .map((view) => view.buffer as ArrayBuffer);
}
