// The build with threads, which needs a cross-origin isolated page: in Chromium, alongside a page
// that is not isolated.

import assert from 'node:assert/strict';
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { findChrome } from '../../scripts/lib/requirements.mjs';
import { createStaticServer, ISOLATED, listen } from '../../scripts/serve.mjs';
import { startBrowser } from '../../web/scripts/browser.mjs';
import { sphere } from '../support/surfaces.mjs';
import { DIST, ROOT } from './support/paths.mjs';

const hasChrome = findChrome() !== undefined;
const NEEDS_CHROME = { skip: hasChrome ? false : 'there is no Chromium' };

/** Scripts of the site that start the package's worker without something that threads need. */
const WORKERS = {
  'no-memory.js': `const { Memory } = WebAssembly;
    WebAssembly.Memory = class extends Memory {
      constructor(wanted) {
        if (wanted.shared) throw new RangeError('could not allocate memory');
        super(wanted);
      }
    };`,
  'no-workers.js': `self.Worker = class { constructor() { throw new Error('refused'); } };`,
  'no-script.js': `const Original = self.Worker;
    self.Worker = class extends Original { constructor() { super('/nowhere.js'); } };`,
  'no-module.js': `const Original = self.Worker;
    self.Worker = class extends Original {
      postMessage(message) {
        super.postMessage(message.cmd === 'load' ? { ...message, urlOrBlob: '/nowhere.js' } : message);
      }
    };`,
};

let browser;
let folder;
const servers = [];

before(async () => {
  if (!hasChrome) return;
  mkdirSync(join(ROOT, 'build/tests'), { recursive: true });
  folder = mkdtempSync(join(ROOT, 'build/tests/wasm-threads-'));
  cpSync(DIST, join(folder, 'dist'), { recursive: true });
  writeFileSync(join(folder, 'index.html'), '<!doctype html><link rel="icon" href="data:,">');
  for (const [name, text] of Object.entries(WORKERS)) {
    writeFileSync(join(folder, `patch-${name}`), text);
    writeFileSync(join(folder, name), `import './patch-${name}'; import './dist/worker.js';`);
  }
  browser = await startBrowser({ webgl: false });
});
after(async () => {
  await browser?.close();
  for (const server of servers) server.close();
  if (folder) rmSync(folder, { recursive: true });
});

/** Runs a function in a page; `headers` are sent with everything that the page loads. */
async function inPage(headers, action, argument) {
  const server = createStaticServer(folder, headers);
  servers.push(server);
  const page = await browser.newPage();
  try {
    await page.goto(`http://127.0.0.1:${await listen(server, '127.0.0.1', 0, false)}/`);
    // Even on a machine with one processor; the worker counts for itself.
    await page.evaluate(() =>
      Object.defineProperty(navigator, 'hardwareConcurrency', { value: 2 }),
    );
    return await page.evaluate(action, argument);
  } finally {
    await page.close();
  }
}

test('an isolated page runs threads, with the bytes of the other build', NEEDS_CHROME, async () => {
  const found = await inPage(ISOLATED, async () => {
    const { bestBuild, createAbflat } = await import('/dist/index.js');
    const abflat = await createAbflat();
    const simd = await createAbflat({ build: 'simd' });
    const same = (a, b) => {
      const [x, y] = [a, b].map(({ buffer }) => new Uint8Array(buffer));
      return x.length > 0 && x.length === y.length && x.every((byte, i) => byte === y[i]);
    };
    const runs = [];
    for (const [name, detail, options] of [
      ['hemisphere', 1, {}],
      ['head', 20, { t: 2 }],
      ['head', 2, {}],
      ['head', 2, { t: 1, memory: 1 }],
    ]) {
      const mesh = await simd.sample(name, { detail });
      const wanted = await simd.flatten(mesh, { ...options, obj: true });
      for (const threads of [0, 1, 2, 256]) {
        const result = await abflat.flatten(mesh, { ...options, threads, obj: true });
        runs.push({
          same: ['uv', 'indices', 'vertexMap', 'obj'].every((key) =>
            same(result[key], wanted[key]),
          ),
          faces: mesh.indices.length / 3,
          threads,
          used: result.report.threads,
          valid: result.report.valid,
        });
      }
    }
    const processors = new Worker(
      URL.createObjectURL(new Blob(['postMessage(navigator.hardwareConcurrency)'])),
    );
    const count = await new Promise((resolve) => {
      processors.onmessage = ({ data }) => resolve(data);
    });
    return { best: bestBuild(), build: abflat.build, simd: simd.build, runs, count };
  });
  assert.deepEqual([found.best, found.build, found.simd], ['threads', 'threads', 'simd']);
  for (const { same, faces, threads, used, valid } of found.runs) {
    assert.ok(same, `${faces} faces, ${threads} threads`);
    assert.ok(valid);
    if (faces < 4000) assert.equal(used, 1);
    else assert.ok(used <= Math.min(found.count, threads || 256), `${used} of ${threads} threads`);
    if (faces >= 4000 && threads === 2) assert.equal(used, Math.min(found.count, 2));
  }
});

