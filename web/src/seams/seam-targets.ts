import type { Solid } from '../surface/solid';
import type { SurfaceGraph } from '../surface/surface-graph';
import type { Pixel, Sight } from '../view/sight';
import { vertexAt } from './pick';
import type { EdgeFlags } from './seam-edges';

/** What a click or a stroke can hit. */
export interface Targets {
  /** Edges. */
  seams: number[];
  /** Places on seams and boundaries. */
  places: number[];
}

export function targetsOf({ graph, all }: { graph: SurfaceGraph; all: EdgeFlags }): Targets {
  const seams: number[] = [];
  const places = new Set<number>();
  for (let edge = 0; edge < all.length; ++edge) {
    if (all[edge]) seams.push(edge);
    if (all[edge] || !graph.isInner[edge])
      places.add(graph.ends[2 * edge]).add(graph.ends[2 * edge + 1]);
  }
  return { seams, places: [...places] };
}

/** The two places of each edge. */
export function endsOf({ ends }: SurfaceGraph, edges: number[]): Uint32Array {
  return Uint32Array.from(edges.flatMap((e) => [ends[2 * e], ends[2 * e + 1]]));
}

/** The place under a pixel, at one of some others if they are near; -1 if there is none. */
export function placeAt(
  { graph, solid }: { graph: SurfaceGraph; solid: Solid },
  sight: Sight,
  at: Pixel,
  wanted: number[],
): number {
  const vertex = vertexAt(solid, sight, at, wanted);
  return vertex < 0 ? vertex : graph.places[vertex];
}
