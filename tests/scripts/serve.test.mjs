// The little web server behind `npm start`.

import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { createStaticServer, fileFor, listen } from '../../scripts/serve.mjs';

let folder;
const servers = [];

function start(port = 0, fallback = false) {
  const server = createStaticServer(join(folder, 'site'));
  servers.push(server);
  return listen(server, '127.0.0.1', port, fallback);
}

/** Sends the path unchanged: fetch would normalize "..". */
function get(port, path, method = 'GET') {
  return new Promise((resolve, reject) => {
    const call = request({ port, path, method }, (response) => {
      const chunks = [];
      response.on('data', (chunk) => chunks.push(chunk));
      response.on('end', () => {
        const { statusCode: status, headers } = response;
        resolve({ status, type: headers['content-type'], text: Buffer.concat(chunks).toString() });
      });
    });
    call.on('error', reject).end();
  });
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
