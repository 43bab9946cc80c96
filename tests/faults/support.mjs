// Runs the program with faults in its system calls.

import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { constants, tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { PROGRAM, runAbflat } from '../support/run-abflat.mjs';

const FOLDER = dirname(fileURLToPath(import.meta.url));

/**
 * Builds the library that makes calls fail; returns `{ library }`, or `{ problem }` if it cannot be
 * built.
 */
function buildShim() {
  if (process.platform !== 'linux') return { problem: 'LD_PRELOAD is needed, as on Linux' };
  const folder = mkdtempSync(join(tmpdir(), 'abflat-shim-'));
  process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
  const library = join(folder, 'shim.so');
  const args = ['-shared', '-fPIC', '-O1', '-Wall', '-Wextra', '-Werror', '-o', library];
  const built = spawnSync('cc', [...args, join(FOLDER, 'shim.c'), '-ldl'], { encoding: 'utf8' });
  if (built.error) return { problem: 'there is no C compiler (cc)' };
  if (built.status !== 0) throw new Error(built.stderr);
  const log = join(folder, 'log');
  const env = { LD_PRELOAD: library, ABFLAT_FAULT_LOG: log };
  const probe = spawnSync(PROGRAM, ['sample', 'head', '-o', join(folder, 'head.obj')], { env });
  if (probe.status !== 0) return { problem: 'the program does not take LD_PRELOAD (sanitizers?)' };
  if (!readFileSync(log, 'utf8').includes('rename'))
    return { problem: 'the program calls the kernel without the C library' };
  return { library };
}

const shim = buildShim();

/** Why faults cannot be injected here, for `skip`. */
export const withoutFaults = shim.problem;

const withShim = (at, variables) => {
  const env = { LD_PRELOAD: shim.library, ...variables };
  return ['env', '-C', at(), ...Object.entries(env).map(([name, value]) => `${name}=${value}`)];
};

/** The watched calls of a run, in order: 'open', 'write', 'rename', ... */
export async function callsOf(at, args) {
  const log = at('../calls.log');
  const run = await runAbflat(args, { wrapper: withShim(at, { ABFLAT_FAULT_LOG: log }) });
  if (run.code !== 0) throw new Error(run.stderr);
  return readFileSync(log, 'utf8').trimEnd().split('\n');
}

/** `fault` is the name of an errno ('EIO'), 'always EIO', 'short', or the name of a signal. */
export function runWithFault(at, args, call, fault) {
  const number = (name) =>
    name.startsWith('SIG') ? `signal ${constants.signals[name]}` : constants.errno[name];
  const words = fault.split(' ').map((word) => (/^(E|SIG)/.test(word) ? number(word) : word));
  const variables = { ABFLAT_FAULT_AT: call, ABFLAT_FAULT: words.join(' ') };
  return runAbflat(args, { wrapper: withShim(at, variables) });
}

/** Names and contents of all files in a folder. */
export const contentsOf = (folder) =>
  Object.fromEntries(
    readdirSync(folder).map((name) => [name, readFileSync(join(folder, name), 'latin1')]),
  );

/** Calls `work` for all items, a few at a time. */
export async function eachOf(items, work) {
  const AT_ONCE = 4;
  const queue = items.entries();
  const worker = async () => {
    for (const [i, item] of queue) await work(item, i);
  };
  await Promise.all(Array.from({ length: AT_ONCE }, worker));
}
