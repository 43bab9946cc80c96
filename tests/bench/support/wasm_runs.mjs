// Runs the npm package on a file, from the bytes to the OBJ text, in Node and in Chromium.

import { readFileSync } from 'node:fs';
import { basename, relative } from 'node:path';
import { ROOT } from '../../../scripts/lib/paths.mjs';
import { createStaticServer, listen } from '../../../scripts/serve.mjs';
import { launchBrowser } from '../../../web/scripts/browser.mjs';
import { STAGES } from './results.mjs';

const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** Best run in a separate process, because of its peak memory. */
export async function runInNode(path, { build, t, repeat }) {
  const { createAbflat } = await import('abflat');
  const abflat = await createAbflat({ build });
  const calls = [];
  try {
    for (let i = 0; i < repeat; ++i) {
      const bytes = readFileSync(path);
      const start = performance.now();
      const { report } = await abflat.flatten({ bytes, name: basename(path) }, { t, obj: true });
      calls.push({ call: (performance.now() - start) / 1000, report });
    }
  } finally {
    abflat.terminate();
  }
  const { report } = calls.at(-1);
  const [chart] = report.charts;
  const row = {
    faces: chart.faces,
    t: chart.t,
    repeat,
    call: median(calls.map(({ call }) => call)),
  };
  for (const stage of STAGES) row[stage] = median(calls.map((call) => call.report.timings[stage]));
  return Object.assign(row, {
    iterations: chart.iterations,
    residual: chart.constraintResidual,
    valid: report.valid && chart.converged,
    memoryMB: (process.resourceUsage().maxRSS * 1024) / 1e6,
    node: process.version,
  });
}

/**
 * Seconds from nothing loaded to the result, as for someone who opens a page: with a new browser
 * each time.
 */
export async function runInChromium(path, { t, repeat }) {
  const server = createStaticServer(ROOT);
  const port = await listen(server, '127.0.0.1', 0, false);
  const address = `http://127.0.0.1:${port}`;
  const seconds = [];
  try {
    for (let i = 0; i < repeat; ++i)
      seconds.push(await runInPage(address, { mesh: `/${relative(ROOT, path)}`, t }));
  } finally {
    server.close();
  }
  return median(seconds);
}

async function runInPage(address, options) {
  const { context, close } = await launchBrowser({ webgl: false });
  try {
    const page = await context.newPage();
    await page.goto(`${address}/wasm/dist/LICENSE.txt`);
    return await page.evaluate(async ({ mesh, t }) => {
      const start = performance.now();
      const { createAbflat } = await import('/wasm/dist/index.js');
      const abflat = await createAbflat();
      const bytes = await (await fetch(mesh)).arrayBuffer();
      const { obj, report } = await abflat.flatten(
        { bytes, name: mesh },
        { t, obj: true, transfer: true },
      );
      if (!report.valid || obj.length === 0) throw new Error('the result is not valid');
      return (performance.now() - start) / 1000;
    }, options);
  } finally {
    await close();
  }
}
