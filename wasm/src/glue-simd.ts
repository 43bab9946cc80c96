import create from './abflat-simd.mjs';

export const simd = { create };
