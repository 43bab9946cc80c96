import { weld } from '../mesh/weld';
import type { ChartMesh } from './chart-mesh';
import { areaOf, outlineOf } from './stacks';

/** A chart whose vertices at the same point of uv are one: the first of them. */
export interface OwnMesh {
  indices: Uint32Array;
  /** Its outline, counterclockwise; null if it has holes, or none. */
  loop: number[] | null;
  /** That vertex, for each vertex of the chart. */
  same: Uint32Array;
}

export function ownMesh({ texcoords, indices }: ChartMesh): OwnMesh {
  const same = weld(texcoords, 2);
  const own = indices.map((v) => same[v]);
  return { indices: own, loop: loopOf(own), same };
}

function loopOf(indices: Uint32Array): number[] | null {
  const triangles = Array.from({ length: indices.length / 3 }, (_, f) => f);
  const sides = outlineOf({ indices }, triangles);
  const next = new Map(sides);
  if (next.size < sides.length) return null;
  const [start] = next.keys();
  const loop = [start];
  for (let v = next.get(start); v !== start && v !== undefined; v = next.get(v)) loop.push(v);
  return loop.length === sides.length ? loop : null;
}

/** Whether triangles run clockwise in the layout. */
export const isMirrored = ({ texcoords: uv, indices }: ChartMesh): boolean =>
  areaOf({ uv, indices, chartOfTriangle: new Uint32Array() }, 0) < 0;
