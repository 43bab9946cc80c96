#!/usr/bin/env node
// Sets up, builds everything and serves the page. Usage: npm start [-- --host [ADDRESS] --port N]

import { buildNative, buildWasm, buildWeb } from './build.mjs';
import { runMain } from './lib/run.mjs';
import { serve } from './serve.mjs';
import { setup } from './setup.mjs';

await runMain(async () => {
  await setup(['build']);
  await buildNative();
  await buildWasm();
  await buildWeb();
  await serve(process.argv.slice(2));
});
