#!/usr/bin/env node
// Runs the fuzzers for a while and prints what they did.
// Usage: npm run fuzz -- --minutes N [--targets obj,unwrap,javascript]

import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { buildSanitized, buildWasm } from '../../scripts/build.mjs';
import { JOBS } from '../../scripts/lib/cmake.mjs';
import { Failure, runMain } from '../../scripts/lib/run.mjs';
import { setup } from '../../scripts/setup.mjs';
import { FOUND, fuzz, fuzzPackage, PACKAGE_TARGET } from './fuzzers.mjs';
import { TARGET_NAMES } from './seeds.mjs';

const ALL_TARGETS = [...TARGET_NAMES, PACKAGE_TARGET];

async function fuzzAll(targets, minutes) {
  const share = Math.max(1, Math.round((60 * minutes * Number(JOBS)) / targets.length));
  const waiting = [...targets];
  const results = [];
  const work = async () => {
    for (let target = waiting.shift(); target; target = waiting.shift())
      results.push(await (target === PACKAGE_TARGET ? fuzzPackage(share) : fuzz(target, share)));
  };
  await Promise.all(Array.from({ length: Number(JOBS) }, work));
  return results.sort((a, b) => targets.indexOf(a.target) - targets.indexOf(b.target));
}

function print(results) {
  const rows = [
    ['target', 'seconds', 'executions', 'coverage', 'new coverage', 'corpus', 'findings'],
    ...results.map((r) =>
      [
        r.target,
        r.seconds,
        r.executions,
        r.after ?? '-',
        r.after === undefined ? '-' : r.after - r.before,
        r.corpus ?? '-',
        r.found.length,
      ].map(String),
    ),
  ];
  const widths = rows[0].map((_, i) => Math.max(...rows.map((row) => row[i].length)));
  for (const row of rows)
    console.log(
      row.map((cell, i) => (i ? cell.padStart(widths[i]) : cell.padEnd(widths[i]))).join('  '),
    );
  for (const { found } of results)
    for (const name of found) console.log(`found ${join(FOUND, name)}`);
}

await runMain(async () => {
  const { values } = parseArgs({
    options: { minutes: { type: 'string', default: '10' }, targets: { type: 'string' } },
  });
  const minutes = Number(values.minutes);
  if (!(minutes > 0))
    throw new Failure(`--minutes takes a number above 0, not "${values.minutes}".`);
  const targets = values.targets?.split(',') ?? ALL_TARGETS;
  const unknown = targets.find((target) => !ALL_TARGETS.includes(target));
  if (unknown !== undefined)
    throw new Failure(`Unknown target "${unknown}"; known are: ${ALL_TARGETS.join(', ')}.`);
  await setup(['build', 'fuzz']);
  if (targets.includes(PACKAGE_TARGET)) await buildWasm();
  if (targets.some((target) => target !== PACKAGE_TARGET)) await buildSanitized();
  const results = await fuzzAll(targets, minutes);
  print(results);
  const idle = results.filter(({ executions }) => executions === 0);
  for (const { target, output } of idle) console.log(`\n${target} ran nothing:\n${output}`);
  const findings = results.reduce((sum, { found }) => sum + found.length, 0);
  console.log(
    `\n${results.length - idle.length} passed, ${findings + idle.length} failed, 0 skipped`,
  );
  if (findings + idle.length > 0) process.exitCode = 1;
});
