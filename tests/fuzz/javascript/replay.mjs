#!/usr/bin/env node
// Repeats the calls of a finding, or of a seed, and says what is wrong.
// Usage: replay.mjs FILE or SEED ...

import { readFileSync } from 'node:fs';
import { Calls, describe } from './fuzz-calls.mjs';

const calls = await Calls.start();
for (const what of process.argv.slice(2)) {
  const finding = /^\d+$/.test(what)
    ? { seed: Number(what) }
    : JSON.parse(readFileSync(what, 'utf8'));
  console.log(describe(finding));
  const { failure } = await calls.run(finding);
  console.log(failure ? failure.stack : 'ok');
  if (failure) process.exitCode = 1;
}
calls.end();
