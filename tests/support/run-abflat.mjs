// Runs the native program as a user would, without a shell.

import { spawn, spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { NATIVE_PROGRAM } from '../../scripts/lib/paths.mjs';

/** Guards against hanging; not a performance requirement. */
const SECONDS = 400;

/** The program under test: build/native/abflat, or what ABFLAT_BIN names. */
export const PROGRAM = process.env.ABFLAT_BIN ?? NATIVE_PROGRAM;

/** Whether that program is instrumented: it is some fifteen times as slow and needs more memory. */
export const isInstrumented = process.env.ABFLAT_INSTRUMENTED === '1';

if (!existsSync(PROGRAM))
  throw new Error(`${PROGRAM} does not exist: run "npm run build:native" or set ABFLAT_BIN.`);

/**
 * Starts the program; `finished` resolves to `{ code, signal, stdout, stderr, bytes }`, where
 * `bytes` is the raw standard output. Options: `input` (standard input), `cwd`, `wrapper` (put
 * before the program), `seconds` (after which it is ended).
 */
export function startAbflat(args, { input, cwd, wrapper = [], seconds = SECONDS } = {}) {
  const [program, ...rest] = [...wrapper, PROGRAM, ...args];
  const child = spawn(program, rest, {
    cwd,
    stdio: [input === undefined ? 'ignore' : 'pipe', 'pipe', 'pipe'],
    timeout: seconds * 1000,
  });
  const finished = new Promise((resolve, reject) => {
    const out = [];
    const err = [];
    child.stdout.on('data', (chunk) => out.push(chunk));
    child.stderr.on('data', (chunk) => err.push(chunk));
    child.on('error', reject);
    child.on('close', (code, signal) => {
      const bytes = Buffer.concat(out);
      resolve({ code, signal, bytes, stdout: `${bytes}`, stderr: `${Buffer.concat(err)}` });
    });
    // A program that rejects its arguments does not wait for its input.
    child.stdin?.on('error', (error) => error.code === 'EPIPE' || reject(error));
    child.stdin?.end(input);
  });
  return { child, finished };
}

export const runAbflat = (args, options) => startAbflat(args, options).finished;

/** Whether runOnTerminal works: it needs the `script` of util-linux to make terminals. */
export function hasTerminals() {
  const { stdout } = spawnSync('script', ['--version'], { encoding: 'utf8' });
  return stdout?.includes('util-linux') ?? false;
}

/**
 * Runs the program on its own terminal; standard output and error are mixed, as they appear there.
 */
export function runOnTerminal(args, { cwd } = {}) {
  const quoted = [PROGRAM, ...args].map((word) => `'${word.replaceAll("'", "'\\''")}'`);
  const { status, stdout } = spawnSync('script', ['-qec', quoted.join(' '), '/dev/null'], {
    cwd,
    encoding: 'utf8',
    env: { ...process.env, TERM: 'xterm' },
    input: '',
    timeout: SECONDS * 1000,
  });
  return { code: status, seen: stdout };
}
