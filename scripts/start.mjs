#!/usr/bin/env node
// Sets up and builds what the page needs, and serves it. The first time, the page is available as
// soon as one WebAssembly module is built; the others follow in the meantime. Usage: npm start [--
// --host [ADDRESS] --port N]

import { buildFirstPage, buildWasm, buildWeb, hasAllWasm } from './build.mjs';
import { WEB_DIST } from './lib/paths.mjs';
import { Failure, runMain } from './lib/run.mjs';
import { serve } from './serve.mjs';
import { setup } from './setup.mjs';

async function buildAll() {
  await buildWasm();
  await buildWeb();
}

/**
 * Serves what exists so far, and everything once it is built. Files that an open page may still
 * request stay.
 */
async function serveMeanwhile(args) {
  const folders = [await buildFirstPage()];
  const address = await serve(args, folders);
  console.log('Building the rest, which is faster: it has threads.\n');
  try {
    await buildAll();
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    console.error(`\n${error.message}\nThe page stays as it is, without threads.`);
    return;
  }
  folders.unshift(WEB_DIST);
  console.log(`\nAll is built: load ${address} again for threads.`);
}

await runMain(async () => {
  const args = process.argv.slice(2);
  await setup(['page']);
  if (!hasAllWasm()) return serveMeanwhile(args);
  await buildAll();
  await serve(args);
});
