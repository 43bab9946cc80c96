// Unwraps one mesh with the native program, and with xatlas as WebAssembly, measured alike.

import { readFileSync, rmSync } from 'node:fs';
import { NATIVE_PROGRAM } from '../../../scripts/lib/paths.mjs';
import { Failure, run } from '../../../scripts/lib/run.mjs';
import { parseObj } from '../../support/atlas.mjs';
import { measureAtlas } from './atlas_measures.mjs';
import { layoutOf } from './layout_measures.mjs';

const ATLAS = { padding: 2, resolution: 1024 };

/**
 * Unwraps the mesh `path` to the OBJ file `output` with the given command line options; returns the
 * report of the median of `repeat` runs, and the layout. An invalid result counts as a result too.
 */
export async function unwrapped(path, output, options, repeat) {
  const file = `${output}.json`;
  const args = ['unwrap', path, '-o', output, '--report', file, '--quiet', ...options];
  const reports = [];
  for (let i = 0; i < repeat; i++) {
    const { code, output: text } = await run(NATIVE_PROGRAM, args, { capture: true });
    if (code > 1) throw new Failure(`${path}: ${text.trim()}`);
    reports.push(JSON.parse(readFileSync(file, 'utf8')));
    rmSync(file);
  }
  const report = reports.toSorted((a, b) => a.timings.total - b.timings.total)[repeat >> 1];
  return { report, layout: layoutOf(parseObj(readFileSync(output, 'utf8'))) };
}

/**
 * Unwraps the OBJ file `path` to `output`; seconds cover everything between both files, as the
 * median of `repeat` runs.
 */
export async function unwrapWithAbflat(path, output, { threads, maxStretch, repeat }) {
  const options = ['--threads', threads, '--max-stretch', maxStretch];
  options.push('--padding', `${ATLAS.padding}`, '--resolution', `${ATLAS.resolution}`);
  const { report, layout } = await unwrapped(path, output, options, repeat);
  return {
    seconds: report.timings.total,
    ...report.timings,
    charts: report.charts.length,
    utilization: report.atlas.utilization,
    valid: report.valid,
    ...measureAtlas(layout),
  };
}

/** With xatlas's default options; seconds are measured from arrays to arrays. */
export async function unwrapWithXatlas(path) {
  // Imported here, so that the benchmark of only the native program does not need it.
  const xatlas = await import('watlas');
  await xatlas.Initialize();
  const { positions, faces } = parseObj(readFileSync(path, 'utf8'));
  const atlas = new xatlas.Atlas();
  const begin = performance.now();
  atlas.addMesh({
    vertexPositionData: Float32Array.from(positions.flat()),
    vertexCount: positions.length,
    vertexPositionStride: 12,
    indexData: Uint32Array.from(faces.flatMap((face) => face.map(([v]) => v))),
    indexCount: 3 * faces.length,
  });
  atlas.generate({}, ATLAS);
  const seconds = (performance.now() - begin) / 1000;
  const mesh = atlas.getMesh(0);
  const input = [];
  const texcoords = [];
  for (let i = 0; i < mesh.vertexCount; i++) {
    const { xref, uv } = mesh.getVertex(i);
    input.push(xref);
    texcoords.push([...uv]);
  }
  const corners = new Uint32Array(mesh.indexCount);
  mesh.getIndexArray(corners);
  const triangles = [];
  for (let c = 0; c < corners.length; c += 3) {
    const three = [...corners.subarray(c, c + 3)];
    triangles.push({ vertices: three.map((i) => input[i]), texcoords: three });
  }
  const shares = new Float32Array(atlas.atlasCount);
  atlas.getUtilization(shares);
  const charts = atlas.chartCount;
  atlas.delete();
  return {
    seconds,
    charts,
    utilization: shares.reduce((sum, x) => sum + x, 0) / shares.length,
    ...measureAtlas({ triangles, positions, texcoords }),
  };
}
