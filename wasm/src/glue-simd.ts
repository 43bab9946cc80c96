import create from './abflat-simd.js';

export const simd = { create };
