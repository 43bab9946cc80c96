// The worker for BullMQ with a real Redis: jobs of a worker that is killed are done by another,
// each result once and whole; broken meshes fail at once; running jobs can be cancelled.

import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { Queue, QueueEvents } from 'bullmq';
import Redis from 'ioredis';
import { runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { freePort, RECIPES, until, writeMeshes } from './support/batches.mjs';

const isThere = spawnSync('redis-server', ['--version']).status === 0;
const skip = isThere ? false : 'there is no redis-server';

async function startRedis(folder) {
  const port = await freePort();
  const args = ['--port', `${port}`, '--bind', '127.0.0.1', '--dir', folder, '--save', ''];
  const server = spawn('redis-server', args, { stdio: 'ignore' });
  const url = `redis://127.0.0.1:${port}`;
  const connection = new Redis(url, { maxRetriesPerRequest: null });
  connection.on('error', () => 'it is not there yet');
  const answers = () => connection.ping().then(Boolean, () => false);
  await until(answers, 'Redis', 30);
  return { server, url, connection };
}

/** Resolves to the exit code, or the signal. */
const closed = (child) =>
  until(
    () => child.signalCode ?? (child.exitCode === null ? '' : `${child.exitCode}`),
    'the worker to end',
  );

async function setUp(t) {
  const at = tempFolder(t);
  const { server, url, connection } = await startRedis(at());
  const queue = new Queue('abflat', { connection });
  const workers = [];
  const reader = connection.duplicate();
  const events = new QueueEvents('abflat', { connection: reader });
  await events.waitUntilReady();
  // Redis last: whoever misses it waits for its return.
  t.after(async () => {
    for (const worker of workers) worker.kill('SIGKILL');
    await events.close();
    await queue.close();
    for (const each of [reader, connection]) each.disconnect();
    server.kill();
  });
  /** As a user would. */
  const startWorker = () => {
    const worker = spawn(process.execPath, [join(RECIPES, 'bullmq/unwrap-worker.mjs')], {
      env: { ...process.env, REDIS_URL: url, WORKERS: '2', LOCK_DURATION: '2000' },
      stdio: ['ignore', 'inherit', 'inherit'],
    });
    workers.push(worker);
    return worker;
  };
  return { at, connection, queue, events, startWorker };
}

test('jobs of a killed worker are done by another', { skip }, async (t) => {
  const { at, connection, queue, startWorker } = await setUp(t);
  const names = writeMeshes(at('meshes'), 24);
  const doubled = [...names, ...names.slice(0, 3)]; // the same result from two jobs
  await queue.addBulk(
    doubled.map((name) => ({
      name: 'unwrap',
      data: {
        input: at(`meshes/${name}`),
        output: at(`uv-${name}`),
        options: { padding: 4 },
      },
      opts: { attempts: 3 },
    })),
  );
  const counts = () => queue.getJobCounts('completed', 'failed', 'active', 'waiting');
  const first = startWorker();
  await until(async () => (await counts()).completed >= 4, 'the first jobs');
  first.kill('SIGKILL');
  await closed(first);
  const then = await counts();
  assert.ok(then.waiting > 0, 'all was done before the worker was killed');
  const second = startWorker();
  await until(async () => {
    const { completed, failed } = await counts();
    return completed + failed === doubled.length;
  }, 'all jobs');
  const failed = await queue.getFailed();
  assert.deepEqual(
    failed.map(({ data, attemptsMade }) => [data.input.split('/').at(-1), attemptsMade]),
    doubled.filter((name) => name === 'broken.obj').map((name) => [name, 1]),
  );
  assert.match(failed[0].failedReason, /broken\.obj/);
  const results = readdirSync(at()).filter((name) => name.includes('uv-'));
  assert.deepEqual(
    results.sort(),
    names
      .filter((name) => name !== 'broken.obj')
      .map((name) => `uv-${name}`)
      .sort(),
  );
  for (const name of results) {
    const { code, stdout } = await runAbflat(['verify', at(name)]);
    assert.equal(code, 0, stdout);
  }
  assert.equal(
    (await queue.getCompleted()).every(({ returnvalue }) => returnvalue.valid),
    true,
  );
  second.kill('SIGTERM');
  assert.equal(await closed(second), '0');
  assert.equal(await connection.llen('bull:abflat:active'), 0);
});

test('a job is cancelled, and reports its progress before', { skip }, async (t) => {
  const { at, connection, queue, events, startWorker } = await setUp(t);
  const { code } = await runAbflat(['sample', 'head', '-o', at('big.obj'), '--detail', '60']);
  assert.equal(code, 0);
  const job = await queue.add('unwrap', { input: at('big.obj'), output: at('never.obj') });
  const progress = new Promise((resolve) => events.on('progress', ({ data }) => resolve(data)));
  startWorker();
  const percent = await progress;
  assert.ok(percent > 0 && percent <= 100, `${percent}`);
  await connection.publish('abflat:cancel', job.id);
  await until(() => job.isFailed(), 'the job to end');
  assert.match((await queue.getJob(job.id)).failedReason, /cancelled/);
  assert.deepEqual(
    readdirSync(at()).filter((name) => name.includes('never')),
    [],
  );
});
