import { boundaryEdges } from './mesh';
import { weld } from './weld';

/** The charts of a layout. */
export interface ChartTriangles {
  /** 2 per vertex; no vertex belongs to more than one chart. */
  uv: Float64Array;
  indices: Uint32Array;
  chartOfTriangle: Uint32Array;
}

/** Vertices at the same point of the same chart count as one; charts may lie on top of each other. */
export function weldInCharts({ uv, indices, chartOfTriangle }: ChartTriangles): Uint32Array {
  const points = new Float64Array((3 * uv.length) / 2);
  for (let v = 0; 2 * v < uv.length; ++v) {
    points[3 * v] = uv[2 * v];
    points[3 * v + 1] = uv[2 * v + 1];
  }
  for (let c = 0; c < indices.length; ++c)
    points[3 * indices[c] + 2] = chartOfTriangle[Math.floor(c / 3)];
  return weld(points, 3);
}

/** Boundary edges after merging vertices: `same` names the representative of each. */
export function edgesOfOne(indices: Uint32Array, same: Uint32Array): Uint32Array {
  const joined = new Uint32Array(indices.length);
  let size = 0;
  for (let c = 0; c < indices.length; c += 3) {
    const i = same[indices[c]];
    const j = same[indices[c + 1]];
    const k = same[indices[c + 2]];
    if (i === j || j === k || k === i) continue; // no area, no edges
    joined[size++] = i;
    joined[size++] = j;
    joined[size++] = k;
  }
  return boundaryEdges(joined.subarray(0, size));
}
