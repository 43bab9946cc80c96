#!/usr/bin/env node
// The pictures of the README and the guides, from the built page.
// Usage: screenshots.mjs FOLDER MESHES [SCENE]...   MESHES: a folder with face.obj and spot-uv.obj
// Writes FOLDER/SCENE-dark.webp and FOLDER/SCENE-light.webp for each scene, and FOLDER/balance.webp; or the scenes that are named.

import { existsSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { WEB_DIST } from '../../scripts/lib/paths.mjs';
import { Failure, runMain } from '../../scripts/lib/run.mjs';
import { newContext, serveFolder, startBrowser } from './browser.mjs';
import { compareBalances } from './screenshots/balance.mjs';
import { takePicture } from './screenshots/camera.mjs';
import { openPage } from './screenshots/page.mjs';
import { scenes } from './screenshots/scenes.mjs';

const BALANCE = 'balance';
const THEMES = ['dark', 'light'];

function readArguments() {
  const [folder, meshes, ...named] = process.argv.slice(2);
  if (!meshes) throw new Failure('Usage: screenshots.mjs FOLDER MESHES [SCENE]...');
  for (const name of ['face.obj', 'spot-uv.obj'])
    if (!existsSync(join(meshes, name))) throw new Failure(`There is no ${name} in ${meshes}.`);
  const known = [...scenes.map(({ name }) => name), BALANCE];
  const unknown = named.find((name) => !known.includes(name));
  if (unknown) throw new Failure(`There is no scene ${unknown}, only ${known.join(', ')}.`);
  return { folder, meshes, wanted: named.length > 0 ? named : known };
}

/** Calls `use` with a context of its own, so that no scene is seen in another. */
async function inContext(browser, options, use) {
  const context = await newContext(browser, { reducedMotion: 'reduce', ...options });
  try {
    await use(context);
  } finally {
    await context.close();
  }
}

async function photograph(browser, url, { folder, meshes, wanted }) {
  for (const { name, play, screen } of scenes.filter(({ name }) => wanted.includes(name)))
    for (const colorScheme of THEMES)
      await inContext(browser, { ...screen, colorScheme }, async (context) => {
        const page = await openPage(context, url);
        await play(page, meshes);
        await takePicture(page, join(folder, `${name}-${colorScheme}.webp`));
      });
  if (wanted.includes(BALANCE))
    await inContext(browser, {}, (context) =>
      compareBalances(context, url, meshes, join(folder, `${BALANCE}.webp`)),
    );
}

await runMain(async () => {
  const request = readArguments();
  mkdirSync(request.folder, { recursive: true });
  const server = await serveFolder(WEB_DIST);
  try {
    const browser = await startBrowser();
    try {
      await photograph(browser, server.url, request);
    } finally {
      await browser.close();
    }
  } finally {
    server.close();
  }
});
