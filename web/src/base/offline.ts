import type { Build } from 'abflat';

/**
 * Has the browser keep the page for use without a connection, with the module of `build`. Where it cannot, for lack of HTTPS or of room,
 * the page works as ever.
 */
export function keepOffline(build: Build): void {
  if (import.meta.env.MODE !== 'production' || !('serviceWorker' in navigator)) return;
  navigator.serviceWorker
    .register(`./sw.js?build=${build}`, { updateViaCache: 'none' })
    .catch((error: Error) => console.info('The page is not kept for use offline:', error.message));
}
