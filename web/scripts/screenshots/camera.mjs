// Takes a picture of a page and stores it as WebP, which playwright cannot.

import { renameSync, writeFileSync } from 'node:fs';

const QUALITY = 0.9;

/** Encodes a PNG as WebP in a page that may do so: any but one with the policy of abflat. */
const toWebp = (page, png) =>
  page.evaluate(
    async ([base64, quality]) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes]));
      const canvas = new OffscreenCanvas(image.width, image.height);
      canvas.getContext('2d').drawImage(image, 0, 0);
      const blob = await canvas.convertToBlob({ type: 'image/webp', quality });
      const reader = new FileReader();
      await new Promise((done) => {
        reader.onload = done;
        reader.readAsDataURL(blob);
      });
      return reader.result.split(',')[1];
    },
    [png.toString('base64'), QUALITY],
  );

/** Writes what `page` shows to `output`, whole or not at all. */
export async function takePicture(page, output) {
  // The views are drawn in the next frame.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
  const png = await page.screenshot({ type: 'png', animations: 'disabled' });
  const blank = await page.context().newPage();
  const picture = Buffer.from(await toWebp(blank, png), 'base64');
  await blank.close();
  writeFileSync(`${output}.tmp`, picture);
  renameSync(`${output}.tmp`, output);
  console.log(`${output}, ${Math.ceil(picture.length / 1024)} KB`);
}
