#!/usr/bin/env node
// Builds the WebAssembly package, then serves the page with live reload. Usage: npm run dev [--
// vite options]

import { buildWasm } from './build.mjs';
import { mustRun, runMain } from './lib/run.mjs';
import { setup } from './setup.mjs';

await runMain(async () => {
  await setup(['build']);
  await buildWasm();
  await mustRun('npm', [
    'run',
    '--silent',
    'dev',
    '--workspace',
    'web',
    '--',
    ...process.argv.slice(2),
  ]);
});
