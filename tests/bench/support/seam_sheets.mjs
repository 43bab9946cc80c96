// Pictures of seams, drawn by three.js in a browser.

import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { launchBrowser } from '../../../web/scripts/browser.mjs';
import { seamsOf } from './layout_measures.mjs';

const SIZE = 640;
const SCRIPT = fileURLToPath(new URL('seam_sheet.js', import.meta.url));

function bounds(points) {
  const [low, high] = [points[0].slice(), points[0].slice()];
  for (const point of points)
    for (const [d, x] of point.entries()) {
      low[d] = Math.min(low[d], x);
      high[d] = Math.max(high[d], x);
    }
  const middle = low.map((x, d) => (x + high[d]) / 2);
  return { middle, radius: Math.hypot(...high.map((x, d) => x - middle[d])) };
}

/** What the browser draws: flat lists of coordinates. */
function sheetOf(layout) {
  const { pieces, seams, boundary, outline } = seamsOf(layout);
  const xyz = pieces.flatMap((piece) => piece.xyz);
  return {
    xyz: xyz.flat(),
    uv: pieces.flatMap((piece) => piece.uv.flatMap(([u, v]) => [u, v, 0])),
    charts: pieces.map((piece) => piece.chart),
    seams: seams.flatMap((edge) => edge.xyz.flat()),
    boundary: boundary.flatMap((edge) => edge.xyz.flat()),
    outline: outline.flatMap((edge) => edge.uv.flatMap(([u, v]) => [u, v, 0])),
    ...bounds(xyz),
  };
}

/**
 * `draw(layout, file)` writes a PNG. Top row: the layout, the front, the right; bottom row: from
 * above, the left, the back.
 */
export async function seamPainter() {
  const { outputFiles } = await build({
    entryPoints: [SCRIPT],
    bundle: true,
    write: false,
    logLevel: 'error',
  });
  const { context, close } = await launchBrowser();
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  await page.addScriptTag({ content: outputFiles[0].text });
  const draw = async (layout, file) => {
    const picture = await page.evaluate(
      ([sheet, size]) => window.drawSheet(sheet, size),
      [sheetOf(layout), SIZE],
    );
    writeFileSync(file, Buffer.from(picture.split(',')[1], 'base64'));
  };
  return { draw, close };
}
