import { UV_FAULT } from 'abflat';
import { distortionsOf } from '../mesh/distortion';
import { areasOf } from '../mesh/mesh';
import type { FileArrays, IslandFacts } from '../model/arrangeable';
import { isChart } from './charts';
import { areaOf } from './stacks';

/** The UVs of a file, whose vertices islands may share. `positions`: 3 per vertex of `uv`. */
export interface SharedIslands {
  uv: Float64Array;
  indices: Uint32Array;
  vertexMap: Uint32Array;
  positions: Float64Array;
  chartOfTriangle: Uint32Array;
  faults: Uint8Array;
}

/** The islands as charts, with what is known of each. `faces`: the face of each triangle, if that is not the triangle itself. */
export function fileIslands(
  shared: SharedIslands,
  chartCount: number,
  faces?: Uint32Array,
): { arrays: FileArrays; facts: IslandFacts[] } {
  const arrays = apartArrays(shared);
  return { arrays, facts: factsOf(arrays, shared, chartCount, faces) };
}

/** Vertices that several islands have in common are repeated for each. */
function apartArrays({
  uv,
  indices,
  vertexMap,
  positions,
  chartOfTriangle,
}: SharedIslands): FileArrays & { positions: Float64Array } {
  const owner = new Uint32Array(vertexMap.length);
  const isOwned = new Uint8Array(vertexMap.length);
  const copies = new Map<string, number>();
  const from = [...vertexMap.keys()];
  const own = indices.map((v, c) => {
    const chart = chartOfTriangle[Math.floor(c / 3)];
    if (!isOwned[v]) {
      isOwned[v] = 1;
      owner[v] = chart;
    }
    if (owner[v] === chart) return v;
    const name = `${v} ${chart}`;
    const copy = copies.get(name) ?? from.push(v) - 1;
    copies.set(name, copy);
    return copy;
  });
  const rows = Uint32Array.from(from);
  const pick = (values: Float64Array, size: number) =>
    Float64Array.from(
      { length: size * rows.length },
      (_, i) => values[size * rows[Math.floor(i / size)] + (i % size)],
    );
  const places = pick(uv, 2);
  return {
    uv: places,
    unpacked: places.slice(),
    indices: own,
    vertexMap: rows.map((v) => vertexMap[v]),
    positions: pick(positions, 3),
    chartOfTriangle,
  };
}

function factsOf(
  arrays: FileArrays & { positions: Float64Array },
  { faults }: SharedIslands,
  chartCount: number,
  faces?: Uint32Array,
): IslandFacts[] {
  const { chartOfTriangle } = arrays;
  const sizes = areasOf(arrays);
  const { stretch } = distortionsOf(arrays, chartOfTriangle, sizes);
  const sums = Array.from({ length: chartCount }, () => ({
    ...{ faces: 0, firstFace: -1, solid: 0, stretched: 0, flat: 0, signed: 0, overlapping: 0 },
  }));
  chartOfTriangle.forEach((chart, f) => {
    if (!isChart(chart)) return;
    const sum = sums[chart];
    if (sum.faces === 0) sum.firstFace = faces ? faces[f] : f;
    sum.faces += 1;
    sum.solid += sizes.in3d[f];
    sum.flat += sizes.inUv[f];
    sum.signed += areaOf(arrays, f);
    sum.stretched += sizes.in3d[f] * stretch[f];
    if (faults[f] & UV_FAULT.overlapping) sum.overlapping += sizes.inUv[f];
  });
  return sums.map(({ faces, firstFace, solid, stretched, flat, signed, overlapping }) => ({
    ...{ faces, firstFace, area: solid, mirrored: signed < 0, valid: true },
    symmetricDirichlet: solid > 0 ? stretched / solid : 1,
    lies: overlapping === 0 ? 'apart' : 2 * overlapping > flat ? 'stacked' : 'overlapping',
    stackedOn: -1,
  }));
}
