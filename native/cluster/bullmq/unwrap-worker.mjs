// A worker of BullMQ that unwraps meshes: jobs that a web back end adds to a queue are done by the
// pool of the npm package, several meshes at a time.
//
//   npm install abflat bullmq ioredis
//   REDIS_URL=redis://localhost:6379 WORKERS=4 node unwrap-worker.mjs
//
// The data of a job is { input, output, options }: the path of an OBJ, PLY, STL or OFF, that of the
// OBJ to write, and options of unwrap. Its progress counts to 100. A mesh that cannot be unwrapped
// fails at once; what else fails is tried again, as often as the job's `attempts` say. No more jobs
// are taken than the pool has workers: all others wait in Redis, where those of a worker that was
// killed return to. `PUBLISH abflat:cancel ID` ends a job that runs.

import { readFile, rename, rm, writeFile } from 'node:fs/promises';
import { availableParallelism } from 'node:os';
import { basename, dirname, join } from 'node:path';
import { AbflatError, createAbflat } from 'abflat';
import { UnrecoverableError, Worker } from 'bullmq';
import Redis from 'ioredis';

const QUEUE = 'abflat';
const workers = Number(process.env.WORKERS ?? availableParallelism());
const url = process.env.REDIS_URL ?? 'redis://localhost:6379';

const complain = ({ message }) => console.error(message);

/** What the next attempt would not change. */
const isFinal = (error) =>
  error.code === 'ENOENT' ||
  (error instanceof AbflatError && !['Internal', 'OutOfMemory'].includes(error.code));

/** Nothing has the name before it is whole. What a killed worker leaves, its job replaces. */
async function writeWhole(path, text, id) {
  const temporary = join(dirname(path), `.${basename(path)}.${id}`);
  try {
    await writeFile(temporary, text);
    await rename(temporary, path);
  } finally {
    await rm(temporary, { force: true });
  }
}

async function unwrap(abflat, job, signal) {
  const { input, output, options = {} } = job.data;
  const mesh = { bytes: await readFile(input), name: basename(input) };
  let told = 0;
  const onProgress = ({ fraction }) => {
    const percent = Math.floor(100 * fraction);
    if (percent < told + 5) return;
    told = percent;
    job.updateProgress(percent).catch(complain);
  };
  const { obj, report } = await abflat.unwrap(mesh, { ...options, obj: true, signal, onProgress });
  await writeWhole(output, obj, job.id);
  return { valid: report.valid, charts: report.charts.length };
}

const abflat = await createAbflat({ workers });
const connection = new Redis(url, { maxRetriesPerRequest: null });

const worker = new Worker(
  QUEUE,
  async (job, _token, signal) => {
    try {
      return await unwrap(abflat, job, signal);
    } catch (error) {
      if (signal?.aborted) throw new UnrecoverableError('cancelled');
      throw isFinal(error) ? new UnrecoverableError(error.message) : error;
    }
  },
  {
    connection,
    concurrency: workers,
    lockDuration: Number(process.env.LOCK_DURATION ?? 30_000),
    stalledInterval: Number(process.env.LOCK_DURATION ?? 30_000),
    // Jobs of workers that were killed are done again, however often that happens.
    maxStalledCount: Number.MAX_SAFE_INTEGER,
  },
);
worker.on('error', complain);

const orders = new Redis(url);
await orders.subscribe('abflat:cancel');
orders.on('message', (_channel, id) => worker.cancelJob(id));

let isEnding = false;
/** Lets running jobs end; the second signal does not wait for them. */
async function end() {
  if (isEnding) process.exit(1);
  isEnding = true;
  await worker.close();
  connection.disconnect();
  orders.disconnect();
  abflat.terminate();
}
process.on('SIGTERM', end);
process.on('SIGINT', end);
