// Generated from core/schema by scripts/generate.mjs, do not edit.

/** The bits for what is wrong with a face in uv. */
export const UV_FAULT = { overlapping: 1, flipped: 2, empty: 4, outside: 8 } as const;
