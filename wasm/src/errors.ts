import type { StatusName } from './generated.js';

/** Why a call has no result: `code` for programs, `message` one sentence for people. */
export class AbflatError extends Error {
  override readonly name = 'AbflatError';
  readonly code: StatusName;

  constructor(code: StatusName, message: string) {
    super(message);
    this.code = code;
  }
}

export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
