// Heat maps of one layout, from angles to lengths, side by side.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { takePicture } from './camera.mjs';
import { openFile, openPage, settled } from './page.mjs';

const BALANCES = [0, 0.2, 1];
const SHEET = { width: 1200, height: 424 };
const STYLE =
  'body{margin:0;display:flex;background:#fff;font:16px sans-serif}figure{margin:8px;text-align:center}img{width:384px;height:384px}';

/** At a balance: as a data URI how much larger or smaller than on the surface each triangle is, and the mean stretch. */
async function heatMapAt(page, balance) {
  await page.locator('#unwrap-balance').fill(`${balance}`);
  await settled(page);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#layout-heat')]);
  const stretch = page.locator('.metric', { hasText: 'Stretch' }).locator('dd');
  return {
    balance,
    stretch: await stretch.innerText(),
    picture: `data:image/png;base64,${readFileSync(await download.path()).toString('base64')}`,
  };
}

const figure = ({ balance, stretch, picture }) =>
  `<figure><img src="${picture}"><figcaption>balance ${balance}: stretch ${stretch}</figcaption></figure>`;

export async function compareBalances(context, url, meshes, output) {
  const page = await openPage(context, url);
  await openFile(page, join(meshes, 'face.obj'));
  await page.click('#seams-auto'); // one chart
  await page.click('#more-toggle');
  await page.click('#more-rotate'); // as it lies, each time
  await settled(page);
  const maps = [];
  for (const balance of BALANCES) maps.push(await heatMapAt(page, balance));
  // A page of its own: that of abflat lets in no pictures from elsewhere.
  const sheet = await context.newPage();
  await sheet.setViewportSize(SHEET);
  await sheet.setContent(`<style>${STYLE}</style>${maps.map(figure).join('')}`);
  await takePicture(sheet, output);
}
