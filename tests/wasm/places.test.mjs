// Where the package's files can be: left out by a bundler, on another origin under a content
// security policy, on a server that knows few types, and as CommonJS.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { createAbflat } from 'abflat';
import { buildSync } from 'esbuild';
import { fileFor, ISOLATED, listen } from '../../scripts/serve.mjs';
import { examples } from './support/examples.mjs';
import { grid } from './support/meshes.mjs';
import { DIST, ROOT } from './support/paths.mjs';
import { NEEDS_CHROME, whileTesting } from './support/while-testing.mjs';

const here = whileTesting('places');

/**
 * Serves a folder with types for pages and scripts only, as servers with little configuration do.
 * `headers` are sent with all files, or only with the pages.
 */
async function serve(root, headers = {}, { onPages = false } = {}) {
  const types = { '.html': 'text/html', '.js': 'text/javascript' };
  const server = createServer((request, response) => {
    const file = fileFor(root, request.url);
    const type = file && types[extname(file)];
    response.writeHead(file ? 200 : 404, {
      ...(!onPages || type === 'text/html' ? headers : {}),
      ...(type && { 'Content-Type': type }),
    });
    response.end(file && readFileSync(file));
  });
  here.servers.push(server);
  return `http://127.0.0.1:${await listen(server, '127.0.0.1', 0, false)}`;
}

/** What a page that runs a script shows. */
async function shown(address) {
  const page = await here.browser.newPage();
  try {
    await page.goto(`${address}/`);
    await page.waitForFunction(() => document.body?.textContent.includes('valid'));
    return await page.textContent('body');
  } finally {
    await page.close();
  }
}

/** A script that unwraps something with `createAbflat(${settings})` and reports how that went. */
const script = (entry, settings = '') => `
  import { createAbflat } from '${entry}';

  async function show() {
    const abflat = await createAbflat(${settings});
    const { report } = await abflat.unwrap(await abflat.sample('hemisphere'));
    return 'valid: ' + report.valid + ' ' + abflat.build;
  }

  show()
    .catch(({ code, message }) => 'not valid: ' + code + ' ' + message)
    .then((text) => (document.body.textContent = text));
`;

const page = (tag) => `<!doctype html><link rel="icon" href="data:,">${tag}<body></body>`;

/** A site whose script is bundled by esbuild, with the files that are copied into it. */
function bundled(name, text, { format = 'esm', files = {}, folder: path = '' } = {}) {
  const root = join(here.folder, name);
  mkdirSync(root);
  const tag =
    format === 'esm'
      ? `<script type="module" src="${path}main.js">`
      : '<script defer src="main.js">';
  writeFileSync(join(root, 'index.html'), page(`${tag}</script>`));
  buildSync({
    stdin: { contents: text, resolveDir: ROOT },
    bundle: true,
    format,
    outfile: join(root, path, 'main.js'),
    logLevel: 'silent',
  });
  for (const [path, from] of Object.entries(files))
    cpSync(from, join(root, path), { recursive: true });
  return root;
}

const CASES = [
  ['esm', /UnreadableFile Cannot load \S+abflat-simd\.wasm: 404/],
  ['iife', /UnreadableFile A bundle that is not an ES module/],
];
for (const [format, missing] of CASES)
  test(
    `a bundle without the files (${format}) says what is missing, and finds it at baseUrl`,
    NEEDS_CHROME,
    async () => {
      const without = bundled(`without-${format}`, script('abflat'), { format });
      const text = await shown(await serve(without));
      assert.match(text, missing);
      assert.match(text, /baseUrl/);
      if (format === 'esm')
        assert.match(text, /cp -r node_modules\/abflat\/dist public\/abflat.*'\/abflat\/'/);

      const [, settings] = examples().base.match(/createAbflat\((.*)\)/);
      const root = bundled(`with-${format}`, script('abflat', settings), {
        format,
        files: { abflat: DIST },
      });
      assert.equal(await shown(await serve(root)), 'valid: true simd');
      assert.match(await shown(await serve(root, ISOLATED)), /^valid: true (simd|threads)$/);
    },
  );

test(
  'where the development server of Vite has lost the files, the error says what mends it',
  NEEDS_CHROME,
  async () => {
    const root = bundled('vite-lost', script('abflat'), { folder: 'node_modules/.vite/deps/' });
    assert.match(await shown(await serve(root)), /abflat-simd\.wasm: 404.*optimizeDeps/);
  },
);

