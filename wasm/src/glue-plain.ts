import create from './abflat.mjs';

export const plain = { create };
