#!/usr/bin/env node
// Pictures of the page in both themes, for the README: with each mesh, the charts of the last one, and a sample with its distortion plotted against t.
// Usage: screenshots.mjs FOLDER MESH[:turned]...   turned: seen from its other side; writes FOLDER/NAME-THEME.png, FOLDER/charts-THEME.png,
// FOLDER/details-THEME.png, and FOLDER/balance.png: heat maps of the first one in one chart, at balance 0, 0.2 and 1.

import { existsSync, mkdirSync, readFileSync, renameSync, statSync } from 'node:fs';
import { join, parse } from 'node:path';
import { WEB_DIST } from '../../scripts/lib/paths.mjs';
import { Failure, runMain } from '../../scripts/lib/run.mjs';
import { launchBrowser, serveFolder } from './browser.mjs';

/** Large enough for the README, small enough for the repository. */
const VIEWPORT = { width: 1200, height: 675 };
/** So low that More fills the dock. */
const LOW = { ...VIEWPORT, height: 645 };

/** Of one layout, from angles to lengths. */
const BALANCES = [0, 0.2, 1];

/** Milliseconds; software rendering takes its time. */
const PATIENCE = 120_000;

async function save(page, output) {
  // The pictures are drawn in the next frame.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
  const draft = `${output}.tmp`;
  await page.screenshot({ path: draft, type: 'png', animations: 'disabled' });
  renameSync(draft, output);
  console.log(`${output}, ${Math.ceil(statSync(output).size / 1024)} KB`);
}

/** The list of charts with the largest one locked, and all options. */
async function listCharts(page) {
  await page.click('#mode-unwrap');
  await page.waitForFunction(() => !document.body.ariaBusy);
  await page.click('#more-toggle');
  await page.click('#details-toggle');
  await page.locator('.lock').first().click();
  await page.focus('#stretch');
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction(() => !document.body.ariaBusy);
  await page.locator('#stretch').blur();
  await page.locator('#more').evaluate((options) => options.scrollIntoView());
  await page.mouse.move(0, 0);
}

/** A sample that crosses itself unless some vertices are tightened. */
async function plotAgainstT(page) {
  await page.click('#sample');
  await page.click('.sample-item[data-value="alpha-band"]');
  await page.waitForFunction(() => !document.body.ariaBusy);
  await page.click('#mode-flatten');
  await page.waitForFunction(() => !document.body.ariaBusy);
  await page.click('#tab-sweep');
  await page.click('#sweep');
  await page.waitForFunction(() => document.querySelector('#sweep').textContent !== 'Stop');
  await page.locator('#mode-flatten').evaluate((button) => button.scrollIntoView({ block: 'end' }));
  await page.mouse.move(0, 0);
}

/** The layout at a balance: as a data URI how much larger or smaller than on the surface each triangle is, and the mean stretch. */
async function heatMapAt(page, balance) {
  await page.locator('#unwrap-balance').fill(`${balance}`);
  await page.waitForFunction(() => !document.body.ariaBusy);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#layout-heat')]);
  const stretch = page.locator('.metric', { hasText: 'Stretch' }).locator('dd');
  return {
    balance,
    stretch: await stretch.innerText(),
    picture: `data:image/png;base64,${readFileSync(await download.path()).toString('base64')}`,
  };
}

/** Area before and after, side by side. */
async function compareBalances(url, { file }, output) {
  const browser = await launchBrowser({ viewport: VIEWPORT });
  try {
    const page = await browser.context.newPage();
    page.setDefaultTimeout(PATIENCE);
    await page.goto(url);
    await page.setInputFiles('#file', file);
    await page.waitForFunction(
      (name) => document.querySelector('#source').textContent === name && !document.body.ariaBusy,
      parse(file).base,
    );
    await page.click('#mode-unwrap');
    await page.click('#seams-auto'); // one chart
    await page.click('#more-toggle');
    await page.click('#more-rotate'); // as it lies, each time
    await page.waitForFunction(() => !document.body.ariaBusy);
    const maps = [];
    for (const balance of BALANCES) maps.push(await heatMapAt(page, balance));
    const figures = maps.map(
      ({ balance, stretch, picture }) =>
        `<figure><img src="${picture}"><figcaption>balance ${balance}: stretch ${stretch}</figcaption></figure>`,
    );
    // Of its own: that of abflat lets in no pictures from elsewhere.
    const sheet = await browser.context.newPage();
    await sheet.setViewportSize({ width: 1200, height: 424 });
    await sheet.setContent(
      `<style>body{margin:0;display:flex;background:#fff;font:16px sans-serif}figure{margin:8px;text-align:center}img{width:384px;height:384px}</style>${figures.join('')}`,
    );
    await save(sheet, output);
  } finally {
    await browser.close();
  }
}

async function photograph(url, meshes, theme, output) {
  const browser = await launchBrowser({ colorScheme: theme, viewport: VIEWPORT });
  try {
    const page = await browser.context.newPage();
    page.setDefaultTimeout(PATIENCE);
    await page.goto(url);
    for (const { file, isTurned } of meshes) {
      await page.setInputFiles('#file', file);
      await page.waitForFunction(
        (name) => document.querySelector('#source').textContent === name && !document.body.ariaBusy,
        parse(file).base,
      );
      const refusal = await page.locator('#alert').innerText();
      if (refusal) throw new Failure(refusal);
      if (isTurned) await page.click('#other-side');
      await page.mouse.move(0, 0);
      await save(page, output(parse(file).name));
    }
    await page.setViewportSize(LOW);
    await listCharts(page);
    await save(page, output('charts'));
    await page.setViewportSize(VIEWPORT);
    await plotAgainstT(page);
    await save(page, output('details'));
  } finally {
    await browser.close();
  }
}

await runMain(async () => {
  const [folder, ...named] = process.argv.slice(2);
  const meshes = named.map((name) => ({
    file: name.replace(/:turned$/, ''),
    isTurned: name.endsWith(':turned'),
  }));
  if (meshes.length === 0) throw new Failure('Usage: screenshots.mjs FOLDER MESH[:turned]...');
  const missing = meshes.find(({ file }) => !existsSync(file));
  if (missing) throw new Failure(`There is no file ${missing.file}.`);
  mkdirSync(folder, { recursive: true });
  const server = await serveFolder(WEB_DIST);
  try {
    for (const theme of ['dark', 'light']) {
      const output = (name) => join(folder, `${name}-${theme}.png`);
      await photograph(server.url, meshes, theme, output);
    }
    await compareBalances(server.url, meshes[0], join(folder, 'balance.png'));
  } finally {
    server.close();
  }
});
