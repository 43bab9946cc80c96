// A folder for projects that use the library, and for what they are built from.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { JOBS } from '../../../scripts/lib/cmake.mjs';
import { ROOT } from '../../../scripts/lib/paths.mjs';
import { which } from '../../../scripts/lib/run.mjs';

export const EXAMPLE = join(ROOT, 'examples/cpp');
export const C_EXAMPLE = join(ROOT, 'examples/c');
const SOURCES = ['CMakeLists.txt', 'LICENSE', 'core', 'scripts/cmake'];

export function mustRun(command, args, options = {}) {
  const { status, stdout, stderr } = spawnSync(command, args, {
    encoding: 'utf8',
    maxBuffer: 1e8,
    ...options,
  });
  assert.equal(status, 0, `${command} ${args.join(' ')}\n${stdout}\n${stderr}`);
  return stdout;
}

export function consumers() {
  const folder = mkdtempSync(join(tmpdir(), 'abflat-consumers-'));
  const at = (...names) => join(folder, ...names);
  return {
    at,

    /** Without what lies beside the sources, as in an archive of them. */
    copySources(name) {
      for (const path of SOURCES) {
        mkdirSync(at(name, path, '..'), { recursive: true });
        cpSync(join(ROOT, path), at(name, path), { recursive: true });
      }
    },

    configure(name, ...more) {
      const generator = which('ninja') ? ['-G', 'Ninja'] : [];
      return mustRun('cmake', ['-S', at(name), '-B', at(name, 'build'), ...generator, ...more]);
    },

    build: (name) => mustRun('cmake', ['--build', at(name, 'build'), '--parallel', JOBS]),

    remove: () => rmSync(folder, { recursive: true, force: true }),
  };
}
