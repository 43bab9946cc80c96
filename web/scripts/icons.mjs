#!/usr/bin/env node
// The icon as PNG, for systems that the page is installed on. Usage: icons.mjs   writes web/public/icon*.png from web/public/icon.svg

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { runMain } from '../../scripts/lib/run.mjs';
import { launchBrowser } from './browser.mjs';

const PUBLIC = join(ROOT, 'web/public');
const SIZES = [192, 512];
const { background_color: BACKGROUND } = JSON.parse(
  readFileSync(join(PUBLIC, 'manifest.webmanifest'), 'utf8'),
);

/** Systems cut a maskable icon to a shape of theirs, which shows at least the middle 80 %. */
const KINDS = [
  { name: 'icon', share: 1, background: 'transparent' },
  { name: 'icon-maskable', share: 0.6, background: BACKGROUND },
];

const documentOf = (svg, size, { share, background }) => `<style>
  body { display: grid; place-items: center; height: ${size}px; margin: 0; background: ${background} }
  svg { width: ${share * size}px }
</style>${svg}`;

await runMain(async () => {
  const svg = readFileSync(join(PUBLIC, 'icon.svg'), 'utf8');
  const { context, close } = await launchBrowser();
  try {
    const page = await context.newPage();
    for (const kind of KINDS)
      for (const size of SIZES) {
        await page.setViewportSize({ width: size, height: size });
        await page.setContent(documentOf(svg, size, kind));
        const picture = await page.screenshot({ omitBackground: true });
        writeFileSync(join(PUBLIC, `${kind.name}-${size}.png`), picture);
      }
  } finally {
    await close();
  }
});
