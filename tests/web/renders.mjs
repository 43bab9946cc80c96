// How different two GLB files look.

import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildSync } from 'esbuild';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { serveFolder, startBrowser } from '../../web/scripts/browser.mjs';

/** A function of two files, with what tests/support/glb-renders.mjs finds. */
export async function rendersFor(t) {
  mkdirSync(join(ROOT, 'build/tests'), { recursive: true });
  const folder = mkdtempSync(join(ROOT, 'build/tests/web-renders-'));
  buildSync({
    entryPoints: [fileURLToPath(new URL('./renders/page.mjs', import.meta.url))],
    bundle: true,
    format: 'esm',
    target: 'es2022',
    outfile: join(folder, 'main.js'),
    nodePaths: [join(ROOT, 'node_modules')],
  });
  writeFileSync(
    join(folder, 'index.html'),
    `<!doctype html><link rel="icon" href="data:,"><title>renders</title>
    <script type="module" src="./main.js"></script>`,
  );
  const server = await serveFolder(folder, {});
  const browser = await startBrowser({ webgl: true });
  t.after(async () => {
    await browser.close();
    server.close();
    rmSync(folder, { recursive: true });
  });
  const page = await browser.newPage();
  await page.goto(server.url);
  await page.waitForFunction(() => window.compare);
  const base64 = (bytes) => Buffer.from(bytes).toString('base64');
  return (before, after) =>
    page.evaluate(([a, b]) => window.compare(a, b), [before, after].map(base64));
}
