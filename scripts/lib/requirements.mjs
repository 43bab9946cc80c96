// What abflat needs from the system: how to detect it, what it is for, and where to get it.

import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { missingTools } from './platforms.mjs';
import { isProgram, which } from './run.mjs';

/** Without a window tests take a sixth less time. */
const CHROME_NAMES = [
  'chromium-headless-shell',
  'chromium',
  'google-chrome',
  'google-chrome-stable',
  'chrome',
  'chromium-browser',
];
const CHROME_PLACES = [
  '/snap/bin/chromium',
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  '/Applications/Chromium.app/Contents/MacOS/Chromium',
];
const EMSDK = 'https://emscripten.org/docs/getting_started/downloads.html';

function includeFolders() {
  const named = [process.env.CPATH, process.env.CPLUS_INCLUDE_PATH].flatMap(
    (list) => list?.split(delimiter) ?? [],
  );
  return [...named.filter(Boolean), '/usr/include', '/usr/local/include', '/opt/homebrew/include'];
}

function header(...candidates) {
  return includeFolders().some((folder) =>
    candidates.some((name) => existsSync(join(folder, name))),
  );
}

/** Ubuntu's /usr/bin/chromium-browser is a script that only says "install the snap". */
function isSnapStub(path) {
  return statSync(path).size < 16384 && readFileSync(path, 'utf8').includes('snap install');
}

/** A Chromium or Chrome to test with: CHROME_PATH, then PATH, then the usual places. */
export function findChrome() {
  if (process.env.CHROME_PATH) return process.env.CHROME_PATH;
  const onPath = CHROME_NAMES.map(which).filter(Boolean);
  return [...onPath, ...CHROME_PLACES.filter(isProgram)].find((path) => !isSnapStub(path));
}

/** clang++, if the libraries that it links into instrumented programs are installed too. */
export function findClang() {
  const clang = which('clang++');
  if (clang === undefined) return undefined;
  const { stdout } = spawnSync(clang, ['-print-runtime-dir'], { encoding: 'utf8' });
  const folder = stdout?.trim() ?? '';
  const files = existsSync(folder) ? readdirSync(folder) : [];
  return files.some((name) => name.startsWith('libclang_rt.profile')) ? clang : undefined;
}

/**
 * A Python with NumPy and what compiles modules for it: PYTHON, then the system's, then that of
 * PATH.
 */
export function findPython() {
  const candidates = [process.env.PYTHON, '/usr/bin/python3', which('python3')];
  return candidates.filter(Boolean).find((python) => {
    const { stdout } = spawnSync(python, ['-c', PYTHON_HEADERS], { encoding: 'utf8' });
    return stdout && existsSync(join(stdout.trim(), 'Python.h'));
  });
}

function hasPip() {
  const python = findPython();
  const modules = 'import setuptools, wheel, pip, venv, ensurepip';
  return python !== undefined && spawnSync(python, ['-c', modules]).status === 0;
}

const PYTHON_HEADERS = 'import numpy, sysconfig; print(sysconfig.get_path("include"))';

/** Debian's emcc does not come with the acorn module that its optimiser loads. */
export const DEBIAN_NODE_MODULES = '/usr/share/nodejs';

function emccWorks() {
  const emcc = which('emcc');
  return (
    emcc !== undefined &&
    (emcc !== '/usr/bin/emcc' || existsSync(join(DEBIAN_NODE_MODULES, 'acorn')))
  );
}

/** Daemons are not on the path of all users. */
const inSystem = (name) => which(name) ?? existsSync(join('/usr/sbin', name));

/**
 * `purpose`: what it is needed for; a full build also needs what the page needs. `apt`, `dnf`,
 * `pacman`, `brew`: its package names there; a manager without an entry does not have it, and
 * `other` says where to get it. Without what `isOptional`, tests are skipped.
 */
