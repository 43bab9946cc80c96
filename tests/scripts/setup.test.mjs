// The setup on machines where something is missing, simulated with a separate PATH.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  chmodSync,
  existsSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';

let folder;

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'abflat-setup-'));
  symlinkSync(process.execPath, join(folder, 'node'));
});
afterEach(() => rmSync(folder, { recursive: true }));

/** A program on the simulated PATH that only records how it was called. */
function fake(name, body = '') {
  const path = join(folder, name);
  writeFileSync(path, `#!/bin/sh\necho "${name} $*" >> "${folder}/calls"\n${body}`);
  chmodSync(path, 0o755);
}

const calls = () => {
  const path = join(folder, 'calls');
  return existsSync(path) ? readFileSync(path, 'utf8').trim().split('\n') : [];
};

function setup(...purposes) {
  return spawnSync(process.execPath, [join(ROOT, 'scripts/setup.mjs'), ...purposes], {
    encoding: 'utf8',
    env: { PATH: folder, HOME: folder },
  });
}

test('without a known package manager it says what to install and why', () => {
  const { status, stdout, stderr } = setup('build');
  assert.equal(status, 1);
  assert.match(stdout, /CMake: drives the C\+\+ builds/);
  assert.match(stderr, /CMake \(drives the C\+\+ builds\): package cmake on Debian/);
  assert.match(stderr, /Emscripten .*emsdk/);
  assert.doesNotMatch(stdout, /clang-tidy/, 'not needed for building');
});

test('the page needs neither a native compiler nor what tests and lint need', () => {
  const { stdout } = setup('page');
  assert.match(stdout, /CMake: .*[\s\S]*Emscripten: /);
  assert.doesNotMatch(stdout, /C\+\+ compiler|CLI11|Catch2|Chromium|clang-/);
});

test('Homebrew and dnf get their own package names', () => {
  fake('dnf');
  assert.match(setup('build').stderr, /^ {2}sudo dnf install gcc-c\+\+ cmake ninja-build/m);
  rmSync(join(folder, 'dnf'));
  fake('brew');
  assert.match(setup('build').stderr, /^ {2}brew install cmake ninja emscripten/m);
  assert.deepEqual(calls(), [], 'only advice, nothing is run');
});

test('with apt-get it installs what is missing, as root, and looks again', () => {
  // apt-get is called through env, whose job the shell does here.
  fake('apt-get');
  fake('env', 'shift; exec "$@"');
  fake('sudo', 'exec "$@"');
  const { status, stderr } = setup('lint');
  const apt = calls().filter((call) => call.startsWith('apt-get'));
  assert.equal(apt.length, 2);
  assert.match(apt[0], /^apt-get update/);
  assert.match(apt[1], /install .*--no-install-recommends clang-format clang-tidy$/);
  assert.ok(calls().some((call) => call.startsWith('env DEBIAN_FRONTEND=noninteractive apt-get')));
  assert.equal(
    calls().some((call) => call.startsWith('sudo')),
    process.getuid() !== 0,
  );
  assert.equal(status, 1, 'nothing was really installed');
  assert.match(stderr, /Please install.*\n.*clang-format/);
});

test('without what only some tests need, it goes on', () => {
  fake('dnf');
  const { status, stdout, stderr } = setup('platforms');
  assert.equal(status, 0, stderr);
  assert.match(stdout, /C\+\+ compiler for ARM, qemu: .*\n.*MinGW, wine: /);
});

test('a failing apt-get is named', () => {
  fake('apt-get', 'exit 100');
  fake('env', 'shift; exec "$@"');
  fake('sudo', 'exec "$@"');
  const { status, stderr } = setup('lint');
  assert.equal(status, 1);
  assert.match(stderr, /Failed \(exit code 100\): .*apt-get update/);
});

test('an unknown purpose is refused', () => {
  const { status, stderr } = setup('party');
  assert.equal(status, 1);
  assert.match(
    stderr,
    /Unknown purpose "party"; known are: page, build, test, lint, coverage, fuzz, platforms, python, cluster\./,
  );
});
