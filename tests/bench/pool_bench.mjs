#!/usr/bin/env node
// Measures how much faster several workers of the npm package are, how long a call takes after one
// was cancelled, and whether memory stays the same over many calls.
// Usage: npm run bench:pool -- [--workers 2] [--jobs 12] [--detail 4] [--rounds 3] [--many 1000]

import { parseArgs } from 'node:util';
import { createAbflat } from 'abflat';
import { Failure, runMain } from '../../scripts/lib/run.mjs';

const OPTIONS = { workers: '2', jobs: '12', detail: '4', rounds: '3', many: '1000' };

function numbers() {
  const options = Object.fromEntries(
    Object.entries(OPTIONS).map(([name, usual]) => [name, { type: 'string', default: usual }]),
  );
  const { values } = parseArgs({ options });
  const wrong = Object.keys(OPTIONS).find((name) => !/^[1-9]\d*$/.test(values[name]));
  if (wrong) throw new Failure(`--${wrong} cannot be "${values[wrong]}": give a number from 1.`);
  return Object.fromEntries(Object.entries(values).map(([name, word]) => [name, Number(word)]));
}

const seconds = async (run) => (await cost(run)).seconds;

/** `cpu`: where others keep the cores busy, only it says what several workers cost. */
async function cost(run) {
  const before = process.cpuUsage();
  const begin = performance.now();
  await run();
  const { user, system } = process.cpuUsage(before);
  return { seconds: (performance.now() - begin) / 1000, cpu: (user + system) / 1e6 };
}
const shown = ({ seconds, cpu }) => `${seconds.toFixed(2)} s (${cpu.toFixed(2)} of CPU)`;
const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];
const rss = () => Math.round(process.memoryUsage().rss / 2 ** 20);

const unwrapAll = (abflat, mesh, count) =>
  Promise.all(Array.from({ length: count }, () => abflat.unwrap(mesh)));

/** One worker and several in turn, so that a busy machine slows both alike. */
async function compareWorkers(mesh, { workers, jobs, rounds }) {
  const [one, several] = await Promise.all(
    [1, workers].map((count) => createAbflat({ workers: count, queue: count, build: 'simd' })),
  );
  await Promise.all([one, several].map((abflat) => unwrapAll(abflat, mesh, 2 * workers)));
  const ratios = [];
  for (let round = 0; round < rounds; ++round) {
    const alone = await cost(() => unwrapAll(one, mesh, jobs));
    const together = await cost(() => unwrapAll(several, mesh, jobs));
    ratios.push(alone.seconds / together.seconds);
    console.log(
      `${jobs} jobs: ${shown(alone)} with one worker, ${shown(together)} with ${workers}`,
    );
  }
  console.log(`${workers} workers are ${median(ratios).toFixed(2)} times as fast as one`);
  one.terminate();
  several.terminate();
}

async function afterCancelling(mesh) {
  const abflat = await createAbflat({ build: 'simd' });
  await abflat.unwrap(mesh);
  const usual = await seconds(() => abflat.unwrap(mesh));
  const controller = new AbortController();
  await new Promise((resolve, reject) => {
    const options = { signal: controller.signal, onProgress: () => controller.abort() };
    abflat.unwrap(mesh, options).then(() => reject(new Failure('It ended first.')), resolve);
  });
  const after = await seconds(() => abflat.unwrap(mesh));
  console.log(`a call: ${usual.toFixed(2)} s; after one that was cancelled: ${after.toFixed(2)} s`);
  abflat.terminate();
}

async function manyCalls({ workers, many }) {
  const abflat = await createAbflat({ workers, queue: workers });
  const mesh = await abflat.sample('hemisphere');
  const used = [];
  for (let done = 0; done < many; done += Math.ceil(many / 5)) {
    await unwrapAll(abflat, mesh, Math.min(Math.ceil(many / 5), many - done));
    used.push(rss());
  }
  console.log(`memory over ${many} calls: ${used.join(', ')} MB`);
  abflat.terminate();
}

await runMain(async () => {
  const options = numbers();
  const source = await createAbflat();
  const mesh = await source.sample('head', { detail: options.detail });
  source.terminate();
  console.log(`${mesh.indices.length / 3} faces`);
  await compareWorkers(mesh, options);
  await afterCancelling(mesh);
  await manyCalls(options);
});
