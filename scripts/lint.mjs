#!/usr/bin/env node
// Checks formatting, likely mistakes, types and generated files. With --fix formats instead of
// complaining.

import { CHECKED_BUILDS, checkJobs, formatJobs } from './lib/checks.mjs';
import { JOBS } from './lib/cmake.mjs';
import { runPool } from './lib/pool.mjs';
import { runMain } from './lib/run.mjs';
import { setup } from './setup.mjs';

await runMain(async () => {
  const fix = process.argv.includes('--fix');
  await setup(['build', 'lint']);
  if (!fix) for (const build of CHECKED_BUILDS) await build();
  const jobs = fix ? formatJobs({ fix }) : checkJobs();
  // Each is a suite of its own, so that it is shown as soon as it finishes.
  const alone = jobs.map((job) => ({ title: job.name, jobs: [job] }));
  const show = ({ title, parts: [{ output }] }) => process.stdout.write(`== ${title}\n${output}`);
  const records = await runPool(alone, Number(fix ? 1 : JOBS), show);
  const failed = records.filter(({ parts }) => parts.some((part) => part.failed > 0));
  const names = failed.map(({ title }) => title).join(', ');
  console.log(failed.length > 0 ? `\nfailed: ${names}` : '\nall clean');
  if (failed.length > 0 && !fix)
    console.log('npm run format repairs formatting and generated files.');
  if (failed.length > 0) process.exitCode = 1;
});
