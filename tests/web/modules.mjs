// The page's modules without a page. Whoever loads one gets a server that ends with the tests.

import { join } from 'node:path';
import { after } from 'node:test';
import { createServer } from 'vite';
import { ROOT } from '../../scripts/lib/paths.mjs';

const vite = await createServer({
  root: join(ROOT, 'web'),
  appType: 'custom',
  logLevel: 'error',
  server: { middlewareMode: true, hmr: false, ws: false },
  optimizeDeps: { noDiscovery: true },
});
after(() => vite.close());

/** That of the page's modules: another than the one of node. */
export const { AbflatError } = await vite.ssrLoadModule('abflat');

/** A module of web/src by its name without ending. */
export const loadModule = (name) => vite.ssrLoadModule(`/src/${name}.ts`);
