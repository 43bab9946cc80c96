// A real browser on the built page, for tests and screenshots.

import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { findChrome } from '../../scripts/lib/requirements.mjs';
import { createStaticServer, HEADERS, listen } from '../../scripts/serve.mjs';

/**
 * For each page the browser would prepare two pages of its own, for the suggestions below addresses,
 * and a process in reserve. Only the last list of a command line counts, so what playwright switches
 * off is repeated.
 */
const WITHOUT = [
  ...['WebUIOmniboxPopup', 'WebUIOmniboxAimPopup', 'WebUIOmniboxFullPopup'],
  ...['AimEnabled', 'AvoidCorsURLLoaderRestartOnRedirect', 'AvoidUnnecessaryBeforeUnloadCheckSync'],
  ...['DestroyProfileOnBrowserClose', 'HttpsFirstBalancedModeAutoEnable', 'HttpsUpgrades'],
  ...['LensOverlay', 'MediaRouter', 'NetworkTimeServiceQuerying', 'OptimizationHints'],
  ...['PaintHolding', 'PreconnectToSearch', 'SpareRendererForSitePerProcess'],
  'ThirdPartyStoragePartitioning',
];
const FLAGS = [
  `--disable-features=${WITHOUT}`,
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];
// WebGL without a graphics card; what is around the canvases is put together without it, in half the time.
const SOFTWARE_GL = [
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--disable-gpu-compositing',
];
const NO_ANTIALIAS = ['--webgl-antialiasing-mode=none'];
const NO_GL = ['--disable-gpu', '--disable-3d-apis'];

/** Serves a folder on a free port of this machine, as npm start does unless there are other `headers`. */
export async function serveFolder(folder, headers = HEADERS) {
  if (!existsSync(join(folder, 'index.html')))
    throw new Error(`${folder} has no index.html: run "npm run build:web" first.`);
  const server = createStaticServer(folder, headers);
  const port = await listen(server, '127.0.0.1', 0, false);
  return {
    url: `http://127.0.0.1:${port}/`,
    close: () => {
      server.closeAllConnections();
      server.close();
    },
  };
}

function launching({ webgl, antialias }) {
  const executablePath = findChrome();
  if (!executablePath)
    throw new Error('There is no Chromium or Chrome; name one with CHROME_PATH.');
  const args = [...FLAGS, ...(webgl ? SOFTWARE_GL : NO_GL), ...(antialias ? [] : NO_ANTIALIAS)];
  return { executablePath, headless: true, args };
}

/** Starts a browser with an empty profile. Without `antialias` pictures are quicker, and coarse. */
export const startBrowser = ({ webgl = true, antialias = true } = {}) =>
  chromium.launch(launching({ webgl, antialias }));

/** The same for other processes, each of which connects to it with its `wsEndpoint()`. */
export const serveBrowser = ({ webgl = true, antialias = true } = {}) =>
  chromium.launchServer(launching({ webgl, antialias }));

/** Pages of their own in a browser: they share no storage or cache with others. `options` are playwright's. */
export function newContext(browser, options = {}) {
  return browser.newContext({
    viewport: { width: 1280, height: 720 },
    colorScheme: 'dark',
    acceptDownloads: true,
    // What a test does to the files of a page is not answered from a store.
    serviceWorkers: 'block',
    ...options,
  });
}

/** A browser with one context. */
export async function launchBrowser({ webgl, ...options } = {}) {
  const browser = await startBrowser({ webgl });
  const context = await newContext(browser, options);
  return { context, close: () => browser.close() };
}
