// Meshes that were open before take no memory.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { objText, sphere } from '../support/surfaces.mjs';
import { dropAndWait, openPage, settled } from './page.mjs';

const BALL = objText(sphere(14));

test('ten more meshes, each with a change, leave memory as it was', async (t) => {
  const page = await openPage(t, { own: true });
  const client = await page.context().newCDPSession(page);
  const bytes = async () => {
    await client.send('HeapProfiler.collectGarbage');
    const usage = await client.send('Runtime.getHeapUsage');
    return usage.usedSize + usage.embedderHeapUsedSize + (usage.backingStorageSize ?? 0);
  };
  const open = async (name) => {
    await dropAndWait(page, name, BALL);
    for (const id of ['#seams-auto', '#undo']) {
      await page.click(id);
      await settled(page);
    }
  };
  for (let i = 0; i < 3; ++i) await open(`first-${i}.obj`);
  const before = await bytes();
  for (let i = 0; i < 10; ++i) await open(`ball-${i}.obj`);
  const after = await bytes();
  t.diagnostic(`${(before / 1e6).toFixed(1)} MB, then ${(after / 1e6).toFixed(1)} MB`);
  assert.ok(after < 1.15 * before, `${before} bytes became ${after}`);
});
