// The engine in threads that can start no worker: a shared worker and a service worker in Chromium,
// and a host that can neither read files nor compile WebAssembly, as edge functions.

import assert from 'node:assert/strict';
import { cpSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { createContext, runInContext } from 'node:vm';
import { buildSync } from 'esbuild';
import { createStaticServer, listen } from '../../scripts/serve.mjs';
import { examples } from './support/examples.mjs';
import { DIST, ROOT } from './support/paths.mjs';
import { NEEDS_CHROME, whileTesting } from './support/while-testing.mjs';

const here = whileTesting('hosts');

/** All that the engine offers, in one sentence. */
const TRY = `
  const SQUARE = {
    positions: [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0],
    indices: [0, 1, 2, 0, 2, 3],
    texcoords: [0, 0, 1, 0, 1, 1, 0, 1],
  };
  function tried(abflat) {
    const { report } = abflat.unwrap(abflat.sample('head'));
    const packed = abflat.pack(SQUARE);
    const { width } = abflat.bake(SQUARE, packed, { factor: [1, 0, 0, 1] }, { bakeResolution: 64 });
    return ['valid: ' + report.valid, packed.report.valid, width, abflat.build].join(' ');
  }
`;
const TRIED = /^valid: true true 64 simd$/;

const page = (code) =>
  `<!doctype html><link rel="icon" href="data:,"><body></body><script type="module">${code}</script>`;

/** A folder with the package's modules and these files, served. */
async function serve(name, files) {
  const root = join(here.folder, name);
  cpSync(DIST, join(root, 'dist'), { recursive: true });
  for (const [path, text] of Object.entries(files)) writeFileSync(join(root, path), text);
  return serveFolder(root);
}

async function serveFolder(root) {
  const server = createStaticServer(root);
  here.servers.push(server);
  return `http://127.0.0.1:${await listen(server, '127.0.0.1', 0, false)}`;
}

/** What a page shows once it has something to show. */
async function shown(address, context = here.browser) {
  const tab = await context.newPage();
  try {
    await tab.goto(`${address}/`);
    await tab.waitForFunction(() => document.body?.textContent.includes('valid'));
    return await tab.textContent('body');
  } finally {
    await tab.close();
  }
}

const ANSWERS = `
  const text = createAbflatSync({ also: ['pack', 'bake'] })
    .then(tried)
    .catch((error) => 'not valid: ' + error.message);
`;

test('a shared worker', NEEDS_CHROME, async () => {
  const worker = `
    import { createAbflatSync } from './dist/sync.js';
    ${TRY} ${ANSWERS}
    onconnect = ({ ports: [port] }) => text.then((answer) => port.postMessage(answer));
  `;
  const code = `
    const { port } = new SharedWorker('worker.js', { type: 'module' });
    port.onmessage = ({ data }) => (document.body.textContent = data);
    port.start();
  `;
  const address = await serve('shared', { 'worker.js': worker, 'index.html': page(code) });
  assert.match(await shown(address), TRIED);
});

test('a service worker', NEEDS_CHROME, async () => {
  const worker = `
    import { createAbflatSync } from './dist/sync.js';
    ${TRY} ${ANSWERS}
    addEventListener('install', () => skipWaiting());
    addEventListener('activate', (event) => event.waitUntil(clients.claim()));
    addEventListener('fetch', (event) => {
      if (event.request.url.endsWith('/answer')) event.respondWith(text.then((answer) => new Response(answer)));
    });
  `;
  const code = `
    await navigator.serviceWorker.register('worker.js', { type: 'module' });
    await navigator.serviceWorker.ready;
    if (!navigator.serviceWorker.controller)
      await new Promise((resolve) => navigator.serviceWorker.addEventListener('controllerchange', resolve));
    document.body.textContent = await (await fetch('/answer')).text();
  `;
  const address = await serve('service', { 'worker.js': worker, 'index.html': page(code) });
  const context = await here.browser.newContext({ serviceWorkers: 'allow' });
  assert.match(await shown(address, context), TRIED);
  await context.close();
});

test('the thread of a page', NEEDS_CHROME, async () => {
  const code = `
    import { createAbflatSync } from './dist/sync.js';
    ${TRY} ${ANSWERS}
    document.body.textContent = await text;
  `;
  assert.match(await shown(await serve('page', { 'index.html': page(code) })), TRIED);
});

test(
  'after a lack of memory in the thread of a page the next call works',
  NEEDS_CHROME,
  async () => {
    const code = `
    import { createAbflatSync } from './dist/sync.js';
    const abflat = await createAbflatSync({ maxMemory: 2 ** 25 });
    const found = [];
    for (let i = 0; i < 2; ++i) {
      try { abflat.unwrap({ positions: new Float64Array(9e5) }); } catch (error) { found.push(error.code); }
      found.push(abflat.unwrap(abflat.sample('hemisphere')).report.valid);
    }
    document.body.textContent = 'valid: ' + found;
  `;
    assert.equal(
      await shown(await serve('memory', { 'index.html': page(code) })),
      'valid: OutOfMemory,true,OutOfMemory,true',
    );
  },
);

/** A script in one file that needs nothing of the package's folder, with `answer` as its result. */
function bundled(code) {
  const { outputFiles } = buildSync({
    stdin: { contents: code, resolveDir: ROOT },
    bundle: true,
    format: 'iife',
    globalName: 'answer',
    platform: 'neutral',
    mainFields: ['module', 'main'],
    conditions: ['workerd', 'worker'],
    write: false,
    logLevel: 'silent',
  });
  return outputFiles[0].text;
}

/** Runs a script as workerd does: without workers, files, and code that is compiled on the spot. */
async function inEdge(code, given = {}) {
  const { AbortController, AbortSignal, DOMException, performance, TextDecoder, TextEncoder, URL } =
    globalThis;
  const globals = {
    ...{ AbortController, AbortSignal, DOMException, performance, TextDecoder, TextEncoder, URL },
    ...given,
  };
  const context = createContext(globals, { codeGeneration: { strings: false, wasm: false } });
  runInContext(bundled(code), context);
  return runInContext('answer.default', context);
}

const compiled = (name) => WebAssembly.compile(readFileSync(join(DIST, name)));

test('a host without workers, files and compilers takes the modules', async () => {
  const given = {
    main: await compiled('abflat-simd.wasm'),
    pack: await compiled('abflat-pack.wasm'),
    bake: await compiled('abflat-bake.wasm'),
  };
  const code = `
    import { createAbflatSync } from 'abflat/sync';
    ${TRY}
    export default createAbflatSync({ wasmUrl: main, packUrl: pack, bakeUrl: bake }).then(tried);
  `;
  assert.match(await inEdge(code, given), TRIED);
});

test('there, errors say what to hand over', async () => {
  const code = `
    import { createAbflatSync } from 'abflat/sync';
    export default createAbflatSync().catch(({ code, message }) => code + ' ' + message);
  `;
  assert.match(
    await inEdge(code),
    /^UnreadableFile .*import the module and pass it: createAbflatSync\(\{ wasmUrl: module \}\)\.$/,
  );
  const withMain = code.replace('()', "({ wasmUrl: main, also: ['pack'] })");
  const main = await compiled('abflat-simd.wasm');
  assert.match(await inEdge(withMain, { main }), /createAbflatSync\(\{ packUrl: module \}\)\.$/);
});

test('the example for edge functions in the README answers', async () => {
  const code = examples()
    .edge.replace(/import (\w+) from 'abflat\/abflat-simd\.wasm';/, 'const $1 = main;')
    .replace('export default', 'const handler =');
  const body = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0] };
  const run = `${code}\nexport default handler.fetch({ json: async () => (${JSON.stringify(body)}) });`;
  const Response = { json: (value) => ({ value }) };
  const main = await compiled('abflat-simd.wasm');
  const { value } = await inEdge(run, { main, Response });
  assert.equal(value.uv.length, 6);
});

