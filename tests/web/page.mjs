// The built page in a real browser, for the tests of this folder.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { newContext, serveFolder, startBrowser } from '../../web/scripts/browser.mjs';

/** Nothing here is a race with the clock: this only ends a test that would never end. */
const PATIENCE = 120_000;

/** Browsers that the tests of a file share, one with WebGL and one without. */
const browsers = new Map();
after(() => Promise.all([...browsers.values()].map((browser) => browser.close())));

async function sharedBrowser(webgl) {
  if (!browsers.get(webgl)?.isConnected()) browsers.set(webgl, await startBrowser({ webgl }));
  return browsers.get(webgl);
}

/**
 * Opens the page in a context of its own; `t.after` closes it and checks that it logged no error but those that `expected` matches. `prepare`
 * is called with the page before it loads, `mode: 'flatten'` chooses that; `headers` are those of serveFolder, other options are those of
 * newContext.
 */
export async function openPage(
  t,
  { prepare, expected, headers, mode, webgl = true, ...options } = {},
) {
  const server = await serveFolder(join(ROOT, 'web/dist'), headers);
  const context = await newContext(await sharedBrowser(webgl), options);
  const problems = [];
  t.after(async () => {
    await context.close();
    server.close();
    assert.deepEqual(problems, [], 'errors in the console of the page');
  });
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  page.on('console', (message) => {
    if (message.type() === 'error' && !expected?.test(message.text()))
      problems.push(message.text());
  });
  page.on('pageerror', (error) => problems.push(String(error)));
  await prepare?.(page);
  await page.goto(server.url);
  await settled(page);
  if (mode) await choose(page, mode);
  return page;
}

/** Flatten or unwrap, by their button; by script, so that the focus stays where it is. */
export async function choose(page, mode) {
  await page.evaluate((mode) => document.querySelector(`#mode-${mode}`).click(), mode);
  await settled(page);
}

/** Waits until nothing runs any more. */
export async function settled(page) {
  await page.waitForFunction(
    () => document.querySelector('#run-text').textContent !== 'Starting' && !document.body.ariaBusy,
  );
}

/** Drops a file on the page as a file manager does. */
export async function drop(page, name, content) {
  await dropFiles(page, { [name]: content });
}

/** Drops files, texts or bytes by their names, at once. */
export async function dropFiles(page, files) {
  const encoded = Object.entries(files).map(([name, content]) => [
    name,
    Buffer.from(content).toString('base64'),
  ]);
  await page.evaluate((files) => {
    const dataTransfer = new DataTransfer();
    for (const [name, content] of files) {
      const bytes = Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0));
      dataTransfer.items.add(new File([bytes], name));
    }
    for (const type of ['dragover', 'drop'])
      document.body.dispatchEvent(
        new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }),
      );
  }, encoded);
}

/** Drops a file, with `others`, and waits for what comes of it. */
export async function dropAndWait(page, name, content, others = {}) {
  await dropFiles(page, { [name]: content, ...others });
  await page.waitForFunction(
    (name) =>
      document.querySelector('#source').textContent === name ||
      document.querySelector('#alert').textContent !== '',
    name,
  );
  await settled(page);
}

export const textOf = (page, selector) => page.locator(selector).innerText();

/** The metrics by their label, as shown. */
export function metrics(page) {
  return page.evaluate(() =>
    Object.fromEntries(
      [...document.querySelectorAll('.metric')].map((item) => [
        item.querySelector('dt').textContent,
        item.querySelector('dd').textContent,
      ]),
    ),
  );
}

/** Exports through the button; returns the name it suggests and where the file is. */
export async function exportMesh(page) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#export')]);
  return { name: download.suggestedFilename(), path: await download.path() };
}
