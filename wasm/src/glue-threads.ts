import create from './abflat-threads.mjs';

export const threads = {
  create,
  // Bundlers find the file by exactly this expression, and copy it as it is.
  threadScript: () => new URL('./abflat-threads.mjs', import.meta.url).href,
};
