// One mesh unwrapped by the native program, and by xatlas as WebAssembly, measured alike.

import { readFileSync } from 'node:fs';
import { NATIVE_PROGRAM } from '../../../scripts/lib/paths.mjs';
import { Failure, run } from '../../../scripts/lib/run.mjs';
import { parseObj } from '../../support/atlas.mjs';
import { measureAtlas } from './atlas_measures.mjs';

const ATLAS = { padding: 2, resolution: 1024 };

/** From the OBJ file `path` to `output`; seconds are those of everything between both files, the median of `repeat` runs. */
export async function unwrapWithAbflat(path, output, { threads, maxStretch, repeat }) {
  const args = ['unwrap', path, '-o', output, '--report', '-', '--quiet'];
  args.push('--threads', threads, '--max-stretch', maxStretch);
  args.push('--padding', `${ATLAS.padding}`, '--resolution', `${ATLAS.resolution}`);
  const reports = [];
  for (let i = 0; i < repeat; i++) {
    const { code, output: text } = await run(NATIVE_PROGRAM, args, { capture: true });
    if (code !== 0) throw new Failure(`${path}: ${text.trim()}`);
    reports.push(JSON.parse(text));
  }
  const report = reports.toSorted((a, b) => a.timings.total - b.timings.total)[repeat >> 1];
  const { positions, texcoords, faces } = parseObj(readFileSync(output, 'utf8'));
  const triangles = faces.map((face) => ({
    vertices: face.map(([v]) => v),
    texcoords: face.map(([, t]) => t),
  }));
  return {
    seconds: report.timings.total,
    ...report.timings,
    charts: report.charts.length,
    utilization: report.atlas.utilization,
    valid: report.valid,
    ...measureAtlas({ triangles, positions, texcoords }),
  };
}

/** With the options that xatlas has by default; seconds are those from arrays to arrays. */
export async function unwrapWithXatlas(path) {
  // Here, so that the benchmark of the native program alone does not need it.
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
