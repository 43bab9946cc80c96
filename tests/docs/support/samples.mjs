// The samples of the documents, and the files that they read.

import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { ROOT } from '../../../scripts/lib/paths.mjs';
import { codeBlocks, DOCUMENTS, textOf } from '../../support/documents.mjs';
import { PROGRAM } from '../../support/run-abflat.mjs';
import { CUBE_OF_PARTS } from '../../support/small-meshes.mjs';

/** Languages whose samples run. Those of CMake and C are tested in tests/consumers. */
const RUN = ['sh', 'js', 'ts', 'python', 'cpp', 'yaml'];
const ELSEWHERE = ['cmake', 'c'];

/** Every sample of docs/, as `{ name, document, language, skip, code, line }`. */
export function samples() {
  return DOCUMENTS.filter((file) => file.startsWith('docs/')).flatMap((document) =>
    codeBlocks(textOf(document))
      .filter(({ language }) => language !== '' && !ELSEWHERE.includes(language))
      .map((sample) => ({ ...sample, document, name: `${document}:${sample.line}` })),
  );
}

export const isRunnable = ({ language }) => RUN.includes(language);

/** The same mesh as OFF. */
function offOf(obj) {
  const rows = (word) =>
    obj
      .split('\n')
      .filter((line) => line.startsWith(`${word} `))
      .map((line) => line.slice(2).split(' '));
  const faces = rows('f').map((face) => [
    face.length,
    ...face.map((v) => Number.parseInt(v, 10) - 1),
  ]);
  const lines = [['OFF'], [rows('v').length, faces.length, 0], ...rows('v'), ...faces];
  return `${lines.map((line) => line.join(' ')).join('\n')}\n`;
}

const MADE = [
  'sample head -o head.obj',
  'unwrap robot.obj -o robot.ply',
  'unwrap robot.obj -o robot.glb --texcoord 1',
  'unwrap robot.obj -o mesh.glb',
  'unwrap robot.obj -o models/robot.glb --resolution 2048 --padding 8',
];

/** Puts the program, as in the folder of a build, and the meshes that samples name into a folder. */
export function prepare(folder) {
  const program = join(folder, 'build/native/abflat');
  mkdirSync(dirname(program), { recursive: true });
  symlinkSync(PROGRAM, program);
  const write = (name, text) => writeFileSync(join(folder, name), text);
  write('robot.obj', CUBE_OF_PARTS);
  write('engine.obj', CUBE_OF_PARTS);
  write('pins.txt', '0 0 0\n50 1 0\n');
  prepareProject(folder);
  for (const line of MADE) {
    const { status, stderr } = spawnSync(program, line.split(' '), { cwd: folder });
    if (status !== 0) throw new Error(`abflat ${line}\n${stderr}`);
  }
  write('head.off', offOf(readFileSync(join(folder, 'head.obj'), 'utf8')));
}

/** A web project, which samples of workflows are about. */
function prepareProject(folder) {
  mkdirSync(join(folder, 'models'));
  const script = 'verify-models.mjs';
  copyFileSync(join(ROOT, 'examples/web-build', script), join(folder, script));
}
