#!/usr/bin/env node
// Writes what each product contains: build/sbom/native.cdx.json, python.cdx.json, wasm.cdx.json,
// web.cdx.json.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { PRODUCTS } from './lib/licenses.mjs';
import { BUILD, ROOT } from './lib/paths.mjs';
import { runMain } from './lib/run.mjs';
import { billOfMaterials } from './lib/sbom.mjs';

await runMain(async () => {
  const folder = join(BUILD, 'sbom');
  mkdirSync(folder, { recursive: true });
  for (const product of PRODUCTS) {
    const file = join(folder, `${product}.cdx.json`);
    writeFileSync(file, `${JSON.stringify(billOfMaterials(product), null, 2)}\n`);
    console.log(`wrote ${relative(ROOT, file)}`);
  }
});
