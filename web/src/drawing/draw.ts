import type { FlatDrawing } from '../model/drawing';
import { drawLayout } from './draw-layout';
import { drawFlatMesh, drawMarks } from './draw-mesh';
import type { FlatPicture } from './picture';

/** Both views of a layout; `chartCount` is the number of charts of an atlas, 0 for a disk. */
export function drawFlat(picture: FlatPicture, chartCount: number): FlatDrawing {
  return {
    mesh: drawFlatMesh(picture, chartCount),
    layout: drawLayout(picture, chartCount),
    marks: drawMarks(picture),
    edgeCharts: edgeCharts(picture),
    boundary: picture.boundary ?? new Uint32Array(),
    spreads: picture.heat.spreads,
    chartColors: picture.chartColors ?? null,
    areas: picture.areas ?? null,
  };
}

/** Vertices of an atlas belong to one chart each. */
function edgeCharts({ mesh, edges, charts }: FlatPicture): Uint32Array {
  if (!charts) return new Uint32Array();
  const chartOfVertex = new Uint32Array(mesh.uv.length / 2);
  for (let c = 0; c < mesh.indices.length; ++c)
    chartOfVertex[mesh.indices[c]] = charts[Math.floor(c / 3)];
  const chartOfEdge = new Uint32Array(edges.length / 2);
  for (let e = 0; e < chartOfEdge.length; ++e) chartOfEdge[e] = chartOfVertex[edges[2 * e]];
  return chartOfEdge;
}
