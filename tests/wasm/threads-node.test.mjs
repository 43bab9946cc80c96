// The build with threads in Node, which runs it only if it is asked for.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { bestBuild, createAbflat } from 'abflat';
import { grid } from './support/meshes.mjs';
import { DIST, ROOT } from './support/paths.mjs';

let threads;
let simd;
before(async () => {
  [threads, simd] = await Promise.all(['threads', 'simd'].map((build) => createAbflat({ build })));
});
after(() => {
  threads.terminate();
  simd.terminate();
});

test('it gives the bytes of the other builds, on as many threads as there are', async () => {
  assert.deepEqual([threads.build, bestBuild()], ['threads', 'simd']);
  const mesh = grid(80);
  const wanted = await simd.flatten(mesh, { t: 2, obj: true });
  for (const count of [0, 1, 2]) {
    const found = await threads.flatten(mesh, { t: 2, obj: true, threads: count });
    assert.deepEqual([found.uv, found.obj], [wanted.uv, wanted.obj]);
    const most = Math.min(availableParallelism(), count || 8);
    assert.ok(found.report.threads <= most, `${found.report.threads} of ${most}`);
    if (count === 2) assert.equal(found.report.threads, Math.min(2, availableParallelism()));
  }
  const { uv } = await threads.unwrap(mesh);
  assert.deepEqual(uv, (await simd.unwrap(mesh)).uv);
});

test('it is named by its file, too', async () => {
  const named = await createAbflat({ wasmUrl: join(DIST, 'abflat-threads.wasm') });
  assert.equal(named.build, 'threads');
  assert.equal(
    (await named.pack({ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], texcoords: [0, 0, 1, 0, 0, 1] }))
      .report.valid,
    true,
  );
  named.terminate();
});

test('a cancelled call and a lack of memory leave a working package', async () => {
  const large = grid(200);
  for (let i = 0; i < 3; ++i) {
    const controller = new AbortController();
    const options = { signal: controller.signal, onProgress: () => controller.abort() };
    await assert.rejects(threads.flatten(large, options), { name: 'AbortError' });
    assert.equal((await threads.flatten(grid(50))).report.valid, true);
  }
  const small = await createAbflat({ build: 'threads', maxMemory: 2 ** 25 });
  await assert.rejects(small.flatten(large), { code: 'OutOfMemory' });
  assert.equal((await small.flatten(grid(5))).report.valid, true);
  small.terminate();
});

test('its threads do not keep the process alive', () => {
  const text = `
    import { createAbflat } from 'abflat';
    const abflat = await createAbflat({ build: 'threads' });
    const { report } = await abflat.unwrap(await abflat.sample('head', { detail: 2 }));
    console.log(report.valid);
  `;
  const args = ['--input-type=module', '--eval', text];
  const options = { cwd: ROOT, encoding: 'utf8', timeout: 60_000 };
  const { status, stdout, stderr } = spawnSync(process.execPath, args, options);
  assert.deepEqual([status, stdout, stderr], [0, 'true\n', '']);
});
