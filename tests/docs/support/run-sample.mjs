// Runs a sample as its reader would, in a folder with the meshes that it names.

import { spawnSync } from 'node:child_process';
import { readdirSync, writeFileSync } from 'node:fs';
import { delimiter, dirname, join } from 'node:path';
import { PYTHON_DIST, ROOT } from '../../../scripts/lib/paths.mjs';
import { findPython } from '../../../scripts/lib/requirements.mjs';
import { which } from '../../../scripts/lib/run.mjs';
import { PROGRAM } from '../../support/run-abflat.mjs';

const INCLUDE = join(ROOT, 'core/include');
const LIBRARY = join(dirname(PROGRAM), 'core/libabflat.a');

const compiler = process.env.CXX ?? ['c++', 'g++', 'clang++'].map(which).find(Boolean);

/** A code other than 0 is an error, with all that was printed. */
function mustRun(program, args, cwd, env = {}) {
  const options = { cwd, encoding: 'utf8', env: { ...process.env, ...env } };
  const { status, stdout, stderr, error } = spawnSync(program, args, options);
  if (error) throw error;
  if (status !== 0) throw new Error(`exit code ${status}\n${stdout}${stderr}`);
}

/** Line by line, so that each has to succeed. */
function runShell(code, folder) {
  const path = [join(folder, 'build/native'), process.env.PATH].join(delimiter);
  mustRun('sh', ['-e', '-c', code], folder, { PATH: path });
}

function runJavaScript(code, folder, extension) {
  const file = join(folder, `sample.${extension}`);
  writeFileSync(file, code);
  mustRun(process.execPath, [file], folder);
}

/** The commands of a workflow. What it would install is there. */
function runWorkflow(code, folder) {
  const commands = [...code.matchAll(/^ *- run: (.*)$/gm)].map(([, command]) => command);
  const own = commands.filter((command) => command !== 'npm ci');
  if (own.length === 0) throw new Error('the workflow has no commands');
  runShell(own.join('\n'), folder);
}

function runPython(code, folder) {
  const file = join(folder, 'sample.py');
  writeFileSync(file, code);
  const python = process.env.PYTHON ?? findPython();
  const env = { PYTHONPATH: PYTHON_DIST, PYTHONDONTWRITEBYTECODE: '1' };
  mustRun(python, ['-W', 'error', file], folder, env);
}

/** A program runs. A part of one is compiled, with all headers that it may need. */
function runCpp(code, folder) {
  const isProgram = /^int main\(/m.test(code);
  const headers = readdirSync(join(INCLUDE, 'abflat')).filter((name) => name.endsWith('.h'));
  const names = ['cstdint', 'string', 'vector', ...headers.map((name) => `abflat/${name}`)];
  const before = isProgram ? '' : names.map((name) => `#include <${name}>\n`).join('');
  const file = join(folder, 'sample.cpp');
  writeFileSync(file, before + code);
  const program = join(folder, 'sample');
  const target = isProgram ? [LIBRARY, '-pthread', '-o', program] : ['-fsyntax-only'];
  mustRun(compiler, ['-std=c++17', '-Wall', '-Werror', '-I', INCLUDE, file, ...target], folder);
  if (isProgram) mustRun(program, [], folder);
}

const RUNNERS = {
  sh: runShell,
  js: (code, folder) => runJavaScript(code, folder, 'mjs'),
  ts: (code, folder) => runJavaScript(code, folder, 'mts'),
  yaml: runWorkflow,
  python: runPython,
  cpp: runCpp,
};

/** Throws with what was printed if the sample does not work. */
export const runSample = ({ language, code }, folder) => RUNNERS[language](code, folder);
