import type { Abflat, FlattenOptions } from 'abflat';
import { type ChartMesh, type Coordinates, reshaped } from '../arrange/chart-mesh';
import { filled, isMirrored, type OwnMesh, ownMesh } from '../arrange/own-mesh';
import { gridLayout } from '../arrange/quad-grid';
import { rectangleFor } from '../arrange/rectangle';
import { refitted } from '../arrange/refit';
import type { Unwrapped } from '../model/model';
import { pinsInChart } from '../selection/pin-set';
import { RESHAPING } from '../words/choosing';

export type Reshape = 'rectified' | 'relaxed';

export interface ReshapingEvents {
  /** A chart as a mesh of its own. */
  chart(outcome: Unwrapped, chart: number): Promise<ChartMesh>;
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
  outcome: Unwrapped,
  charts: Iterable<number>,
  how: Reshape,
  pins: Uint32Array,
  events: ReshapingEvents,
): Promise<Reshaped> {
  const { uv, unpacked } = outcome.result;
  const out: Reshaped = { coordinates: { uv, unpacked }, done: [], failed: [] };
  for (const chart of charts) {
    const mesh = await events.chart(outcome, chart);
    try {
      const shape = await shapeOf(
        outcome,
        mesh,
        how,
        pinsInChart(pins, outcome.result, mesh),
        events,
      );
      out.coordinates = reshaped(out.coordinates, mesh, shape);
      out.done.push(chart);
    } catch (error) {
      out.failed.push([chart, (error as Error).message]);
    }
  }
  return out;
}

async function shapeOf(
  { mesh: { faces }, result }: Unwrapped,
  mesh: ChartMesh,
  how: Reshape,
  pins: number[],
  events: ReshapingEvents,
): Promise<Float64Array> {
  if (isMirrored(mesh)) throw new Error(RESHAPING.mirrored);
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