export const REQUIREMENTS = [
  {
    name: 'C++ compiler',
    purpose: 'build',
    why: 'compiles the core and the command line program',
    present: () => ['c++', 'g++', 'clang++'].some(which),
    apt: ['g++'],
    dnf: ['gcc-c++'],
    pacman: ['gcc'],
    other: 'xcode-select --install',
  },
  {
    name: 'CMake',
    purpose: 'page',
    why: 'drives the C++ builds',
    present: () => which('cmake'),
    apt: ['cmake'],
    dnf: ['cmake'],
    pacman: ['cmake'],
    brew: ['cmake'],
  },
  {
    name: 'Ninja or Make',
    purpose: 'page',
    why: 'runs the compiler for CMake',
    // Make finishes each target before it starts the next.
    present: () => which('ninja') ?? (which('apt-get') ? undefined : which('make')),
    apt: ['ninja-build'],
    dnf: ['ninja-build'],
    pacman: ['ninja'],
    brew: ['ninja'],
  },
  {
    name: 'Emscripten',
    purpose: 'page',
    why: 'compiles the core to WebAssembly',
    present: emccWorks,
    apt: ['emscripten', 'node-acorn'],
    pacman: ['emscripten'],
    brew: ['emscripten'],
    other: `emsdk, ${EMSDK} (emcc must be on PATH)`,
  },
  {
    name: 'Eigen',
    purpose: 'page',
    why: 'sparse linear algebra of the solver',
    present: () => header('eigen3/Eigen/Core', 'Eigen/Core'),
    apt: ['libeigen3-dev'],
    dnf: ['eigen3-devel'],
    pacman: ['eigen'],
    brew: ['eigen'],
  },
  {
    name: 'fast_float',
    purpose: 'page',
    why: 'reads the numbers in mesh files',
    present: () => header('fast_float/fast_float.h'),
    apt: ['libfast-float-dev'],
    dnf: ['fast_float-devel'],
    pacman: ['fast_float'],
    brew: ['fast_float'],
  },
  {
    name: 'nlohmann-json',
    purpose: 'build',
    why: 'reads and writes glTF',
    present: () => header('nlohmann/json.hpp'),
    apt: ['nlohmann-json3-dev'],
    dnf: ['json-devel'],
    pacman: ['nlohmann-json'],
    brew: ['nlohmann-json'],
  },
  {
    name: 'CLI11',
    purpose: 'build',
    why: 'parses the command line',
    present: () => header('CLI/CLI.hpp'),
    apt: ['libcli11-dev'],
    dnf: ['cli11-devel'],
    pacman: ['cli11'],
    brew: ['cli11'],
  },
  {
    name: 'zlib',
    purpose: 'build',
    why: 'compresses pictures',
    present: () => header('zlib.h'),
    apt: ['zlib1g-dev'],
    dnf: ['zlib-devel'],
    pacman: ['zlib'],
    brew: ['zlib'],
  },
  {
    name: 'Draco',
    purpose: 'build',
    why: 'decodes compressed glTF',
    present: () => header('draco/compression/decode.h'),
    apt: ['libdraco-dev'],
    dnf: ['draco-devel'],
    pacman: ['draco'],
    brew: ['draco'],
  },
  {
    name: 'meshoptimizer',
    purpose: 'build',
    why: 'decodes compressed glTF',
    present: () => header('meshoptimizer.h'),
    apt: ['libmeshoptimizer-dev'],
    dnf: ['meshoptimizer-devel'],
    brew: ['meshoptimizer'],
    other:
      'https://github.com/zeux/meshoptimizer (its header and library where the compiler looks)',
  },
  {
    name: 'libpng',
    purpose: 'build',
    why: 'reads and writes textures',
    present: () => header('png.h'),
    apt: ['libpng-dev'],
    dnf: ['libpng-devel'],
    pacman: ['libpng'],
    brew: ['libpng'],
  },
  {
    name: 'libjpeg-turbo',
    purpose: 'build',
    why: 'reads and writes textures',
    present: () => header('turbojpeg.h'),
    apt: ['libturbojpeg0-dev'],
    dnf: ['turbojpeg-devel'],
    pacman: ['libjpeg-turbo'],
    brew: ['jpeg-turbo'],
  },
  {
    name: 'libwebp',
    purpose: 'build',
    why: 'reads and writes textures',
    present: () => header('webp/decode.h'),
    apt: ['libwebp-dev'],
    dnf: ['libwebp-devel'],
    pacman: ['libwebp'],
    brew: ['webp'],
  },
  {
    name: 'Catch2',
    purpose: 'test',
    why: 'runs the tests of the core',
    present: () => header('catch2/catch.hpp', 'catch2/catch_all.hpp'),
    apt: ['catch2'],
    dnf: ['catch-devel'],
    pacman: ['catch2'],
    brew: ['catch2'],
  },
  {
    name: 'tinyobjloader',
    purpose: 'test',
    why: 'reads OBJ and MTL a second time in the tests of the core',
    present: () => header('tiny_obj_loader.h'),
    apt: ['libtinyobjloader-dev'],
    dnf: ['tinyobjloader-devel'],
    brew: ['tinyobjloader'],
    other: 'https://github.com/tinyobjloader/tinyobjloader (its header where the compiler looks)',
  },
  {
    name: 'Chromium',
    purpose: 'test',
    why: 'runs the tests of the page (or set CHROME_PATH to a Chrome you have)',
    present: findChrome,
    apt: ['chromium-headless-shell', 'fonts-liberation'],
    dnf: ['chromium'],
    pacman: ['chromium'],
    other: 'Chrome or Chromium; on Ubuntu: sudo snap install chromium',
    isNotInUbuntu: true,
  },
  {
    name: 'clang with its runtime, llvm-cov',
    purpose: 'coverage',
    why: 'count which lines the tests reach',
    present: () => findClang() && (which('llvm-cov') ?? which('llvm-cov-14')),
    apt: ['clang', 'libclang-rt-dev', 'llvm'],
    dnf: ['clang', 'compiler-rt', 'llvm'],
    pacman: ['clang', 'compiler-rt', 'llvm'],
    brew: ['llvm'],
  },
  {
    name: 'clang-format',
    purpose: 'lint',
    why: 'formats the C++ sources',
    present: () => which('clang-format'),
    apt: ['clang-format'],
    dnf: ['clang-tools-extra'],
    pacman: ['clang'],
    brew: ['clang-format'],
  },
  {
    name: 'clang-tidy',
    purpose: 'lint',
    why: 'looks for mistakes in the C++ sources',
    present: () => which('clang-tidy'),
    apt: ['clang-tidy'],
    dnf: ['clang-tools-extra'],
    pacman: ['clang'],
    brew: ['llvm'],
  },
  {
    name: 'clang with its fuzzer',
    purpose: 'fuzz',
    why: 'builds and runs the fuzzers',
    present: findClang,
    apt: ['clang', 'libclang-rt-dev'],
    dnf: ['clang', 'compiler-rt'],
    pacman: ['clang', 'compiler-rt'],
    brew: ['llvm'],
  },
  {
    name: 'Python with its headers and NumPy',
    purpose: 'python',
    why: 'builds and tests the Python package',
    present: findPython,
    apt: ['python3-dev', 'python3-numpy'],
    dnf: ['python3-devel', 'python3-numpy'],
    pacman: ['python', 'python-numpy'],
    brew: ['python', 'numpy'],
  },
  {
    name: 'pip, setuptools and wheel',
    purpose: 'python',
    why: 'build the Python package as its users do',
    present: hasPip,
    apt: ['python3-pip', 'python3-setuptools', 'python3-wheel', 'python3-venv'],
    dnf: ['python3-pip', 'python3-setuptools', 'python3-wheel'],
    pacman: ['python-pip', 'python-setuptools', 'python-wheel'],
    brew: ['python', 'python-setuptools'],
  },
  {
    name: 'pybind11',
    purpose: 'python',
    why: 'joins the Python package and the library',
    present: () => header('pybind11/pybind11.h'),
    apt: ['pybind11-dev'],
    dnf: ['pybind11-devel'],
    pacman: ['pybind11'],
    brew: ['pybind11'],
  },
  {
    name: 'GNU parallel',
    purpose: 'cluster',
    why: 'runs its recipe in the tests',
    present: () => which('parallel'),
    apt: ['parallel'],
    isOptional: true,
  },
  {
    name: 'Slurm, munge',
    purpose: 'cluster',
    why: 'run their recipe in the tests',
    present: () => ['sbatch', 'slurmctld', 'slurmd', 'munged'].every(inSystem),
    apt: ['slurmctld', 'slurmd', 'slurm-client', 'munge'],
    isOptional: true,
  },
  {
    name: 'Redis',
    purpose: 'cluster',
    why: 'holds the queue of BullMQ in the tests',
    present: () => which('redis-server'),
    apt: ['redis-server'],
    isOptional: true,
  },
  {
    name: 'C++ compiler for ARM, qemu',
    purpose: 'platforms',
    why: 'run the tests of the core as on ARM',
    present: () => missingTools('aarch64').length === 0,
    apt: ['g++-aarch64-linux-gnu', 'qemu-user'],
    isOptional: true,
  },
  {
    name: 'MinGW, wine',
    purpose: 'platforms',
    why: 'run the tests of the core as on Windows',
    present: () => missingTools('windows').length === 0,
    apt: ['g++-mingw-w64-x86-64-posix', 'wine', 'wine64'],
    isOptional: true,
  },
];
