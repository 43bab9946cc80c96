// The bill of materials names everything that ships, with the version that is built in.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { contentsOf, PRODUCTS } from '../../scripts/lib/licenses.mjs';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { which } from '../../scripts/lib/run.mjs';
import { billOfMaterials } from '../../scripts/lib/sbom.mjs';

const LICENSE =
  '(MIT|Zlib|MPL-2\\.0|BSD-3-Clause|libpng-2\\.0|IJG|Apache-2\\.0( WITH LLVM-exception)?)';
const SPDX = new RegExp(`^${LICENSE}( AND ${LICENSE})*$`);

for (const product of PRODUCTS)
  test(`${product}: every part has a version and a licence`, (t) => {
    if (product !== 'native' && !which('emcc')) return t.skip('there is no Emscripten');
    const bill = billOfMaterials(product);
    assert.deepEqual([bill.bomFormat, bill.specVersion, bill.version], ['CycloneDX', '1.5', 1]);
    assert.equal(bill.components.length, contentsOf(product).length);
    assert.equal(
      new Set(bill.components.map((each) => each['bom-ref'])).size,
      bill.components.length,
    );
    for (const { name, version, licenses, purl, externalReferences } of bill.components) {
      assert.match(version, /\d+\.\d+/, name);
      assert.match(licenses[0].expression, SPDX, name);
      assert.ok(purl.endsWith(`@${version}`), purl);
      assert.match(externalReferences[0].url, /^https?:\/\//, name);
    }
  });

test('npm packages have the version of the lock file', {
  skip: !which('emcc') && 'no Emscripten',
}, () => {
  const { packages } = JSON.parse(readFileSync(join(ROOT, 'package-lock.json'), 'utf8'));
  const ofNpm = billOfMaterials('web').components.filter(({ purl }) => purl.startsWith('pkg:npm/'));
  assert.ok(ofNpm.length > 0);
  for (const { name, version } of ofNpm)
    assert.equal(packages[`node_modules/${name}`].version, version);
});
