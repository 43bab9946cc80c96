// The package in Cloudflare's runtime, as the README has it for edge functions.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { cpSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { examples } from '../wasm/support/examples.mjs';
import { bin, INSTALLED, install, project, run } from './project.mjs';

const ends = [];
after(() => {
  for (const end of ends) end();
});

const config = (port) => `using Workerd = import "/workerd/workerd.capnp";
const config :Workerd.Config = (
  services = [(name = "main", worker = .main)],
  sockets = [(name = "http", address = "127.0.0.1:${port}", http = (), service = "main")],
);
const main :Workerd.Worker = (
  modules = [
    (name = "main.js", esModule = embed "out/main.js"),
    (name = "abflat/abflat-simd.wasm", wasm = embed "abflat-simd.wasm"),
  ],
  compatibilityDate = "2025-06-01",
);
`;

function freePort() {
  return new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

/** What it answers, once it does. */
async function answer(address, child, body) {
  let output = '';
  child.stderr.on('data', (chunk) => {
    output += chunk;
  });
  while (child.exitCode === null) {
    const response = await fetch(address, { method: 'POST', body }).catch(() => undefined);
    if (response) return response;
    await new Promise((done) => setTimeout(done, 100));
  }
  throw new Error(output);
}

test('workerd', async () => {
  install();
  const root = project('workerd', { 'main.js': examples().edge });
  run(
    bin('esbuild'),
    [
      '--bundle',
      '--format=esm',
      '--conditions=workerd',
      '--external:*.wasm',
      'main.js',
      '--outfile=out/main.js',
    ],
    root,
  );
  cpSync(join(INSTALLED, 'dist/abflat-simd.wasm'), join(root, 'abflat-simd.wasm'));
  const port = await freePort();
  writeFileSync(join(root, 'config.capnp'), config(port));
  const child = spawn(bin('workerd'), ['serve', 'config.capnp'], { cwd: root });
  ends.push(() => child.kill());
  const body = JSON.stringify({ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], indices: [0, 1, 2] });
  const response = await answer(`http://127.0.0.1:${port}/`, child, body);
  const { uv, vertexMap, valid } = await response.json();
  assert.deepEqual([uv.length, vertexMap.length, valid], [6, 3, true]);
});
