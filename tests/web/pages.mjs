// Provides pages for tests. The tests of a file share a browser and, one after the other, a page in
// it, which is reloaded for each: that costs half as much as a separate page.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after } from 'node:test';
import { chromium } from 'playwright-core';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { newContext, serveFolder, startBrowser } from '../../web/scripts/browser.mjs';

/** Not a race with the clock: this only ends a test that would otherwise never end. */
const PATIENCE = 120_000;

/** Settings of a page unless others are asked for. */
const USUAL = {
  viewport: { width: 1280, height: 720 },
  colorScheme: 'dark',
  // Colours have their final values at once; a view that glides to a stop would draw for a second.
  reducedMotion: 'reduce',
};

/** Drawing, in software here, is most of the work. Tests of single pixels ask for 1. */
const SCALE = 0.5;

/** Browsers that the tests of a file share, one with WebGL and one without. */
const browsers = new Map();
/** Shared pages that no test is using, by what cannot be changed later. */
const shared = new Map();
/** All open servers, whatever happened to their pages. */
const servers = new Set();
after(async () => {
  for (const server of servers) server.close();
  for (const browser of browsers.values()) await browser.close();
});

/** One that the files of this folder use one after the other, if there is one. */
const openBrowser = (webgl) =>
  webgl && process.env.ABFLAT_BROWSER
    ? chromium.connect(process.env.ABFLAT_BROWSER)
    : startBrowser({ webgl, antialias: false });

async function sharedBrowser(webgl) {
  if (!browsers.get(webgl)?.isConnected()) browsers.set(webgl, await openBrowser(webgl));
  return browsers.get(webgl);
}

async function openOwn(browser, headers, options) {
  const server = await serveFolder(join(ROOT, 'web/dist'), headers);
  servers.add(server);
  const context = await newContext(browser, options);
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  const close = async () => {
    servers.delete(server);
    server.close();
    await context.close();
  };
  return { page, url: server.url, close };
}

/** Chromium may request the icon of a document at any time, and again when its address changes. */
export const isOfRest = (message) => /\/(favicon\.ico|icon\.svg)$/.test(message.location().url);

/** Leaves nothing of this test to the next one: no document, no storage, nothing pressed. */
async function leave({ page, url }) {
  await page.unrouteAll();
  await page.mouse.up();
  for (const key of ['Shift', 'Control', 'Alt']) await page.keyboard.up(key);
  // Another document of the same origin, so that the process stays.
  await page.goto(`${url}icon.svg`);
  await page.mouse.move(0, 0);
  await page.evaluate(() => localStorage.clear());
}

/** Takes the shared page out of the map; it is put back when it can be used again. */
async function takeShared(browser, kind, options) {
  const last = shared.get(kind);
  shared.delete(kind);
  if (last && last.page.context().browser() === browser) return last;
  return openOwn(browser, undefined, options);
}

/**
 * A page that has not been loaded yet, with the `url` to load. It is a shared one unless something
 * is asked for that would affect later tests: `prepare`, `headers`, `own`, a browser without WebGL,
 * or an option of newContext that cannot be changed later. `end` closes it or leaves it to the next
 * test.
 */
export async function takePage({
  prepare,
  headers,
  own,
  webgl,
  hasTouch = false,
  deviceScaleFactor = SCALE,
  ...options
}) {
  const browser = await sharedBrowser(webgl);
  const kind = `${hasTouch} ${deviceScaleFactor}`;
  const { viewport, colorScheme, reducedMotion, ...fixed } = { ...USUAL, ...options };
  if (prepare || headers || own || !webgl || Object.keys(fixed).length > 0) {
    const { page, url, close } = await openOwn(browser, headers, {
      ...USUAL,
      ...options,
      hasTouch,
      deviceScaleFactor,
    });
    await prepare?.(page);
    return { page, url, end: close };
  }
  const taken = await takeShared(browser, kind, { hasTouch, deviceScaleFactor });
  const { page, url } = taken;
  let hasCrashed = false;
  const crashed = () => {
    hasCrashed = true;
  };
  page.on('crash', crashed);
  await page.setViewportSize(viewport);
  await page.emulateMedia({ colorScheme, reducedMotion });
  const end = async () => {
    page.off('crash', crashed);
    assert.ok(browser.isConnected(), 'the browser crashed');
    assert.ok(!hasCrashed, 'the page crashed');
    // If a test had several pages at once, only one is kept.
    if (shared.has(kind)) return taken.close();
    await leave(taken);
    shared.set(kind, taken);
  };
  return { page, url, end };
}
