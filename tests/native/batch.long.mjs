// Two thousand meshes, of 10 to 200,000 faces, some of them broken, in a run that is killed again
// and again.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { filesBelow, hasResults, manifestOf, untilLines } from '../support/batches.mjs';
import { writeManyMeshes } from '../support/many-meshes.mjs';
import { isInstrumented, runAbflat, startAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const SIZE = isInstrumented ? { count: 200, most: 2000 } : { count: 2000, most: 200000 };

test('a run that is killed three times ends with one valid result of every good mesh', async (t) => {
  const at = tempFolder(t);
  const options = { cwd: at(), seconds: 3600 };
  const made = writeManyMeshes(at('in'), SIZE);
  const batch = ['batch', 'in', '--out', 'out', '--resume', '--jobs', '2'];
  for (const share of [0.1, 0.4, 0.7]) {
    const { child, finished } = startAbflat(batch, options);
    await untilLines(at('out/manifest.jsonl'), share * SIZE.count);
    child.kill('SIGKILL');
    await finished;
  }
  assert.equal((await runAbflat(batch, options)).code, 1);

  const lines = manifestOf(at('out'));
  assert.deepEqual(
    lines.map(({ name }) => name),
    made.map(({ name }) => name).sort(),
  );
  const broken = new Set(made.filter((mesh) => mesh.broken).map(({ name }) => name));
  for (const { name, status, message, files } of lines) {
    assert.equal(status === 'done', !broken.has(name), `${name}: ${message}`);
    assert.equal(files.length, broken.has(name) ? 0 : 1);
    assert.equal(message === '', !broken.has(name));
  }
  const results = lines.flatMap(({ files }) => files.map(({ path }) => path));
  assert.equal(new Set(results).size, SIZE.count - broken.size);
  assert.deepEqual(hasResults(at('out')), results.sort());
  const pictures = lines.flatMap(({ layout }) => layout ?? []);
  assert.deepEqual(
    filesBelow(at('out')),
    [...results, ...pictures, 'manifest.jsonl', 'report.html'].sort(),
  );
  const verify = ['batch', 'out', '--run', 'verify', '--out', 'verified'];
  const verified = await runAbflat(verify, options);
  assert.equal(verified.code, 0, verified.stdout);
});
