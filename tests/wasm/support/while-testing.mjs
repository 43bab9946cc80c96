// What tests of hosts have while those of a file run.

import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { findChrome } from '../../../scripts/lib/requirements.mjs';
import { startBrowser } from '../../../web/scripts/browser.mjs';
import { ROOT } from './paths.mjs';

const hasChrome = findChrome() !== undefined;
/** An option of `test`. */
export const NEEDS_CHROME = { skip: hasChrome ? false : 'there is no Chromium' };

/**
 * A browser, if there is one; a folder inside the repository, so that bundlers find its
 * node_modules; and servers that are to be closed.
 */
export function whileTesting(name) {
  const here = { browser: undefined, folder: undefined, servers: [] };
  before(async () => {
    mkdirSync(join(ROOT, 'build/tests'), { recursive: true });
    here.folder = mkdtempSync(join(ROOT, `build/tests/wasm-${name}-`));
    if (hasChrome) here.browser = await startBrowser({ webgl: false });
  });
  after(async () => {
    await here.browser?.close();
    for (const server of here.servers) server.close();
    rmSync(here.folder, { recursive: true });
  });
  return here;
}
