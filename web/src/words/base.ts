// Messages, and parts of the page that are missing.

/** Said where a part of the page or a worker is missing. */
export const LOST = {
  notLoaded: 'a part of this page could not be loaded. Check the connection, then try again.',
  stopped: 'its worker stopped, possibly because memory ran out. Close other tabs, then try again.',
  noWorker: 'A worker could not be loaded.',
};

export const ALERT = { close: 'Close this message' };

export const THEME = { use: (theme: string) => `Use the ${theme} theme` };
