// The worker's side of the protocol, the same in browsers and Node.

import { AbflatError, messageOf } from './base/errors.js';
import { KEPT_MEMORY } from './base/memory.js';
import type { Answer, AnyProgress, FromWorker, Request, ToWorker } from './messages/protocol.js';
import { throttle } from './throttle.js';

export interface Port {
  post(message: FromWorker, transfer?: ArrayBuffer[]): void;
  listen(handle: (message: ToWorker) => void): void;
}

/** What answers calls. */
interface Engine {
  readonly heapBytes: number;
  readonly isBroken: boolean;
  /** `onProgress` returns whether to go on. */
  run(request: Request, onProgress?: (progress: AnyProgress) => boolean): Answer;
}

export type Start = (module: WebAssembly.Module, maxMemory: number) => Promise<Engine>;

export function serve(port: Port, start: Start): void {
  let engine: Promise<Engine> | undefined;
  let stopped: Int32Array | undefined;
  port.listen((message) => {
    if (message.type === 'start') {
      stopped = message.stopped;
      engine = start(message.module, message.maxMemory);
      engine.catch(() => undefined); // the first call reports it
    } else {
      const goesOn = () => !stopped || Atomics.load(stopped, 0) !== message.number;
      void answer(port, message.request, goesOn, engine);
    }
  });
}

async function answer(
  port: Port,
  request: Request,
  goesOn: () => boolean,
  starting?: Promise<Engine>,
): Promise<void> {
  let engine: Engine | undefined;
  try {
    engine = await starting;
    if (!engine) throw new Error('the worker was not started');
    const wantsProgress = 'wantsProgress' in request && request.wantsProgress;
    const tell = wantsProgress
      ? throttle((progress) => port.post({ type: 'progress', progress }))
      : undefined;
    const value = engine.run(request, (progress) => {
      tell?.(progress);
      return goesOn();
    });
    const isSpent = engine.heapBytes > KEPT_MEMORY;
    port.post({ type: 'done', answer: value, isSpent }, buffersOf(value));
  } catch (error) {
    const code = error instanceof AbflatError ? error.code : 'Internal';
    const isSpent = engine === undefined || engine.isBroken || engine.heapBytes > KEPT_MEMORY;
    port.post({ type: 'failed', code, message: messageOf(error), isSpent });
  }
}

function buffersOf(value: Answer): ArrayBuffer[] {
  const layouts = 'methods' in value ? value.methods.map(({ uv }) => uv) : [];
  return [...Object.values(value), ...layouts]
    .filter((field) => ArrayBuffer.isView(field))
    .map((view) => view.buffer as ArrayBuffer);
}
