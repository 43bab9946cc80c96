// The scenes of the gallery: each gets a page that has just been opened, and leaves it as it is to be seen.

import { join } from 'node:path';
import {
  choose,
  clickOn,
  leave,
  moveOn,
  openFile,
  openSample,
  placeOfUv,
  settled,
} from './page.mjs';

const DESKTOP = { viewport: { width: 1200, height: 675 } };
/** So low that More fills the dock. */
const LOW = { viewport: { width: 1200, height: 645 } };
/** In uv, the one to be dragged first. */
const PINS = [
  [0.78, 0.86],
  [0.035, 0.86],
  [0.02, 0.58],
  [0.8, 0.58],
];
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

async function face(page, meshes) {
  await openFile(page, join(meshes, 'face.obj'));
}

/** Seen from its other side, which is the better one. */
async function spot(page, meshes) {
  await openFile(page, join(meshes, 'spot-uv.obj'));
  await page.click('#other-side');
  await leave(page);
}

async function materials(page) {
  await openSample(page, 'pumpkin');
  await page.waitForFunction(() => document.querySelector('#shading').value === 'materials');
}

async function samples(page) {
  await openSample(page, 'three-balls');
  await page.click('#sample');
  await page.waitForFunction(() =>
    [...document.querySelectorAll('.sample-picture')].every(({ naturalWidth }) => naturalWidth > 0),
  );
}

/** One chart of the whole face: some of it has to stretch. */
async function heat(page, meshes) {
  await face(page, meshes);
  await page.click('#seams-auto');
  await settled(page);
  await page.selectOption('#shading', 'stretch');
  await leave(page);
}

async function grid(page, meshes) {
  await spot(page, meshes);
  await page.selectOption('#shading', 'grid');
}

/** A small chart, moved and in the middle of a turn. */
async function arrange(page, meshes) {
  await spot(page, meshes);
  await page.click('#details-toggle');
  await page.click('#tab-history');
  await clickOn(page, '#layout-canvas', await placeOfUv(page, [0.82, 0.08]));
  // Off the chart, which would be lit.
  await moveOn(page, '#layout-canvas', [0.97, 0.97]);
  for (const keys of ['gx0.02', 'gy0.06']) {
    await page.keyboard.type(keys);
    await page.keyboard.press('Enter');
    await settled(page);
  }
  await page.keyboard.type('r30');
}

/** One of four pins is dragged. */
async function pins(page, meshes) {
  await face(page, meshes);
  await page.click('#pin');
  for (const uv of PINS) await clickOn(page, '#layout-canvas', await placeOfUv(page, uv));
  const [x, y] = await placeOfUv(page, PINS[0]);
  await moveOn(page, '#layout-canvas', [x, y]);
  await page.mouse.down();
  await moveOn(page, '#layout-canvas', [x + 0.09, y + 0.08]);
  // The first frame of a drag waits for what it needs.
  await page.waitForTimeout(1000);
}

/** A cut that has been started and follows the pointer. */
async function seam(page) {
  await clickOn(page, '#mesh-canvas', [0.42, 0.22]);
  await moveOn(page, '#mesh-canvas', [0.56, 0.62]);
}

/** The list of charts with the largest one locked, and all options. */
async function charts(page, meshes) {
  await spot(page, meshes);
  await page.click('#more-toggle');
  await page.click('#details-toggle');
  await page.locator('.lock').first().click();
  await page.focus('#stretch');
  await page.keyboard.press('ArrowLeft');
  await settled(page);
  await page.locator('#stretch').blur();
  await page.locator('#more').evaluate((options) => options.scrollIntoView());
  await leave(page);
}

/** A sample that crosses itself unless some vertices are tightened. */
async function details(page) {
  await openSample(page, 'alpha-band');
  await choose(page, 'flatten');
  await page.click('#details-toggle');
  await page.click('#tab-sweep');
  await page.click('#sweep');
  await page.waitForFunction(() => document.querySelector('#sweep').textContent !== 'Stop');
  await page.locator('#mode-flatten').evaluate((button) => button.scrollIntoView({ block: 'end' }));
  await leave(page);
}

const on = (screen, plays) => Object.entries(plays).map(([name, play]) => ({ name, play, screen }));

export const scenes = [
  ...on(DESKTOP, { spot, materials, samples, heat, grid, arrange, pins, seam, details }),
  ...on(LOW, { charts }),
  ...on(PHONE, { phone: spot }),
];
