import create from './abflat-threads.js';

export const threads = {
  create,
  // Bundlers find the file by exactly this expression, and copy it as it is.
  threadScript: () => new URL('./abflat-threads.js', import.meta.url).href,
};
