// What wasm/build.mjs writes of the module for the entry that has it inside.

/** The module, deflated, in base64. */
export const DEFLATED: string;
/** Bytes of the module. */
export const SIZE: number;
