// The page's modules without a page. Loading one starts a server that ends with the tests.

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

/** The class of the page's modules, which differs from the one in node. */
export const { AbflatError } = await vite.ssrLoadModule('abflat');

/** A module of web/src, by its name without extension. */
export const loadModule = (name) => vite.ssrLoadModule(`/src/${name}.ts`);
