#!/usr/bin/env node
// The samples that are files, and a picture of each sample. Usage: samples.mjs   writes web/public/samples/

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { createAbflat, SAMPLE_NAMES } from 'abflat';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { runMain } from '../../scripts/lib/run.mjs';
import { launchBrowser } from './browser.mjs';
import { pumpkinGlb, pumpkinMesh, pumpkinTexture } from './pumpkin.mjs';
import { thumbnail } from './thumbnail.mjs';

const FOLDER = join(ROOT, 'web/public/samples');
const DETAIL = 2;
/** Where each is seen from. */
const EYES = {
  hemisphere: [0.4, 0.6, 1],
  'wavy-strip': [0.5, 0.8, 1],
  head: [0.6, 0.2, 1],
  'alpha-band': [0.2, 0.6, 1],
  'three-balls': [0.3, 0.4, 1],
};
const EYE_OF_FILES = [0.25, 0.3, 1];

/** The colours of charts on the page. */
function palette() {
  const css = readFileSync(join(ROOT, 'web/src/css/tokens.css'), 'utf8');
  const found = css.matchAll(/--chart-\d: #(\w\w)(\w\w)(\w\w)/g);
  return Array.from(found, ([, ...parts]) => parts.map((part) => Number.parseInt(part, 16)));
}

/** Each chart of its atlas in a colour. */
async function sampleThumbnail(page, abflat, name) {
  const mesh = await abflat.sample(name, { detail: DETAIL });
  const colors = palette();
  const { indices, vertexMap, chartOfTriangle } = await abflat.unwrap(mesh);
  const positions = [...vertexMap].flatMap((v) => [...mesh.positions.subarray(3 * v, 3 * v + 3)]);
  return thumbnail(
    page,
    { positions, indices },
    EYES[name],
    (triangle) => colors[chartOfTriangle[triangle] % colors.length],
  );
}

/** The pixels of a picture: red, green, blue, alpha. */
const pixelsOf = (page, jpeg) =>
  page.evaluate(async (bytes) => {
    const picture = await createImageBitmap(new Blob([Uint8Array.from(bytes)]));
    const { width, height } = picture;
    const pen = new OffscreenCanvas(width, height).getContext('2d');
    pen.drawImage(picture, 0, 0);
    return { width, height, data: Array.from(pen.getImageData(0, 0, width, height).data) };
  }, Array.from(jpeg));

async function writePumpkin(page) {
  const texture = await pumpkinTexture(page);
  writeFileSync(join(FOLDER, 'pumpkin.glb'), await pumpkinGlb(texture));
  const { width, height, data } = await pixelsOf(page, texture);
  const mesh = pumpkinMesh(8);
  const colorOf = (triangle) => {
    const corners = [0, 1, 2].map((k) => mesh.indices[3 * triangle + k]);
    const mean = (d) => corners.reduce((sum, v) => sum + mesh.texcoords[2 * v + d] / 3, 0);
    const at = 4 * (Math.floor(mean(1) * height) * width + Math.floor(mean(0) * width));
    return data.slice(at, at + 3);
  };
  const picture = await thumbnail(page, mesh, EYE_OF_FILES, colorOf);
  writeFileSync(join(FOLDER, 'pumpkin.webp'), picture);
}

await runMain(async () => {
  mkdirSync(FOLDER, { recursive: true });
  const abflat = await createAbflat();
  const { context, close } = await launchBrowser();
  try {
    const page = await context.newPage();
    await writePumpkin(page);
    for (const name of SAMPLE_NAMES)
      writeFileSync(join(FOLDER, `${name}.webp`), await sampleThumbnail(page, abflat, name));
  } finally {
    await close();
    abflat.terminate();
  }
});
