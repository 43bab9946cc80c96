// Projects of package users: the package as npm packs it, installed beside the bundlers, in a
// folder outside the workspace.

import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { packPackage } from '../wasm/support/pack.mjs';
import { ROOT } from '../wasm/support/paths.mjs';

/** Exact versions, so that a new release of one of them breaks nothing here. */
const VERSIONS = {
  '@rollup/plugin-node-resolve': '16.0.3',
  esbuild: '0.28.2',
  next: '16.4.6',
  parcel: '2.16.4',
  react: '19.3.1',
  'react-dom': '19.3.1',
  rollup: '4.68.7',
  three: '0.187.0',
  vite: '8.3.8',
  webpack: '5.112.2',
  'webpack-cli': '7.3.1',
  workerd: '1.20261117.1',
};
export const FOLDER = join(ROOT, 'build/bundlers');

export const ENV = { ...process.env, NEXT_TELEMETRY_DISABLED: '1' };

/** Runs a program to its end; throws with its output if it fails. */
export function run(command, args, cwd) {
  const { status, stdout, stderr } = spawnSync(command, args, { cwd, encoding: 'utf8', env: ENV });
  if (status !== 0) throw new Error(`${command} ${args.join(' ')}:\n${stdout}\n${stderr}`);
  return stdout;
}

/** Installs the bundlers if they are missing, and the package in its current state. */
export function install() {
  mkdirSync(FOLDER, { recursive: true });
  const manifest = join(FOLDER, 'package.json');
  const text = JSON.stringify({ private: true, dependencies: VERSIONS }, null, 2);
  if (!existsSync(manifest) || readFileSync(manifest, 'utf8') !== text) {
    rmSync(join(FOLDER, 'node_modules'), { recursive: true, force: true });
    writeFileSync(manifest, text);
    try {
      run('npm', ['install', '--no-audit', '--no-fund', '--no-package-lock'], FOLDER);
    } catch (error) {
      rmSync(manifest);
      throw error;
    }
  }
  const { tarball } = packPackage(FOLDER);
  const place = join(FOLDER, 'node_modules/abflat');
  rmSync(place, { recursive: true, force: true });
  mkdirSync(place);
  run('tar', ['-xzf', tarball, '-C', place, '--strip-components=1'], FOLDER);
}

/** A new project with these files. */
export function project(name, files) {
  const root = join(FOLDER, 'projects', name);
  rmSync(root, { recursive: true, force: true });
  for (const [path, text] of Object.entries(files)) {
    mkdirSync(dirname(join(root, path)), { recursive: true });
    writeFileSync(join(root, path), text);
  }
  return root;
}

export const bin = (name) => join(FOLDER, 'node_modules/.bin', name);
export const INSTALLED = join(FOLDER, 'node_modules/abflat');
