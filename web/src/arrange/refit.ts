import { areaInUv, type ChartMesh } from './chart-mesh';
import { boxOf, middleOf, pointOf } from './charts';
import { moved, turned } from './motion';
import { bestMotion } from './stacks';

const QUARTER = Math.PI / 2;

/** Another shape of a chart, where it was and as large: turned as the old one or, if `isUpright`, by right angles only. */
export function refitted(shape: Float64Array, mesh: ChartMesh, isUpright: boolean): Float64Array {
  const { texcoords, indices, vertices } = mesh;
  const all = [...vertices.keys()];
  const pointsOf = (uv: Float64Array) => all.map((v) => pointOf(uv, v));
  const { a, b } = bestMotion(pointsOf(shape), pointsOf(texcoords));
  const best = Math.atan2(b, a);
  const angle = isUpright ? QUARTER * Math.round(best / QUARTER) : best;
  const scale = Math.sqrt(areaInUv(texcoords, indices) / areaInUv(shape, indices));
  const motion = turned([0, 0], angle, scale);
  const placed = Float64Array.from(all.flatMap((v) => moved(motion, pointOf(shape, v))));
  const [from, to] = [placed, texcoords].map((uv) => middleOf(boxOf(uv, all)));
  return placed.map((x, i) => x + to[i % 2] - from[i % 2]);
}
