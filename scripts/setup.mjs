#!/usr/bin/env node
// Installs what is missing: system packages on Debian and Ubuntu, npm packages everywhere.
// Usage: setup.mjs [page] [build] [test] [lint] [coverage] [fuzz] [platforms] [python] [cluster]
// (default: build test lint)

import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { ROOT } from './lib/paths.mjs';
import { REQUIREMENTS } from './lib/requirements.mjs';
import { Failure, mustRun, runMain, which } from './lib/run.mjs';
import { filesBelow, fingerprint } from './lib/stamp.mjs';

const LEAST_NODE = 20;
const PURPOSES = [
  'page',
  'build',
  'test',
  'lint',
  'coverage',
  'fuzz',
  'platforms',
  'python',
  'cluster',
];
/** What to check for if nothing is named: the others are rarely needed. */
const USUAL = ['build', 'test', 'lint'];

export async function setup(purposes = USUAL) {
  const major = Number(process.versions.node.split('.')[0]);
  if (major < LEAST_NODE) {
    throw new Failure(`abflat needs Node ${LEAST_NODE} or newer; this is ${process.version}.`);
  }
  // Neither depends on the other, and both mostly wait for the network.
  const done = await Promise.allSettled([installSystemPackages(purposes), installNodeModules()]);
  const failed = done.find(({ status }) => status === 'rejected');
  if (failed) throw failed.reason;
}

function missing(purposes) {
  const wanted = new Set(purposes.includes('build') ? [...purposes, 'page'] : purposes);
  return REQUIREMENTS.filter(({ purpose, present }) => wanted.has(purpose) && !present());
}

async function installSystemPackages(purposes) {
  const absent = missing(purposes);
  if (absent.length === 0) return;
  console.log('Missing on this system:');
  for (const { name, why } of absent) console.log(`  ${name}: ${why}`);

  const wanted = absent.filter((need) => !need.isOptional || mayInstall());
  const fromApt = which('apt-get') ? wanted.filter(isInApt) : [];
  if (fromApt.length > 0) await aptInstall(fromApt.flatMap(({ apt }) => apt));

  const left = missing(purposes).filter(({ isOptional }) => !isOptional);
  if (left.length > 0) throw new Failure(advice(left));
}

function isInApt({ apt, isNotInUbuntu }) {
  return apt !== undefined && !(isNotInUbuntu && isUbuntu());
}

function isUbuntu() {
  const path = '/etc/os-release';
  return existsSync(path) && /^ID=ubuntu$/m.test(readFileSync(path, 'utf8'));
}

const isRoot = () => process.getuid?.() === 0;
const mayInstall = () => isRoot() || which('sudo') !== undefined;

async function aptInstall(packages) {
  if (!mayInstall()) {
    throw new Failure(`Run as root: apt-get install ${packages.join(' ')}`);
  }
  // sudo drops the environment, so it is set after sudo.
  const prefix = [
    ...(isRoot() ? [] : ['sudo']),
    'env',
    'DEBIAN_FRONTEND=noninteractive',
    'apt-get',
  ];
  const apt = (args) => mustRun(prefix[0], [...prefix.slice(1), ...args]);
  console.log(
    `Installing with apt-get${isRoot() ? '' : ' (asks for your password)'}: ${packages.join(' ')}`,
  );
  await apt(['update', '-q']);
  // Without a pseudo-terminal, dpkg writes no progress bar into logs.
  const quiet = ['-q', '-o', 'Dpkg::Use-Pty=0'];
  await apt(['install', ...quiet, '-y', '--no-install-recommends', ...packages]);
}

/** What to install by hand, with the package names of the available manager. */
function advice(requirements) {
  const managers = { dnf: 'sudo dnf install', pacman: 'sudo pacman -S', brew: 'brew install' };
  const manager = Object.keys(managers).find((name) => which(name));
  const packaged = requirements.filter((need) => need[manager] !== undefined);
  const others = requirements.filter((need) => need[manager] === undefined);
  const lines = ['Please install, then run the same command again:'];
  if (packaged.length > 0) {
    const names = new Set(packaged.flatMap((need) => need[manager]));
    lines.push(`  ${managers[manager]} ${[...names].join(' ')}`);
  }
  for (const need of others) lines.push(`  ${need.name} (${need.why})${source(need)}`);
  return lines.join('\n');
}

function source({ other, apt }) {
  if (other) return `: ${other}`;
  return apt ? `: package ${apt.join(' ')} on Debian` : '';
}

/** `npm ci`, unless node_modules was made from the same package files. */
async function installNodeModules() {
  const files = ['package.json', 'package-lock.json', 'wasm/package.json', 'web/package.json'];
  const hash = fingerprint(filesBelow(files));
  const mark = join(ROOT, 'node_modules/.abflat-setup');
  if (existsSync(mark) && readFileSync(mark, 'utf8') === hash) return;
  console.log('Installing npm packages (TypeScript, Vite, three.js, test tools).');
  const args = ['ci', '--no-audit', '--no-fund', '--loglevel=error'];
  await mustRun('npm', args, { capture: true });
  writeFileSync(mark, hash);
}

async function main() {
  const purposes = process.argv.slice(2);
  const unknown = purposes.find((purpose) => !PURPOSES.includes(purpose));
  if (unknown)
    throw new Failure(`Unknown purpose "${unknown}"; known are: ${PURPOSES.join(', ')}.`);
  await setup(purposes.length > 0 ? purposes : undefined);
  console.log('Everything needed is there.');
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) await runMain(main);
