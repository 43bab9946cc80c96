// The platforms that the library is cross-compiled for, and what runs their programs on this one.
// Both are told by the toolchain files of CMake.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { BUILD, ROOT } from './paths.mjs';
import { which } from './run.mjs';

export const PLATFORMS = ['aarch64', 'windows'];

function toolchain(platform) {
  const text = readFileSync(join(ROOT, `scripts/cmake/${platform}.cmake`), 'utf8');
  return (variable) => text.match(new RegExp(`^set\\(${variable} (.*)\\)$`, 'm'))[1].split(' ');
}

/** The command that a program of the platform is given to. */
export const emulatorOf = (platform) => toolchain(platform)('CMAKE_CROSSCOMPILING_EMULATOR');

/** The tools of the platform that are not on PATH. */
export function missingTools(platform) {
  const setting = toolchain(platform);
  const [compiler] = setting('CMAKE_CXX_COMPILER');
  const [emulator] = setting('CMAKE_CROSSCOMPILING_EMULATOR');
  return [compiler, emulator].filter((tool) => !which(tool));
}

/** Full path of a test program of the platform. */
export const testProgramOf = (platform, name) =>
  join(BUILD, platform, 'tests', platform === 'windows' ? `${name}.exe` : name);
