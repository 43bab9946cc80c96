// The meshes of benchmarks, by name, as OBJ files in build/bench: generated here, from npm packages,
// or from a folder beside the repository.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from '../../../scripts/lib/paths.mjs';
import { Failure } from '../../../scripts/lib/run.mjs';
import { parseObj } from '../../support/atlas.mjs';
import { dirtyMesh } from '../../support/dirty-meshes.mjs';
import { generatedDisk } from '../../support/disks.mjs';
import { isosurface, knot, objText } from '../../support/surfaces.mjs';
import { FOLDER } from './program.mjs';
import { originOf, publicMesh } from './public_meshes.mjs';
import { refined } from './subdivided.mjs';

const SHARED = join(ROOT, '../shared/meshes');

function readOff(name) {
  const words = readFileSync(join(SHARED, name), 'utf8').replace(/#.*/g, '').trim().split(/\s+/);
  const [vertices, faces] = words.slice(1, 3).map(Number);
  const numbers = words.slice(4).map(Number);
  const rest = numbers.slice(3 * vertices);
  return {
    positions: Array.from({ length: vertices }, (_, v) => numbers.slice(3 * v, 3 * v + 3)),
    faces: Array.from({ length: faces }, (_, f) => rest.slice(4 * f + 1, 4 * f + 4)),
  };
}

function readObj(name) {
  const { positions, faces } = parseObj(readFileSync(join(SHARED, name), 'utf8'));
  return { positions, faces: faces.map((face) => face.map(([v]) => v)) };
}

/** Where the base of the bunny ends, above all holes in it. */
const BASE_OF_BUNNY = 0.5;

/** The bunny without its base: a disk. */
async function bunnyDisk() {
  const { positions, faces } = await publicMesh('bunny');
  const isAbove = (face) => face.some((v) => positions[v][1] > BASE_OF_BUNNY);
  return { positions, faces: faces.filter(isAbove) };
}

const generated = (make) => ({ origin: 'generated', make });
const fromNpm = (name, make = () => publicMesh(name)) => ({ origin: originOf(name), make });
const shared = (file) => ({
  origin: `../shared/meshes/${file}`,
  file: join(SHARED, file),
  make: () => (file.endsWith('.off') ? readOff(file) : readObj(file)),
});

const MESHES = {
  'knot-90k': generated(() => knot(900, 50)),
  'iso-64': generated(() => isosurface(64)),
  'iso-128': generated(() => isosurface(128)),
  'dirty-33k': generated(() => dirtyMesh(20_000)),
  'cut-sphere': generated(() => generatedDisk(108)),
  'bunny-4k': fromNpm('bunny'),
  'bunny-disk': fromNpm('bunny', bunnyDisk),
  snowden: fromNpm('snowden'),
  face: shared('face.obj'),
  bunny: shared('bunny-closed.off'),
  fertility: shared('fertility-genus4.off'),
};

/** Names of the meshes that every machine has; NAME+N is one that is refined N times. */
export const MESH_NAMES = Object.keys(MESHES).filter((name) => !MESHES[name].file);

/** BASE+N, or BASE alone, as `{ base, levels }`; undefined if there is no such mesh. */
export function meshName(name) {
  const [, base, levels = '0'] = /^(.+?)(?:\+(\d+))?$/.exec(name) ?? [];
  return Object.hasOwn(MESHES, base) ? { base, levels: Number(levels) } : undefined;
}

/**
 * Writes a mesh and says where it is from; returns its path and number of faces, undefined if its
 * source file is missing.
 */
export async function writeMesh(name) {
  const known = meshName(name);
  if (!known) throw new Failure(`there is no mesh "${name}"; known are ${Object.keys(MESHES)}`);
  const { origin, file, make } = MESHES[known.base];
  if (file && !existsSync(file)) {
    console.log(`skipped: ${name}, ${origin} does not exist`);
    return undefined;
  }
  const mesh = refined(await make(), known.levels);
  mkdirSync(FOLDER, { recursive: true });
  const path = join(FOLDER, `${name}.obj`);
  writeFileSync(path, objText(mesh));
  console.log(`${name}: ${mesh.faces.length} faces, ${origin}`);
  return { path, faces: mesh.faces.length };
}
