// Many calls take no more memory than a few: in workers, in the calling thread, and in the module.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { test } from 'node:test';
import { createAbflatSync } from 'abflat/sync';
import { SQUARE } from './support/bake.mjs';
import { grid } from './support/meshes.mjs';
import { ROOT } from './support/paths.mjs';

const { positions, indices } = grid(4);
const MESH = JSON.stringify({ positions: [...positions], indices: [...indices] });

/** What memory is after some calls, and after as many more. */
const MEASURED = `
  import { createAbflat } from 'abflat';
  import { createAbflatSync } from 'abflat/sync';
  const CALLS = 40;
  const mesh = JSON.parse(process.env.MESH);
  const abflat = await ({ START });
  const run = () => Promise.all(Array.from({ length: CALLS }, () => abflat.unwrap(mesh)));
  const used = () => {
    for (let i = 0; i < 3; ++i) gc();
    const { rss, heapUsed, external } = process.memoryUsage();
    return { rss, scripts: heapUsed + external };
  };
  for (let i = 0; i < 2; ++i) await run();
  const before = used();
  for (let i = 0; i < 2; ++i) await run();
  console.log(JSON.stringify([before, used()]));
  abflat.terminate();
`;

const KINDS = {
  'one worker': 'createAbflat()',
  'several workers': 'createAbflat({ workers: 2, queue: 2 })',
  'the calling thread': 'createAbflatSync()',
};
for (const [kind, start] of Object.entries(KINDS))
  test(`calls in ${kind} leave nothing behind`, (t) => {
    const args = [
      '--expose-gc',
      '--input-type=module',
      '--eval',
      MEASURED.replace('{ START }', start),
    ];
    const env = { ...process.env, MESH };
    const { stdout, stderr } = spawnSync(process.execPath, args, {
      cwd: ROOT,
      encoding: 'utf8',
      env,
    });
    assert.equal(stderr, '');
    const [before, after] = JSON.parse(stdout);
    const growth = (name) => after[name] / before[name] - 1;
    t.diagnostic(`scripts ${growth('scripts').toFixed(4)}, process ${growth('rss').toFixed(4)}`);
    // A result of each call would be a tenth.
    assert.ok(growth('scripts') < 0.03, stdout);
    assert.ok(growth('rss') < 0.1, stdout);
  });

const SMALL = { resolution: 16, padding: 0 };

test('many calls need no more of the module than its least memory', async () => {
  const abflat = await createAbflatSync({ maxMemory: 2 ** 24, also: ['pack'] });
  const mesh = grid(10);
  // Also those that fail, on the way in and on the way out.
  const failing = [
    () => abflat.unwrap({ ...mesh, indices: [0, 1, 1000] }),
    () => abflat.unwrap(mesh, { ...SMALL, texelDensity: 1e6 }),
    () =>
      abflat.unwrap(mesh, {
        onProgress: () => {
          throw new RangeError('enough');
        },
      }),
  ];
  // What one call has at its end, kept by each, would not fit.
  for (let i = 0; i < 300; ++i) {
    abflat.flatten(mesh, { obj: true, ply: true });
    abflat.unwrap(mesh, { ...SMALL, obj: true, ply: true });
    abflat.pack(SQUARE, SMALL);
    if (i % 2 === 0) for (const call of failing) assert.throws(call);
  }
  abflat.terminate();
});
