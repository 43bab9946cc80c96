import type { DisplayMesh } from '../mesh/mesh';
import { toUnitSphere } from '../mesh/unit-sphere';
import { weld } from '../mesh/weld';
import { type SolidArrays, withTree } from './solid';
import { type SurfaceGraph, surfaceGraph } from './surface-graph';

/** What is cut, and where it appears on screen. */
export interface SurfaceArrays {
  graph: SurfaceGraph;
  solid: SolidArrays;
}

/** What is needed to edit the seams of a mesh. */
export function makeSurface(mesh: DisplayMesh, isDisk: boolean): SurfaceArrays {
  return {
    graph: surfaceGraph(mesh, placesOf(mesh, isDisk), mesh.faces),
    solid: withTree(toUnitSphere(mesh), mesh.indices),
  };
}

/** In a disk, separate vertices stay separate, even if they are at one place. */
function placesOf({ positions }: DisplayMesh, isDisk: boolean): Uint32Array {
  if (!isDisk) return weld(positions, 3);
  const places = new Uint32Array(positions.length / 3);
  for (let v = 0; v < places.length; ++v) places[v] = v;
  return places;
}
