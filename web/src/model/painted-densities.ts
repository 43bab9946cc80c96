import { chartAreas } from '../mesh/chart-areas';
import { areasOf, type DisplayMesh } from '../mesh/mesh';
import { positionsOf } from '../mesh/positions-of';
import type { FaceDensities } from './face-densities';
import type { Unwrapped } from './model';

/** Those of faces, of which some ask for another one. */
export function withDensity(
  before: FaceDensities,
  { indices, faces }: Pick<DisplayMesh, 'indices' | 'faces'>,
  some: Iterable<number>,
  density: number,
): FaceDensities {
  const count = faces ? faces[faces.length - 1] + 1 : indices.length / 3;
  const after = before?.slice() ?? new Float32Array(count).fill(1);
  for (const face of some) after[face] = density;
  return after.every((each) => each === 1) ? undefined : after;
}

export const sameDensities = (a: FaceDensities, b: FaceDensities): boolean =>
  a === b || (a?.length === b?.length && a !== undefined && a.every((each, f) => each === b?.[f]));

/** The faces of some charts. */
export function facesOfCharts(
  { result, mesh: { faces } }: Pick<Unwrapped, 'result' | 'mesh'>,
  charts: ReadonlySet<number>,
): Set<number> {
  const found = new Set<number>();
  result.chartOfTriangle.forEach((chart, f) => {
    if (charts.has(chart)) found.add(faces ? faces[f] : f);
  });
  return found;
}

/** What each chart of an atlas asks for: the mean of its faces, as in the package. */
export function densitiesOfCharts({ result, mesh, settings }: Unwrapped): Float64Array {
  const { uv, indices, chartOfTriangle, report } = result;
  const count = report.charts.length;
  const { faceDensities: asked } = settings;
  if (!asked) return new Float64Array(count).fill(1);
  const positions = positionsOf(result, mesh);
  const areas = areasOf({ positions, indices, uv });
  return chartAreas(areas, chartOfTriangle, count, { asked, faces: mesh.faces }).asked;
}
