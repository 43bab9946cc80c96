// What the scenes do on the page, as a visitor would.

import { basename } from 'node:path';
import { Failure } from '../../../scripts/lib/run.mjs';

/** Milliseconds; software rendering takes its time. */
const PATIENCE = 120_000;

/** Waits until nothing runs any more. */
export const settled = (page) =>
  page.waitForFunction(
    () => document.querySelector('#run-text').textContent !== 'Starting' && !document.body.ariaBusy,
  );

/** The page as a first visit shows it. */
export async function openPage(context, url) {
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  await page.goto(url);
  await settled(page);
  return page;
}

export async function openFile(page, file) {
  await page.setInputFiles('#file', file);
  await page.waitForFunction(
    (name) => document.querySelector('#source').textContent === name,
    basename(file),
  );
  await settled(page);
  const refusal = await page.locator('#alert').innerText();
  if (refusal) throw new Failure(refusal);
}

export async function openSample(page, name) {
  await page.click('#sample');
  await page.click(`.sample-item[data-value="${name}"]`);
  // One that is a file is fetched first.
  await page.waitForFunction(
    (name) =>
      document.querySelector('#sample').value === name ||
      document.querySelector('#source').textContent.startsWith(`${name}.`),
    name,
  );
  await settled(page);
}

export async function choose(page, mode) {
  await page.click(`#mode-${mode}`);
  await settled(page);
}

/** Where a place on a view is, given in fractions of its size. */
async function placeOn(page, view, [x, y]) {
  const box = await page.locator(view).boundingBox();
  return [box.x + x * box.width, box.y + y * box.height];
}

export async function moveOn(page, view, place) {
  await page.mouse.move(...(await placeOn(page, view, place)), { steps: 4 });
}

export async function clickOn(page, view, place) {
  await moveOn(page, view, place);
  await page.mouse.down();
  await page.mouse.up();
}

/** Where the fitted layout shows a point of the unit square. */
export async function placeOfUv(page, [u, v]) {
  const canvas = page.locator('#layout-canvas');
  const { width, height } = await canvas.boundingBox();
  // The room that a fitted atlas leaves for the bar of a selection.
  const above = await canvas.evaluate((element) =>
    Number.parseFloat(getComputedStyle(element).getPropertyValue('--above')),
  );
  const margin = 8;
  const side = Math.min(width - 2 * margin, height - above - margin);
  const middle = (above + height - margin) / 2;
  return [0.5 + ((u - 0.5) * side) / width, (middle - (v - 0.5) * side) / height];
}

/** Takes the pointer off everything that answers to it. */
export const leave = (page) => page.mouse.move(0, 0);
