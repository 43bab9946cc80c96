// The little web server behind `npm start`.

import assert from 'node:assert/strict';
import { appendFileSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { Agent, request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { brotliCompressSync, brotliDecompressSync, gunzipSync, gzipSync } from 'node:zlib';
import { acceptedEncodings } from '../../scripts/lib/encodings.mjs';
import { createStaticServer, fileFor, listen } from '../../scripts/serve.mjs';

let folder;
const servers = [];

function start(port = 0, fallback = false) {
  const server = createStaticServer(join(folder, 'site'));
  servers.push(server);
  return listen(server, '127.0.0.1', port, fallback);
}

/** Sends the path unchanged: fetch would normalize "..". */
function ask(port, path, { method = 'GET', headers: sent = {} } = {}) {
  return new Promise((resolve, reject) => {
    const call = request({ port, path, method, headers: sent }, (response) => {
      const chunks = [];
      response.on('data', (chunk) => chunks.push(chunk));
      response.on('end', () => {
        const { statusCode: status, headers } = response;
        resolve({ status, headers, bytes: Buffer.concat(chunks) });
      });
    });
    call.on('error', reject).end();
  });
}

async function get(port, path, method = 'GET') {
  const { status, headers, bytes } = await ask(port, path, { method });
  return { status, type: headers['content-type'], text: bytes.toString() };
}

before(() => {
  folder = mkdtempSync(join(tmpdir(), 'abflat-serve-'));
  mkdirSync(join(folder, 'site/sub'), { recursive: true });
  writeFileSync(join(folder, 'secret.txt'), 'secret');
  writeFileSync(join(folder, 'site/index.html'), '<p>page');
  writeFileSync(join(folder, 'site/sub/a b.wasm'), 'wasm');
});

after(() => {
  for (const server of servers) server.close();
  rmSync(folder, { recursive: true });
});

test('serves files with their types, index.html for a folder', async () => {
  const port = await start();
  assert.deepEqual(await get(port, '/'), {
    status: 200,
    type: 'text/html; charset=utf-8',
    text: '<p>page',
  });
  const module = await get(port, '/sub/a%20b.wasm?v=1');
  assert.equal(module.type, 'application/wasm');
  assert.equal(module.text, 'wasm');
});

test('answers what it does not have', async () => {
  const port = await start();
  assert.equal((await get(port, '/missing.js')).status, 404);
  assert.equal((await get(port, '/sub')).status, 404);
  assert.equal((await get(port, '/%ff')).status, 404);
  assert.equal((await get(port, '/', 'POST')).status, 405);
});

test('stays inside its folder', async () => {
  const port = await start();
  for (const path of ['/../secret.txt', '/%2e%2e/secret.txt', '/sub/../../secret.txt']) {
    const answer = await get(port, path);
    assert.equal(answer.status, 404, path);
    assert.doesNotMatch(answer.text, /secret/);
  }
  assert.equal(fileFor(join(folder, 'site'), '/../site-secret'), undefined);
});

test('takes the next free port, or says that the asked one is taken', async () => {
  const taken = await start();
  const next = await start(taken, true);
  assert.notEqual(next, taken);
  await assert.rejects(start(taken, false), /Port \d+ is in use/);
});

test('what is built later comes first, and files of before stay', async () => {
  const later = join(folder, 'later');
  mkdirSync(later);
  writeFileSync(join(later, 'index.html'), '<p>later');
  const folders = [join(folder, 'site')];
  const server = createStaticServer(folders);
  servers.push(server);
  const port = await listen(server, '127.0.0.1', 0, false);
  assert.equal((await get(port, '/')).text, '<p>page');
  folders.unshift(later);
  assert.equal((await get(port, '/')).text, '<p>later');
  assert.equal((await get(port, '/sub/a%20b.wasm')).text, 'wasm');
});

test('what a browser has is not sent again until it changes', async () => {
  const page = join(folder, 'site/changing.html');
  writeFileSync(page, '<p>first');
  const port = await start();
  const { headers } = await ask(port, '/changing.html');
  assert.match(headers.etag, /^"[\w-]+"$/);
  const known = (tags) => ask(port, '/changing.html', { headers: { 'If-None-Match': tags } });
  for (const tags of [headers.etag, `"other", W/${headers.etag}`, '*']) {
    const answer = await known(tags);
    assert.equal(answer.status, 304, tags);
    assert.equal(answer.bytes.length, 0);
    assert.equal(answer.headers.etag, headers.etag);
    assert.equal(answer.headers['cache-control'], 'no-cache');
  }
  assert.equal((await known('"other"')).status, 200);
  writeFileSync(page, '<p>second one');
  const answer = await known(headers.etag);
  assert.equal(answer.status, 200);
  assert.notEqual(answer.headers.etag, headers.etag);
});

test('a file that grows while it is sent arrives as it was, and the connection stays usable', async () => {
  const large = join(folder, 'site/large.bin');
  const size = 2 ** 23;
  writeFileSync(large, Buffer.alloc(size));
  const port = await start();
  const agent = new Agent({ keepAlive: true, maxSockets: 1 });
  const call = (seen) =>
    new Promise((resolve, reject) => {
      const sent = request({ port, path: '/large.bin', agent }, (response) => {
        seen();
        let received = 0;
        response.on('data', ({ length }) => {
          received += length;
        });
        response.on('end', () => resolve(received));
      });
      sent.on('error', reject).end();
    });
  assert.equal(await call(() => appendFileSync(large, 'more')), size);
  assert.equal(await call(() => undefined), size + 4);
  agent.destroy();
});

test('only files that have their hash in their name are kept without asking', async () => {
  mkdirSync(join(folder, 'site/assets'));
  writeFileSync(join(folder, 'site/assets/index-1a2b.js'), '1');
  writeFileSync(join(folder, 'site/sw.js'), '2');
  writeFileSync(join(folder, 'site/manifest.webmanifest'), '{}');
  const port = await start();
  const kept = async (path) => (await ask(port, path)).headers['cache-control'];
  assert.equal(await kept('/assets/index-1a2b.js'), 'public, max-age=31536000, immutable');
  for (const path of ['/', '/sw.js', '/manifest.webmanifest'])
    assert.equal(await kept(path), 'no-cache', path);
});

test('compressed copies are sent to whoever takes them', async () => {
  const text = 'let it = 1;\n'.repeat(100);
  writeFileSync(join(folder, 'site/app.js'), text);
  writeFileSync(join(folder, 'site/app.js.br'), brotliCompressSync(text));
  writeFileSync(join(folder, 'site/app.js.gz'), gzipSync(text));
  const port = await start();
  const tags = new Set();
  for (const [accepted, encoding, decoded] of [
    ['gzip, deflate, br', 'br', brotliDecompressSync],
    ['gzip;q=1.0, br;q=0', 'gzip', gunzipSync],
    ['identity', undefined, (bytes) => bytes],
  ]) {
    const headers = { 'Accept-Encoding': accepted };
    const answer = await ask(port, '/app.js', { headers });
    assert.equal(answer.headers['content-encoding'], encoding);
    assert.equal(answer.headers['content-type'], 'text/javascript; charset=utf-8');
    assert.equal(answer.headers.vary, 'Accept-Encoding');
    assert.equal(Number(answer.headers['content-length']), answer.bytes.length);
    assert.equal(decoded(answer.bytes).toString(), text);
    tags.add(answer.headers.etag);

    const head = await ask(port, '/app.js', { method: 'HEAD', headers });
    assert.equal(head.status, 200);
    assert.equal(head.bytes.length, 0);
    for (const name of ['content-encoding', 'content-length', 'content-type', 'etag', 'vary'])
      assert.equal(head.headers[name], answer.headers[name], name);
  }
  assert.equal(tags.size, 3, 'each has a tag of its own');
  assert.equal((await ask(port, '/sub/a%20b.wasm')).headers.vary, undefined);
});

test('encodings are taken as the header says', () => {
  assert.deepEqual([...acceptedEncodings('BR, gzip;q=0.5,x;q=0.000')], ['br', 'gzip']);
  assert.ok(!acceptedEncodings(undefined).has('br'));
});