test('atlases do not depend on threads or build', NEEDS_CHROME, async () => {
  const ball = sphere(28);
  const argument = {
    positions: ball.positions.flat(),
    indices: ball.faces.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]),
  };
  const found = await inPage(
    ISOLATED,
    async ({ positions, indices }) => {
      const { createAbflat } = await import('/dist/index.js');
      const mesh = {
        positions: Float64Array.from(positions),
        indices: Uint32Array.from(indices),
      };
      const builds = await Promise.all(['simd', 'threads'].map((build) => createAbflat({ build })));
      const same = (a, b) => {
        const [x, y] = [a, b].map(({ buffer }) => new Uint8Array(buffer));
        return x.length > 0 && x.length === y.length && x.every((byte, i) => byte === y[i]);
      };
      const wanted = await builds[0].unwrap(mesh, { obj: true });
      const runs = [];
      for (const abflat of builds)
        for (const threads of [0, 1, 2]) {
          const result = await abflat.unwrap(mesh, { threads, obj: true });
          const different = [
            'uv',
            'indices',
            'vertexMap',
            'chartOfTriangle',
            'seams',
            'obj',
          ].filter((key) => !same(result[key], wanted[key]));
          const { valid, threads: used } = result.report;
          runs.push({ build: abflat.build, threads, used, different, valid });
        }
      return runs;
    },
    argument,
  );
  assert.equal(found.length, 6);
  for (const { build, threads, used, different, valid } of found) {
    assert.deepEqual(different, [], `${build}, ${threads} threads`);
    assert.ok(valid);
    if (build !== 'threads') assert.equal(used, 1);
  }
});

test('a page that is not isolated takes simd, and refuses threads', NEEDS_CHROME, async () => {
  const found = await inPage({}, async () => {
    const { bestBuild, createAbflat } = await import('/dist/index.js');
    const { build } = await createAbflat();
    const asked = [{ build: 'threads' }, { wasmUrl: '/dist/abflat-threads.wasm' }];
    const errors = await Promise.all(
      asked.map((options) => createAbflat(options).catch(({ code, message }) => [code, message])),
    );
    return { best: bestBuild(), build, errors };
  });
  assert.deepEqual([found.best, found.build], ['simd', 'simd']);
  for (const [code, message] of found.errors) {
    assert.equal(code, 'InvalidOption');
    assert.match(message, /not cross-origin isolated.*Cross-Origin-Embedder-Policy/);
  }
});

for (const worker of Object.keys(WORKERS)) {
  test(`where threads cannot start (${worker}), simd runs instead`, NEEDS_CHROME, async () => {
    const found = await inPage(
      ISOLATED,
      async (worker) => {
        const { createAbflat } = await import('/dist/index.js');
        const workerUrl = `/${worker}`;
        const asked = await createAbflat({ workerUrl, build: 'threads' }).catch((e) => e.code);
        const abflat = await createAbflat({ workerUrl });
        const { report } = await abflat.flatten(await abflat.sample('hemisphere'));
        return [asked, abflat.build, report.valid];
      },
      worker,
    );
    assert.deepEqual(found, ['Internal', 'simd', true]);
  });
}

test(
  'lack of memory and an abort end a run on threads, and the next one works',
  NEEDS_CHROME,
  async () => {
    const found = await inPage(ISOLATED, async () => {
      const { createAbflat } = await import('/dist/index.js');
      const simd = await createAbflat({ build: 'simd' });
      const large = await simd.sample('head', { detail: 20 });
      const small = await simd.sample('hemisphere');
      const abflat = await createAbflat({ build: 'threads' });
      const aborted = [];
      for (const steps of [1, 2, 3]) {
        const controller = new AbortController();
        const onProgress = ({ newtonStep }) => newtonStep >= steps && controller.abort();
        aborted.push(
          await abflat
            .flatten(large, { signal: controller.signal, onProgress })
            .catch((e) => e.name),
        );
      }
      const codes = [];
      for (let megabytes = 32; megabytes <= 144; megabytes += 16) {
        const limited = await createAbflat({ build: 'threads', maxMemory: megabytes * 2 ** 20 });
        codes.push(
          await limited.flatten(large).then(
            ({ report }) => report.valid,
            ({ code }) => code,
          ),
        );
        codes.push((await limited.flatten(small)).report.valid);
        limited.terminate();
      }
      const { report } = await abflat.flatten(small);
      return { aborted, codes, valid: report.valid, faces: large.indices.length / 3 };
    });
    assert.deepEqual(found.aborted, ['AbortError', 'AbortError', 'AbortError']);
    assert.ok(found.valid);
    assert.equal(found.codes[0], 'OutOfMemory', `${found.faces} faces`);
    for (const code of found.codes) assert.ok(code === 'OutOfMemory' || code === true, code);
  },
);
