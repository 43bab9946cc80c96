// Meshes whose layouts are looked at, and how they are unwrapped and measured.

import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, parse } from 'node:path';
import { Failure, run } from '../../../scripts/lib/run.mjs';
import { parseObj } from '../../support/atlas.mjs';
import { chartedLayout } from '../../support/charted-layout.mjs';
import { judgeFile } from '../../support/exact-atlas.mjs';
import { faultsOf } from '../../support/layout-expectations.mjs';
import { looksOf } from '../../support/layout-looks.mjs';
import { ordinaryShapes } from '../../support/ordinary-shapes.mjs';
import { objText } from '../../support/surfaces.mjs';

const SAMPLES = ['hemisphere', 'wavy-strip', 'head', 'alpha-band', 'three-balls'];

/** The ordinary shapes and the generated samples, written to `folder`: { name, file, expect }. */
export async function ownMeshes(program, folder) {
  const shapes = ordinaryShapes().map(({ name, points, faces, expect }) => {
    const file = join(folder, `${name.replaceAll(/[ :,]+/g, '-')}.obj`);
    writeFileSync(file, objText({ positions: points, faces }));
    return { name, file, expect };
  });
  for (const name of SAMPLES) {
    const file = join(folder, `${name}.obj`);
    const { code, output } = await run(program, ['sample', name, '-o', file], { capture: true });
    if (code !== 0) throw new Failure(output.trim());
    shapes.push({ name, file });
  }
  return shapes;
}

export function givenMeshes(files) {
  const missing = files.find((file) => !existsSync(file));
  if (missing) throw new Failure(`There is no file ${missing}.`);
  return files.map((file) => ({ name: parse(file).name, file }));
}

function measured(name, by, layout, { up, expect, atlas }) {
  const charted = chartedLayout(layout);
  const row = { mesh: name, by, faces: charted.triangles.length, ...looksOf(charted, { up }) };
  if (expect) {
    const faults = faultsOf(expect, charted, atlas);
    row.unmet = Object.keys(faults).filter((key) => faults[key] !== '');
  }
  return { row, charted };
}

/** The layout that an OBJ file comes with, measured; undefined if some corner has no texcoord. */
export function artistsLayout({ name, file }, up) {
  if (!file.toLowerCase().endsWith('.obj')) return undefined;
  const layout = parseObj(readFileSync(file, 'latin1'));
  const isKnown = layout.faces.every((face) => face.every(([, t]) => layout.texcoords[t]));
  return isKnown ? measured(name, 'artist', layout, { up }) : undefined;
}

/** Unwraps a mesh and measures the result. */
export async function unwrappedLayout(
  { name, file, expect },
  { program, by, folder, options, up },
) {
  const output = join(folder, 'result.obj');
  const report = join(folder, 'result.json');
  const args = ['unwrap', file, '-o', output, '--report', report, '--quiet', ...options];
  const { code, output: said } = await run(program, args, { capture: true });
  if (code > 1) throw new Failure(`${file}: ${said.trim()}`);
  const { atlas, timings } = JSON.parse(readFileSync(report, 'utf8'));
  const layout = parseObj(readFileSync(output, 'latin1'));
  const out = measured(name, by, layout, { up, expect, atlas });
  out.row.seconds = timings.total;
  out.row.valid = code === 0 && judgeFile(output).isValid;
  for (const path of [output, report]) rmSync(path);
  return out;
}

/** Of each number in the rows. */
export function mediansOf(rows) {
  const median = (values) => {
    const sorted = values.toSorted((a, b) => a - b);
    const half = sorted.length >> 1;
    return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
  };
  const keys = Object.keys(rows[0]).filter((key) => typeof rows[0][key] === 'number');
  return Object.fromEntries(keys.map((key) => [key, median(rows.map((row) => row[key]))]));
}