test(
  'baseUrl takes an address with or without a slash, a URL, and the place of another origin',
  NEEDS_CHROME,
  async () => {
    const other = await serve(DIST, { 'Access-Control-Allow-Origin': '*' });
    const all = ["'/abflat'", "'abflat/'", "new URL('abflat', location.href)", `'${other}'`];
    for (const [i, baseUrl] of all.entries()) {
      const text = script('abflat', `{ baseUrl: ${baseUrl}, build: 'simd' }`);
      const root = bundled(`base-${i}`, text, { files: { abflat: DIST } });
      assert.equal(await shown(await serve(root)), 'valid: true simd', baseUrl);
    }
  },
);

test(
  'a content security policy that allows blob: workers and WebAssembly, and one that does not',
  NEEDS_CHROME,
  async () => {
    const other = await serve(DIST, { 'Access-Control-Allow-Origin': '*' });
    const root = join(here.folder, 'policy');
    mkdirSync(root);
    writeFileSync(
      join(root, 'index.html'),
      page(`<script type="module">${script(`${other}/index.js`)}</script>`),
    );
    const policy = (workers) => ({
      'Content-Security-Policy':
        `default-src 'none'; img-src data:; script-src 'unsafe-inline' 'wasm-unsafe-eval' ${other}; ` +
        `connect-src ${other}; worker-src ${workers}`,
    });
    assert.equal(await shown(await serve(root, policy(`blob: ${other}`))), 'valid: true simd');
    assert.match(await shown(await serve(root, policy(other))), /worker-src.*blob:/);
  },
);

test(
  'an isolated page whose scripts lack the header of theirs hears of it',
  NEEDS_CHROME,
  async () => {
    const root = bundled('header', script('abflat', "{ baseUrl: '/abflat/' }"), {
      files: { abflat: DIST },
    });
    assert.match(
      await shown(await serve(root, ISOLATED, { onPages: true })),
      /UnreadableFile Cannot load the worker.*without the header Cross-Origin-Embedder-Policy/,
    );
  },
);

test('Node takes a folder as baseUrl, and says where files are missing', async () => {
  for (const baseUrl of [DIST, `${DIST}/`, pathToFileURL(DIST), pathToFileURL(DIST).href]) {
    const abflat = await createAbflat({ baseUrl });
    assert.equal((await abflat.unwrap(grid(3))).report.valid, true);
    abflat.terminate();
  }
  const missing = { code: 'UnreadableFile', message: /nowhere.abflat-simd\.wasm/ };
  await assert.rejects(createAbflat({ baseUrl: '/nowhere' }), missing);
  for (const baseUrl of [5, '', null, {}])
    await assert.rejects(createAbflat({ baseUrl }), { code: 'InvalidOption', message: /baseUrl/ });
});

test('a Node bundle without the files says how to keep the package out of it', () => {
  const outfile = join(here.folder, 'node-bundle.mjs');
  const contents = `import { createAbflat } from 'abflat'; createAbflat().catch((e) => console.log(e.message));`;
  buildSync({
    stdin: { contents, resolveDir: ROOT },
    bundle: true,
    platform: 'node',
    format: 'esm',
    outfile,
  });
  const { stdout, stderr } = spawnSync(process.execPath, [outfile], { encoding: 'utf8' });
  assert.match(stdout, /Cannot load .*abflat-simd\.wasm.*serverExternalPackages.*baseUrl/, stderr);
});

test('require gives the package, where Node can', () => {
  const text = `
    const { createAbflat } = require('abflat');
    createAbflat().then((abflat) => abflat.sample('head')).then(({ indices }) => console.log(indices.length > 0));
  `;
  const args = ['--input-type=commonjs', '--eval', text];
  const { stdout, stderr } = spawnSync(process.execPath, args, { cwd: ROOT, encoding: 'utf8' });
  if (process.features.require_module) assert.equal(stdout, 'true\n', stderr);
  else assert.match(stderr, /ERR_REQUIRE_ESM.*import\(\)/s);
});

test('a worker of the page takes the package as the page does', NEEDS_CHROME, async () => {
  const root = join(here.folder, 'in-worker');
  mkdirSync(root);
  cpSync(DIST, join(root, 'dist'), { recursive: true });
  const text = script('./dist/index.js').replace(
    '(document.body.textContent = text)',
    'postMessage(text)',
  );
  writeFileSync(join(root, 'worker.js'), text);
  const start = `new Worker('worker.js', { type: 'module' }).onmessage = ({ data }) => (document.body.textContent = data);`;
  writeFileSync(join(root, 'index.html'), page(`<script type="module">${start}</script>`));
  assert.equal(await shown(await serve(root)), 'valid: true simd');
  assert.match(await shown(await serve(root, ISOLATED)), /^valid: true (simd|threads)$/);
});
