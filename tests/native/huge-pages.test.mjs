// Where Linux gives huge pages to those who ask, the program begins again, once, so that the C library asks.

import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { open, readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { isInstrumented, PROGRAM } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const CUBE = `v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1
f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n`;

const ASKED = 'glibc.malloc.hugetlb=1';

function areGivenToThoseWhoAsk() {
  try {
    const modes = readFileSync('/sys/kernel/mm/transparent_hugepage/enabled', 'utf8');
    return modes.includes('[madvise]');
  } catch {
    return false; // another system
  }
}
const isAsked = areGivenToThoseWhoAsk() && !isInstrumented;

/** A run, looked at while it waits for its input. `tunables`: undefined if the user set none. `loader`:
 * what starts the program, if it is not started itself. */
async function lookAtRun(t, { tunables, loader = [] } = {}) {
  const at = tempFolder(t);
  execFileSync('mkfifo', [at('cube.obj')]);
  const { GLIBC_TUNABLES, LD_PRELOAD, ...env } = process.env;
  if (tunables !== undefined) env.GLIBC_TUNABLES = tunables;
  const words = [...loader, PROGRAM, 'unwrap', at('cube.obj'), '-o', at('out.obj')];
  const run = spawn(words[0], words.slice(1), { env, stdio: 'ignore' });
  const ended = new Promise((done, failed) => run.on('exit', done).on('error', failed));
  const input = await open(at('cube.obj'), 'w'); // waits until the program reads it
  const variables = readFileSync(`/proc/${run.pid}/environ`, 'utf8').split('\0');
  const name = readFileSync(`/proc/${run.pid}/comm`, 'utf8').trim();
  await input.writeFile(CUBE);
  await input.close();
  const code = await ended;
  const layout = await readFile(at('out.obj'), 'utf8');
  const found = variables.find((v) => v.startsWith('GLIBC_TUNABLES='));
  return { name, tunables: found?.replace(/^.*?=/, ''), code, layout };
}

test('asks for huge pages, keeps its name, and computes the same', {
  skip: isAsked ? false : 'huge pages are not given to those who ask',
}, async (t) => {
  const asked = await lookAtRun(t);
  assert.equal(asked.code, 0);
  assert.equal(asked.tunables, ASKED);
  assert.equal(asked.name, 'abflat');
  const left = await lookAtRun(t, { tunables: '' });
  assert.equal(left.code, 0);
  assert.equal(left.tunables, '', 'what the user set stays');
  assert.equal(left.layout, asked.layout);
});

const LOADER = '/lib64/ld-linux-x86-64.so.2';
const isLoaded = isAsked && existsSync(LOADER);

test('runs as it is where the loader is started by name', {
  skip: isLoaded ? false : 'no such loader here',
}, async (t) => {
  const run = await lookAtRun(t, { loader: [LOADER] });
  assert.equal(run.code, 0);
  assert.equal(run.tunables, undefined);
});
