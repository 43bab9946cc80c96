// Public meshes that npm packages hold, downloaded when a benchmark asks for the first of them.

import { existsSync, mkdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { Failure, run } from '../../../scripts/lib/run.mjs';
import { FOLDER } from './program.mjs';

const PLACE = join(FOLDER, 'public');

/** Exact versions, so that a mesh never changes. */
const PACKAGES = {
  bunny: { version: '1.0.1', module: 'bunny', licence: 'public domain' },
  snowden: { version: '1.0.1', module: 'snowden/hi', licence: 'MIT' },
};

export function originOf(name) {
  const { version, licence } = PACKAGES[name];
  return `npm package ${name} ${version}, ${licence}`;
}

/** The mesh of a package, as { positions, faces }. */
export async function publicMesh(name) {
  const { version, module } = PACKAGES[name];
  const place = join(PLACE, `${name}-${version}`);
  const require = createRequire(join(place, 'package.json'));
  if (!existsSync(join(place, 'node_modules', name))) {
    mkdirSync(place, { recursive: true });
    const quiet = ['--ignore-scripts', '--no-save', '--no-package-lock', '--no-audit', '--no-fund'];
    const args = ['install', '--prefix', place, ...quiet, `${name}@${version}`];
    const { code, output } = await run('npm', args, { capture: true });
    if (code !== 0) throw new Failure(`The mesh "${name}" cannot be downloaded:\n${output.trim()}`);
  }
  const { positions, cells } = require(module);
  return { positions, faces: cells };
}
