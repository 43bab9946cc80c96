import create from './abflat.js';

export const plain = { create };
