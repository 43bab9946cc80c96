// Configures and builds the C++ targets.

import { existsSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { delimiter, join } from 'node:path';
import { BUILD } from './paths.mjs';
import { DEBIAN_NODE_MODULES } from './requirements.mjs';
import { mustRun, which } from './run.mjs';

export const JOBS = String(process.env.ABFLAT_JOBS ?? availableParallelism());

/** Builds into build/NAME. `wrapper` (emcmake) is put before cmake when configuring. */
export async function cmakeBuild(
  name,
  { wrapper = [], settings = [], env = {}, targets = [] } = {},
) {
  const folder = join(BUILD, name);
  if (!['build.ninja', 'Makefile'].some((file) => existsSync(join(folder, file)))) {
    const generator = which('ninja') ? ['-G', 'Ninja'] : ['-G', 'Unix Makefiles'];
    const command = [...wrapper, 'cmake', '-S', '.', '-B', folder, ...generator, ...settings];
    await mustRun(command[0], command.slice(1), { env });
  }
  const only = targets.flatMap((target) => ['--target', target]);
  await mustRun('cmake', ['--build', folder, '--parallel', JOBS, ...only], { env });
}

/** Environment for emcc: its optimiser loads acorn from Debian's folder where emcc is Debian's. */
export function emscriptenEnv() {
  if (!existsSync(DEBIAN_NODE_MODULES)) return {};
  return {
    NODE_PATH: [process.env.NODE_PATH, DEBIAN_NODE_MODULES].filter(Boolean).join(delimiter),
  };
}
