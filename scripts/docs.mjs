#!/usr/bin/env node
// Builds the site of the documents into build/docs.
// Usage: docs.mjs [--base PATH] [--out FOLDER] [--serve [--host ADDRESS] [--port N]]

import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { BUILD } from './lib/paths.mjs';
import { Failure, runMain } from './lib/run.mjs';
import { serve } from './serve.mjs';
import { setup } from './setup.mjs';

function optionsOf(args) {
  const { values } = parseArgs({
    args,
    options: {
      base: { type: 'string' },
      out: { type: 'string', default: join(BUILD, 'docs') },
      serve: { type: 'boolean', default: false },
      host: { type: 'string' },
      port: { type: 'string' },
    },
  });
  if (values.serve && values.base)
    throw new Failure('--serve serves the site at /: leave out --base.');
  return { ...values, out: resolve(values.out) };
}

await runMain(async () => {
  const { base, out, host, port, ...asked } = optionsOf(process.argv.slice(2));
  await setup([]);
  // Its packages are there from here on.
  const { buildSite } = await import('./docs/site.mjs');
  for (const sentence of await buildSite({ out, base })) console.log(sentence);
  console.log(`The site is in ${out}.`);
  if (!asked.serve) return;
  const where = Object.entries({ host, port }).filter(([, value]) => value !== undefined);
  await serve(
    where.flatMap(([name, value]) => [`--${name}`, value]),
    out,
    { what: 'The site', headers: {} },
  );
});
