// The built page in a real browser, for the tests in this folder.

import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after } from 'node:test';
import { isOfRest, takePage } from './pages.mjs';

/**
 * Opens the page; `t.after` checks that it logged no error except those that match `expected`.
 * `prepare` is called with the page before it loads. `mode: 'flatten'` chooses that mode and `open:
 * [name, content]` drops a file, both in place of what a first visit shows. `settles: false` does not
 * wait for that: it gives way to a mesh that the test opens at once. `headers` are those of
 * serveFolder, other options those of takePage and newContext.
 */
export async function openPage(
  t,
  { expected, mode, open, settles = true, webgl = true, ...options } = {},
) {
  const { page, url, end } = await takePage({ webgl, ...options });
  const problems = [];
  const onConsole = (message) => {
    if (message.type() !== 'error' || isOfRest(message) || expected?.test(message.text())) return;
    problems.push(message.text());
  };
  const onError = (error) => problems.push(String(error));
  page.on('console', onConsole).on('pageerror', onError);
  t.after(async () => {
    // Everything logged so far has arrived after this, unless there is no page any more; then `end`
    // reports it.
    await page.evaluate(() => undefined).catch(() => undefined);
    page.off('console', onConsole).off('pageerror', onError);
    await end();
    assert.deepEqual(problems, [], 'errors in the console of the page');
  });
  await page.goto(url);
  // The page is still starting: the sample gives way before it is laid out.
  if (mode) await page.evaluate((mode) => document.querySelector(`#mode-${mode}`).click(), mode);
  if (open) await dropAndWait(page, ...open);
  if (settles) await settled(page);
  return page;
}

/** Chooses flatten or unwrap with its button; by script, so that the focus stays where it is. */
export async function choose(page, mode) {
  await page.evaluate((mode) => document.querySelector(`#mode-${mode}`).click(), mode);
  await settled(page);
}

/** Chooses a sample and waits for its result; by script, as `choose` does. */
export async function openSample(page, name) {
  await page.evaluate(
    (name) => document.querySelector(`.sample-item[data-value="${name}"]`).click(),
    name,
  );
  // A sample that is a file has to be fetched before anything runs.
  await page.waitForFunction(
    (name) =>
      document.querySelector('#sample').value === name ||
      document.querySelector('#source').textContent.startsWith(`${name}.`),
    name,
  );
  await settled(page);
}

/** The names of all samples. */
export const sampleNames = (page) =>
  page
    .locator('.sample-item')
    .evaluateAll((items) => items.map((item) => item.getAttribute('data-value')));

/** The sample that is open; '' for a file. */
export const sampleOf = (page) => page.evaluate(() => document.querySelector('#sample').value);

/** Waits until nothing runs any more. */
export async function settled(page) {
  await page.waitForFunction(
    () => document.querySelector('#run-text').textContent !== 'Starting' && !document.body.ariaBusy,
  );
}

/** Waits until the page has drawn what was done to it. */
export const drawn = (page) =>
  page.evaluate(
    () =>
      new Promise((done) =>
        requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done))),
      ),
  );

/** Drops a file on the page as a file manager does. */
export async function drop(page, name, content) {
  await dropFiles(page, { [name]: content });
}

/** Drops files, given as texts or bytes by name, at once. */
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

/** Drops a file along with `others`, and waits for the result. */
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

/** Whether the browser keeps a mesh of that name for the next visit. */
const isKept = (name) =>
  new Promise((done) => {
    const opening = indexedDB.open('abflat', 1);
    // Not made here: the page makes it with all that belongs in it.
    opening.onupgradeneeded = () => opening.transaction.abort();
    opening.onerror = () => done(false);
    opening.onsuccess = () => {
      const database = opening.result;
      const request = database.transaction('visit').objectStore('visit').get('mesh');
      request.onsuccess = () => {
        database.close();
        done(request.result?.name === name);
      };
    };
  });

/** Waits until the browser keeps the mesh that is open; that of a first visit is not kept. */
export async function kept(page) {
  const name = (await sampleOf(page)) || (await textOf(page, '#source'));
  if (name !== 'head') await page.waitForFunction(isKept, name);
}

/** Reloads the page once the mesh is kept; its settings are, while the page is left. */
export async function reload(page) {
  await kept(page);
  await page.reload();
  await settled(page);
}

/** The metrics by label, as shown. */
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

const folder = mkdtempSync(join(tmpdir(), 'abflat-downloads-'));
let downloads = 0;
after(() => rmSync(folder, { recursive: true }));

/** A download as a file of this test: a browser that others use, too, does not tell its own. */
export async function pathOf(download) {
  const path = join(folder, String(downloads++));
  await download.saveAs(path);
  return path;
}

/** Exports with the button; returns the suggested name and the path of the file. */
export async function exportMesh(page) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#export')]);
  return { name: download.suggestedFilename(), path: await pathOf(download) };
}

/** Chooses a format of export; returns the file. */
export async function exportAs(page, format) {
  await page.click('#export-formats');
  const item = page.getByRole('menuitemradio', { name: format.toUpperCase() });
  const [download] = await Promise.all([page.waitForEvent('download'), item.click()]);
  assert.equal(await textOf(page, '#alert'), '');
  return { name: download.suggestedFilename(), bytes: readFileSync(await pathOf(download)) };
}
