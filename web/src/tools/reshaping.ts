import type { Abflat, FlattenOptions } from 'abflat';
import { type ChartMesh, type Coordinates, reshape } from '../arrange/chart-mesh';
import { filled, isMirrored, mirrored, type OwnMesh, ownMesh } from '../arrange/own-mesh';
import { gridLayout } from '../arrange/quad-grid';
import { rectangleFor } from '../arrange/rectangle';
import { refitted } from '../arrange/refit';
import type { Arrangeable } from '../model/arrangeable';
import { pinsInChart } from '../selection/pin-set';
import { RESHAPING } from '../words/choosing';

export type Reshape = 'rectified' | 'relaxed';

export interface ReshapingEvents {
  /** Charts as meshes of their own. */
  charts(outcome: Arrangeable, charts: Uint32Array): Promise<ChartMesh[]>;
  /** Work of abflat beside its runs. */
  aside<T>(work: (abflat: Abflat, signal: AbortSignal) => Promise<T>): Promise<T>;
}

/** What came of it: other coordinates, and which charts were left as they are, and why. */
export interface Reshaped {
  coordinates: Coordinates;
  done: number[];
  failed: [number, string][];
}

/** Gives charts another shape in their place, one after the other. `pins`: corners of the atlas. */
export async function reshapeCharts(
  outcome: Arrangeable,
  charts: number[],
  how: Reshape,
  pins: Uint32Array,
  events: ReshapingEvents,
): Promise<Reshaped> {
  const { uv, unpacked } = outcome.result;
  const coordinates = { uv: uv.slice(), unpacked: unpacked.slice() };
  const out: Reshaped = { coordinates, done: [], failed: [] };
  const meshes = await events.charts(outcome, Uint32Array.from(charts));
  for (const [i, mesh] of meshes.entries()) {
    try {
      const own = pinsInChart(pins, outcome.result, mesh);
      reshape(coordinates, mesh, await shapeAsSeen(outcome, mesh, charts[i], how, own, events));
      out.done.push(charts[i]);
    } catch (error) {
      out.failed.push([charts[i], (error as Error).message]);
    }
  }
  return out;
}

/** An island of a file may be mirrored, and stays so. */
async function shapeAsSeen(
  outcome: Arrangeable,
  mesh: ChartMesh,
  chart: number,
  ...how: [Reshape, number[], ReshapingEvents]
): Promise<Float64Array> {
  const isOfFile = outcome.mode === 'pack';
  if (isOfFile && outcome.result.report.charts[chart].lies === 'stacked')
    throw new Error(RESHAPING.stacked);
  if (!isMirrored(mesh)) return shapeOf(outcome, mesh, ...how);
  if (!isOfFile) throw new Error(RESHAPING.mirrored);
  const image = { ...mesh, texcoords: mirrored(mesh.texcoords) };
  return mirrored(await shapeOf(outcome, image, ...how));
}

async function shapeOf(
  { mesh: { faces }, result }: Arrangeable,
  mesh: ChartMesh,
  how: Reshape,
  pins: number[],
  events: ReshapingEvents,
): Promise<Float64Array> {
  const own = ownMesh(mesh);
  if (!own) throw new Error(RESHAPING.touches);
  if (how === 'relaxed') {
    const pinned = pins.map((vertex) => ({
      vertex: own.same[vertex],
      uv: at(mesh.texcoords, vertex),
    }));
    const isPinned = new Set(pinned.map(({ vertex }) => vertex)).size > 1;
    const shape = await flattened(
      mesh,
      own,
      { balance: 1, ...(isPinned && { pins: pinned }) },
      events,
    );
    return isPinned ? shape : refitted(shape, mesh, false);
  }
  const hasFaces = faces?.length === result.chartOfTriangle.length;
  const ownFaces = Uint32Array.from({ length: mesh.indices.length / 3 }, (_, f) => {
    const triangle = mesh.corners[3 * f] / 3;
    return hasFaces ? faces[triangle] : triangle;
  });
  const grid = gridLayout(mesh, own, ownFaces);
  if (grid) return refitted(grid, mesh, true);
  const outline = rectangleFor(mesh, own);
  if (!outline) throw new Error(RESHAPING.noRectangle);
  const places = Array.from(outline, ([vertex, uv]) => ({ vertex, uv }));
  return refitted(await flattened(mesh, own, { pins: places }, events), mesh, true);
}

const at = (uv: Float64Array, v: number): [number, number] => [uv[2 * v], uv[2 * v + 1]];

/** Throws if the result is not valid, or there is none. */
async function flattened(
  mesh: ChartMesh,
  own: OwnMesh,
  options: FlattenOptions,
  events: ReshapingEvents,
): Promise<Float64Array> {
  const { uv, vertexMap, report } = await events.aside((abflat, signal) =>
    abflat.flatten(filled(mesh, own), { ...options, signal }),
  );
  if (!report.valid) throw new Error(report.charts[0].problem);
  const numbers = new Map(Array.from(vertexMap, (vertex, i) => [vertex, i]));
  return Float64Array.from({ length: mesh.texcoords.length }, (_, i) => {
    const number = numbers.get(own.same[i >> 1]) ?? 0;
    return uv[2 * number + (i % 2)];
  });
}
