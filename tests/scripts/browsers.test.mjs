// Browsers that test files share.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { withBrowsers } from '../../scripts/lib/browsers.mjs';
import { runPool } from '../../scripts/lib/pool.mjs';

/** Counts what is started; a browser is dead once its number is in `dead`. */
function made() {
  const all = [];
  const dead = new Set();
  const serve = async () => {
    const number = all.length;
    const browser = {
      isClosed: false,
      wsEndpoint: () => String(number),
      process: () => ({ exitCode: dead.has(number) ? 1 : null }),
      close: async () => {
        browser.isClosed = true;
      },
    };
    all.push(browser);
    return browser;
  };
  return { all, dead, serve };
}

const job = (name, work) => ({
  name,
  run: async ({ ABFLAT_BROWSER }) => {
    await work?.(ABFLAT_BROWSER);
    return { passed: 1, failed: 0, skipped: 0, output: ABFLAT_BROWSER };
  },
});

const usedBy = (records) => records[0].parts.map(({ output }) => output);

test('jobs of a lane use one browser, those of two lanes never the same at once', async () => {
  const { all, serve } = made();
  const busy = new Set();
  const work = async (browser) => {
    assert.ok(!busy.has(browser));
    busy.add(browser);
    await new Promise((done) => setTimeout(done));
    busy.delete(browser);
  };
  const jobs = ['a', 'b', 'c', 'd', 'e'].map((name) => job(name, work));
  await runPool([{ title: 'web', jobs: withBrowsers(jobs, serve) }], 2, () => undefined);
  assert.equal(all.length, 2);
  assert.ok(all.every(({ isClosed }) => isClosed));
});

test('a browser that ended is replaced', async () => {
  const { all, dead, serve } = made();
  const jobs = [job('a', () => dead.add(0)), job('b'), job('c')];
  const records = await runPool(
    [{ title: 'web', jobs: withBrowsers(jobs, serve) }],
    1,
    () => undefined,
  );
  assert.deepEqual(usedBy(records), ['0', '1', '1']);
  assert.ok(all[1].isClosed);
});

test('a job that throws leaves its browser to the next one', async () => {
  const { all, serve } = made();
  const fail = () => {
    throw new Error('no');
  };
  const [first, second] = withBrowsers([job('a', fail), job('b')], serve);
  await assert.rejects(first.run(), /no/);
  assert.equal((await second.run()).output, '0');
  assert.ok(all[0].isClosed);
});
