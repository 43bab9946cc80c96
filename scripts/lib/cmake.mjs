// Configures and builds the C++ targets.

import { existsSync, readFileSync, rmSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { delimiter, join } from 'node:path';
import { BUILD, ROOT } from './paths.mjs';
import { DEBIAN_NODE_MODULES } from './requirements.mjs';
import { mustRun, which } from './run.mjs';

export const JOBS = String(process.env.ABFLAT_JOBS ?? availableParallelism());

/**
 * Builds into build/NAME. `settings` are CMake variables that must hold (otherwise the folder is
 * configured again), `first` those that only a new folder gets. `wrapper` (emcmake) is put before
 * cmake when configuring. With `isPreset`, NAME is also a preset with that folder.
 */
export async function cmakeBuild(name, options = {}) {
  const { wrapper = [], settings = {}, first = {}, env = {}, targets = [], isPreset } = options;
  const folder = join(BUILD, name);
  const isNew = !isConfigured(folder);
  const wanted = { ABFLAT_WERROR: 'ON', ...settings };
  // CMake rejects a folder that was configured elsewhere or only partly.
  if (isNew) rmSync(folder, { recursive: true, force: true });
  if (isNew || !holds(folder, wanted)) {
    const generator = isNew ? ['-G', which('ninja') ? 'Ninja' : 'Unix Makefiles'] : [];
    const variables = Object.entries({ ...(isNew ? first : {}), ...wanted });
    const defines = variables.map(([key, value]) => `-D${key}=${value}`);
    const place = isPreset ? ['--preset', name] : ['-S', ROOT, '-B', folder];
    const command = [...wrapper, 'cmake', ...place, ...generator, ...defines];
    await mustRun(command[0], command.slice(1), { env });
  }
  const only = targets.flatMap((target) => ['--target', target]);
  await mustRun('cmake', ['--build', folder, '--parallel', JOBS, ...only], { env });
}

function isConfigured(folder) {
  return (
    ['build.ninja', 'Makefile'].some((file) => existsSync(join(folder, file))) &&
    existsSync(join(folder, 'CMakeCache.txt')) &&
    holds(folder, { CMAKE_HOME_DIRECTORY: ROOT })
  );
}

/** Whether variables have these values in the folder's cache. */
function holds(folder, settings) {
  const cache = readFileSync(join(folder, 'CMakeCache.txt'), 'utf8').split('\n');
  return Object.entries(settings).every(([key, value]) =>
    cache.some((line) => line.startsWith(`${key}:`) && line.endsWith(`=${value}`)),
  );
}

/** Environment for emcc: Debian's emcc needs acorn from Debian's folder for its optimiser. */
export function emscriptenEnv() {
  if (!existsSync(DEBIAN_NODE_MODULES)) return {};
  return {
    NODE_PATH: [process.env.NODE_PATH, DEBIAN_NODE_MODULES].filter(Boolean).join(delimiter),
  };
}
