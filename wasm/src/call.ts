import type { Taking } from './messages/input.js';
import type { AnyProgress, Request } from './messages/protocol.js';
import type { AbortSignalLike } from './types/index.js';

export interface CallSettings {
  transfer?: ArrayBuffer[];
  signal?: AbortSignalLike;
  /** A method, for its looser type check: the caller knows which progress its request reports. */
  onProgress?(progress: AnyProgress): unknown;
}

export interface Call {
  request: Request;
  settings: CallSettings;
}

/** What a call is made for. */
export interface Caller extends Taking {
  /** Throws if a call would be in vain, before its buffers are taken. */
  checkUsable(signal?: AbortSignalLike): void;
}