test(
  'a Vite build of abflat/sync has the builds that it can run, and no worker',
  NEEDS_CHROME,
  async () => {
    const require = createRequire(join(ROOT, 'web/package.json'));
    const path = require.resolve('vite');
    const vite = await import(pathToFileURL(path.replace(/index\.cjs$/, 'dist/node/index.js')));
    const root = join(here.folder, 'vite');
    mkdirSync(root);
    const code = `import { createAbflatSync } from 'abflat/sync'; ${TRY}
    createAbflatSync({ also: ['pack', 'bake'] }).then(tried).then((answer) => (document.body.textContent = answer));`;
    writeFileSync(
      join(root, 'index.html'),
      '<!doctype html><link rel="icon" href="data:,"><body></body><script type="module" src="./main.js"></script>',
    );
    writeFileSync(join(root, 'main.js'), code);
    await vite.build({ root, logLevel: 'warn', configFile: false });
    const names = readdirSync(join(root, 'dist/assets')).map((name) =>
      name.replace(/-[\w-]{8}\./, '.'),
    );
    assert.deepEqual(names.filter((name) => name.endsWith('.wasm')).sort(), [
      'abflat-bake.wasm',
      'abflat-pack.wasm',
      'abflat-simd.wasm',
    ]);
    assert.deepEqual(
      names.filter((name) => /worker|threads/.test(name)),
      [],
    );
    assert.match(await shown(await serveFolder(join(root, 'dist'))), TRIED);
  },
);
