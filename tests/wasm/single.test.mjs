// The entry that is one file: in Node alone in a folder, in Chromium inline, from a blob and in a
// worker made of text.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { createAbflatSync } from 'abflat/single';
import { createAbflatSync as fromFiles } from 'abflat/sync';
import { unwrapGeometry } from 'abflat/three';
import * as THREE from 'three';
import { findChrome } from '../../scripts/lib/requirements.mjs';
import { createStaticServer, listen } from '../../scripts/serve.mjs';
import { startBrowser } from '../../web/scripts/browser.mjs';
import { grid } from './support/meshes.mjs';
import { DIST } from './support/paths.mjs';

const hasChrome = findChrome() !== undefined;
const NEEDS_CHROME = { skip: hasChrome ? false : 'there is no Chromium' };
const FILE = join(DIST, 'single.js');
const TEXT = readFileSync(FILE, 'utf8');

let browser;
let folder;
const servers = [];
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'abflat-single-'));
  if (hasChrome) browser = await startBrowser({ webgl: false });
});
after(async () => {
  await browser?.close();
  for (const server of servers) server.close();
  rmSync(folder, { recursive: true });
});

test('it looks for no other file, and can stand in a page of any encoding', () => {
  assert.doesNotMatch(TEXT, /\bimport\s*\(|^import\b|new URL\(/m);
  assert.doesNotMatch(TEXT, /[^\x20-\x7e\n]/);
  assert.doesNotMatch(TEXT, /<\/script|<!--/i);
});

test('it is there at once, and gives the bytes of the package', async () => {
  const own = createAbflatSync();
  const other = await fromFiles();
  assert.equal(own.build, 'simd');
  const mesh = other.sample('head');
  assert.deepEqual(own.sample('head'), mesh);
  const [found, wanted] = [own, other].map((abflat) => abflat.unwrap(mesh, { obj: true }));
  for (const name of ['uv', 'indices', 'vertexMap', 'obj'])
    assert.deepEqual(found[name], wanted[name], name);
  assert.deepEqual(own.flatten(mesh).uv, other.flatten(mesh).uv);
  for (const name of ['compare', 'inspect']) assert.ok(own[name](mesh));
  assert.deepEqual(
    Object.keys(other).filter((name) => !(name in own)),
    ['pack', 'verify', 'bake'],
  );
});

test('lack of memory, wrong options and terminate are as in the package', () => {
  const small = createAbflatSync({ maxMemory: 2 ** 25 });
  assert.throws(() => small.flatten(grid(300)), { code: 'OutOfMemory', message: /32 MB/ });
  assert.equal(small.unwrap(grid(3)).report.valid, true);
  small.terminate();
  assert.throws(() => small.unwrap(grid(3)), { name: 'AbortError' });
  for (const options of [{ wasmUrl: '/abflat.wasm' }, { also: ['pack'] }, { maxMemory: 1 }])
    assert.throws(() => createAbflatSync(options), { code: 'InvalidOption' });
});

test('helpers take it', async () => {
  const { result } = await unwrapGeometry(createAbflatSync(), new THREE.BoxGeometry());
  assert.equal(result.report.valid, true);
});

test('the file alone in a folder runs in Node', () => {
  copyFileSync(FILE, join(folder, 'abflat.mjs'));
  const text = `
    import { createAbflatSync } from './abflat.mjs';
    const abflat = createAbflatSync();
    console.log(abflat.unwrap(abflat.sample('head')).report.valid);
  `;
  writeFileSync(join(folder, 'main.mjs'), text);
  const { stdout, stderr } = spawnSync(process.execPath, ['main.mjs'], {
    cwd: folder,
    encoding: 'utf8',
  });
  assert.deepEqual([stdout, stderr], ['true\n', '']);
});

const HEAD = '<!doctype html><link rel="icon" href="data:,"><body></body>';
/** Ends what the module is followed by. */
const SHOW = `
  const say = (text) => (document.body.textContent = text);
  const tried = (createAbflatSync) => {
    const abflat = createAbflatSync();
    return 'valid: ' + abflat.unwrap(abflat.sample('head')).report.valid;
  };
`;

/** What a page of this text says, and what it loads beside itself. */
async function shown(html, headers = {}) {
  writeFileSync(join(folder, 'index.html'), html);
  const server = createStaticServer(folder, headers);
  servers.push(server);
  const page = await browser.newPage();
  try {
    const loaded = [];
    page.on('request', (request) => loaded.push(request.url()));
    await page.goto(`http://127.0.0.1:${await listen(server, '127.0.0.1', 0, false)}/`);
    await page.waitForFunction(() => document.body?.innerText.includes('valid'));
    const others = loaded.slice(1).filter((url) => !/^(blob|data):/.test(url));
    return [await page.innerText('body'), ...others];
  } finally {
    await page.close();
  }
}

test('inline in a page', NEEDS_CHROME, async () => {
  const html = `${HEAD}<script type="module">${TEXT}\n${SHOW} say(tried(createAbflatSync));</script>`;
  assert.deepEqual(await shown(html), ['valid: true']);
});

/** The text of the file, as a page has it. */
const INLINE = `<script type="text/plain" id="abflat">${TEXT}</script>`;
const BLOB = `
  const text = document.getElementById('abflat').textContent;
  const address = (script) => URL.createObjectURL(new Blob([script], { type: 'text/javascript' }));
`;

test('from a blob', NEEDS_CHROME, async () => {
  const code = `${SHOW}${BLOB} import(address(text)).then((module) => say(tried(module.createAbflatSync)));`;
  const html = `${HEAD}${INLINE}<script type="module">${code}</script>`;
  assert.deepEqual(await shown(html), ['valid: true']);
});

test('in a worker made of its text', NEEDS_CHROME, async () => {
  const code = `${SHOW}${BLOB}
    const run = '\\nconst abflat = createAbflatSync();' +
      'postMessage("valid: " + abflat.unwrap(abflat.sample("head")).report.valid);';
    new Worker(address(text + run), { type: 'module' }).onmessage = ({ data }) => say(data);`;
  const html = `${HEAD}${INLINE}<script type="module">${code}</script>`;
  assert.deepEqual(await shown(html), ['valid: true']);
});

test('where a policy forbids WebAssembly, one sentence says so', NEEDS_CHROME, async () => {
  const code = `${SHOW} try { say(tried(createAbflatSync)); } catch (error) { say('not valid: ' + error.code + ' ' + error.message); }`;
  const html = `${HEAD}<script type="module">${TEXT}\n${code}</script>`;
  const policy = "script-src 'unsafe-inline'";
  const [text] = await shown(html, { 'Content-Security-Policy': policy });
  assert.match(
    text,
    /^not valid: UnsupportedHost WebAssembly cannot be compiled in this thread: .*\.$/,
  );
});
