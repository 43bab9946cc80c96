import type { StatusName } from './generated.js';

/**
 * The part of abflat itself that is missing: its module or worker cannot be loaded, or the worker
 * has stopped.
 */
export type LostPart = 'module' | 'worker' | 'stopped';

const ended = (message: string) => (/[.?!]$/.test(message) ? message : `${message}.`);

/** Why a call has no result: `code` for programs, `message` for people, in full sentences. */
export class AbflatError extends Error {
  override readonly name = 'AbflatError';
  readonly code: StatusName;
  /** Set if neither the mesh nor the options are at fault, so that trying again may help. */
  readonly lost: LostPart | null;

  constructor(code: StatusName, message: string, lost: LostPart | null = null) {
    super(ended(message));
    this.code = code;
    this.lost = lost;
  }
}

export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
