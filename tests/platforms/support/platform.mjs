// Runs programs of another platform, and compares what they write with what the program writes here.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { test } from 'node:test';
import { BUILD } from '../../../scripts/lib/paths.mjs';
import { emulatorOf, missingTools, testProgramOf } from '../../../scripts/lib/platforms.mjs';
import { NOT_QUALITY } from '../../../scripts/lib/suites.mjs';
import { runAbflat } from '../../support/run-abflat.mjs';
import { sharedMesh } from '../../support/shared.mjs';
import { CUBE_OF_PARTS } from '../../support/small-meshes.mjs';
import { tempFolder } from '../../support/temp-folder.mjs';

/** Wine keeps its registry in the build folder and does not offer to install anything. */
export const WINE = {
  WINEPREFIX: join(BUILD, 'wine'),
  WINEDEBUG: '-all',
  WINEDLLOVERRIDES: 'mscoree=;mshtml=',
};
const SAMPLES = ['hemisphere', 'wavy-strip', 'head', 'alpha-band', 'three-balls'];
/** Closed, with handles, of several parts, with quads, not a manifold. */
const MESHES = ['suzanne-quads.obj', 'teapot-5parts.obj', 'fertility-genus4.off']
  .concat('spot-uv.obj', 'beetle-nonmanifold.obj')
  .map(sharedMesh);
const DISKS = ['cathead.obj', 'body.off'].map(sharedMesh);

function runOn(platform, program, args) {
  const [emulator, ...options] = emulatorOf(platform);
  return spawnSync(emulator, [...options, testProgramOf(platform, program), ...args], {
    encoding: 'utf8',
    env: { ...process.env, ...WINE },
    maxBuffer: 1e8,
  });
}

export function testPlatform(platform) {
  const missing = missingTools(platform);
  const skip = missing.length > 0 && `there is no ${missing.join(' and no ')}`;

  test('the core tests pass', { skip }, () => {
    const { status, stdout, stderr } = runOn(platform, 'abflat_core_tests', [NOT_QUALITY]);
    assert.equal(status, 0, stdout + stderr);
  });

  test('files are the same', { skip }, async (context) => {
    const path = tempFolder(context);
    const isSame = async (command, from, name) => {
      const here = path(`here-${name}`);
      const there = path(`there-${name}`);
      const { code, stderr } = await runAbflat([command, from, '-o', here]);
      assert.equal(code, 0, stderr);
      const other = runOn(platform, 'abflat_layouts', [command, from, there]);
      assert.equal(other.status, 0, other.stderr);
      assert.ok(readFileSync(here).equals(readFileSync(there)), `${command} ${from} differs`);
      return here;
    };
    writeFileSync(path('cube.obj'), CUBE_OF_PARTS);
    const made = [];
    for (const name of SAMPLES) made.push(await isSame('sample', name, `${name}.obj`));
    const meshes = [path('cube.obj'), ...made, ...MESHES].filter(existsSync);
    for (const mesh of meshes) await isSame('unwrap', mesh, `unwrapped-${basename(mesh)}.obj`);
    const disks = [...made, ...DISKS].filter(existsSync);
    for (const mesh of disks) await isSame('flatten', mesh, `flat-${basename(mesh)}.obj`);
  });
}
