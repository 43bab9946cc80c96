// Child processes: found on PATH, run without a shell, with failures reported as one sentence.

import { spawn } from 'node:child_process';
import { accessSync, constants, statSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { ROOT } from './paths.mjs';

/** A failure whose message says all that the user needs to know: no stack trace. */
export class Failure extends Error {}

/** Full path of a program on PATH, undefined if there is none. */
export function which(program) {
  for (const folder of (process.env.PATH ?? '').split(delimiter)) {
    const path = join(folder, program);
    if (folder !== '' && isProgram(path)) return path;
  }
  return undefined;
}

export function isProgram(path) {
  try {
    accessSync(path, constants.X_OK);
    return statSync(path).isFile();
  } catch (error) {
    if (['ENOENT', 'EACCES', 'ENOTDIR'].includes(error.code)) return false;
    throw error;
  }
}

/**
 * Runs a program and returns `{ code, output }`. Options: `cwd`, `env` (added to the environment),
 * `capture` (collect stdout + stderr in `output` instead of showing them; 'stdout': only stdout,
 * stderr is dropped), `echo` (collect and show), `seconds` (time limit, after which it is stopped).
 */
export function run(program, args, options = {}) {
  const { cwd = ROOT, env = {}, capture = false, echo = false, seconds = 0 } = options;
  const piped = capture || echo;
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, {
      cwd,
      // PWD may name the folder through a symbolic link, which CMake would take for another folder.
      env: { ...process.env, PWD: cwd, ...env },
      stdio: piped ? ['ignore', 'pipe', 'pipe'] : 'inherit',
    });
    const chunks = [];
    const timer =
      seconds > 0 ? setTimeout(() => endLate(child, program, seconds), seconds * 1000) : undefined;
    if (piped) {
      collect(child.stdout, chunks, echo && process.stdout);
      collect(child.stderr, capture === 'stdout' ? [] : chunks, echo && process.stderr);
    }
    child.on('error', (error) => {
      clearTimeout(timer);
      reject(new Failure(`Cannot run ${program}: ${error.message}`));
    });
    child.on('close', (code, signal) => {
      clearTimeout(timer);
      resolve({ code: code ?? 1, signal, output: Buffer.concat(chunks).toString() });
    });
  });
}

function collect(stream, chunks, echo) {
  stream.on('data', (chunk) => {
    chunks.push(chunk);
    if (echo) echo.write(chunk);
  });
}

/** SIGTERM first: node's test runner then ends its own children. */
function endLate(child, program, seconds) {
  console.error(`${program} did not finish within ${seconds} seconds and is stopped.`);
  child.kill('SIGTERM');
  setTimeout(() => child.kill('SIGKILL'), 5000).unref();
}

/** Like run, but throws a Failure naming the command unless it exits with 0. */
export async function mustRun(program, args, options = {}) {
  const { code, output } = await run(program, args, options);
  if (code === 0) return output;
  if (options.capture) process.stderr.write(output);
  throw new Failure(`Failed (exit code ${code}): ${program} ${args.join(' ')}`);
}

/** Calls main; a Failure ends with its message and exit code 1, other errors keep their trace. */
export async function runMain(main) {
  try {
    await main();
  } catch (error) {
    console.error(error instanceof Failure ? `\n${error.message}` : error);
    process.exitCode = 1;
  }
}
