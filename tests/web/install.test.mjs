// The page as a program of the system.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { grid } from '../support/small-meshes.mjs';
import { openPage, settled, textOf } from './page.mjs';

const PUBLIC = join(ROOT, 'web/public');
const manifest = JSON.parse(readFileSync(join(PUBLIC, 'manifest.webmanifest'), 'utf8'));
const endings = manifest.file_handlers.flatMap(({ accept }) => Object.values(accept).flat());

/** Width and height of a PNG. */
function sizesOf(path) {
  const bytes = readFileSync(path);
  return `${bytes.readUInt32BE(16)}x${bytes.readUInt32BE(20)}`;
}

test('browsers find nothing wrong with the manifest', async (t) => {
  const page = await openPage(t);
  const session = await page.context().newCDPSession(page);
  const { url, errors } = await session.send('Page.getAppManifest');
  assert.match(url, /manifest\.webmanifest$/);
  assert.deepEqual(errors, []);
  const { installabilityErrors } = await session.send('Page.getInstallabilityErrors');
  const others = installabilityErrors.filter(({ errorId }) => errorId !== 'in-incognito');
  assert.deepEqual(others, []);
  await session.detach();
});

test('icons have the sizes that the manifest says', () => {
  const pictures = manifest.icons.filter(({ type }) => type === 'image/png');
  assert.equal(pictures.length, 4);
  for (const { src, sizes } of pictures) assert.equal(sizesOf(join(PUBLIC, src)), sizes, src);
});

test('the system opens the meshes that the page opens', async (t) => {
  const page = await openPage(t);
  const accepted = (await page.getAttribute('#file', 'accept')).split(',');
  const notMeshes = ['.bin', '.mtl', '.png', '.jpg', '.jpeg', '.webp', '.zip'];
  assert.deepEqual(
    endings.toSorted(),
    accepted.filter((ending) => !notMeshes.includes(ending)).sort(),
  );
});

test('the window has the colour of the bar, in both themes', async (t) => {
  const page = await openPage(t, { colorScheme: 'dark' });
  const colors = () =>
    page.evaluate(() => {
      const bar = document.querySelector('.bar');
      const asShown = (color) => {
        bar.style.color = color;
        return getComputedStyle(bar).color;
      };
      const metas = [...document.querySelectorAll('meta[name="theme-color"]')];
      return [getComputedStyle(bar).backgroundColor, ...metas.map((meta) => asShown(meta.content))];
    });
  const shown = [];
  for (let i = 0; i < 2; ++i) {
    const [bar, ...metas] = await colors();
    assert.deepEqual(metas, [bar, bar]);
    shown.push(bar);
    await page.click('#theme');
  }
  assert.notEqual(shown[0], shown[1]);
  assert.equal(
    await page.evaluate((color) => {
      document.body.style.color = color;
      return getComputedStyle(document.body).color;
    }, manifest.theme_color),
    shown[0],
    'the manifest has that of the dark theme',
  );
});

/** What an installed page has; `globalThis.launch` opens files with it. */
function playLaunches() {
  Object.defineProperty(globalThis, 'launchQueue', {
    value: {
      setConsumer: (consumer) => {
        globalThis.launch = (files) =>
          consumer({
            files: Object.entries(files).map(([name, text]) => ({
              getFile: async () => {
                if (text === null) throw new DOMException('gone', 'NotFoundError');
                return new File([text], name);
              },
            })),
          });
        // That it was started without a file.
        consumer({ files: [] });
      },
    },
  });
}

test('files that the system opens with the page are opened like any other', async (t) => {
  const page = await openPage(t, { prepare: (page) => page.addInitScript(playLaunches) });
  const launch = (files) => page.evaluate((files) => globalThis.launch(files), files);
  await launch({ 'waves.obj': grid(4) });
  await page.waitForFunction(() => document.querySelector('#source').textContent === 'waves.obj');
  await settled(page);
  assert.equal(await textOf(page, '#badge'), 'Valid');
  await launch({ 'lost.obj': null });
  await page.waitForFunction(() => document.querySelector('#alert').textContent !== '');
  assert.match(
    await textOf(page, '#alert'),
    /^The file was moved or deleted, so it cannot be read\. Open it again\./,
  );
  assert.equal(await textOf(page, '#source'), 'waves.obj');
});
