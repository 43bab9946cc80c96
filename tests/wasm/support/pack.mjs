// The package as npm packs it.

import { spawnSync } from 'node:child_process';
import { cpSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { ROOT } from './paths.mjs';

const PACKED = ['LICENSE', 'CHANGELOG.md', 'wasm'];

/**
 * Packs into `folder`: `{ tarball, files, left }`, the archive, the paths in it and what packing left
 * behind. It packs a copy, because packing puts files beside package.json for a moment, and tests
 * run side by side.
 */
export function packPackage(folder) {
  const copy = mkdtempSync(join(tmpdir(), 'abflat-pack-'));
  const at = (name) => join(copy, name);
  try {
    const filter = (path) => !path.endsWith('node_modules');
    for (const name of PACKED) cpSync(join(ROOT, name), at(name), { recursive: true, filter });
    const before = readdirSync(at('wasm'));
    const args = ['pack', '--json', '--pack-destination', folder];
    const { stdout, stderr } = spawnSync('npm', args, { cwd: at('wasm'), encoding: 'utf8' });
    if (!/^\s*\[/.test(stdout)) throw new Error(`npm pack: ${stderr}`);
    const [{ filename, files }] = JSON.parse(stdout);
    return {
      tarball: join(folder, filename),
      files: files.map(({ path }) => path),
      left: readdirSync(at('wasm')).filter((name) => !before.includes(name)),
    };
  } finally {
    rmSync(copy, { recursive: true });
  }
}
