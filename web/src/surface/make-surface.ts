import type { DisplayMesh } from '../mesh/mesh';
import { toUnitSphere } from '../mesh/unit-sphere';
import { weld } from '../mesh/weld';
import { type SolidArrays, withTree } from './solid';
import { type SurfaceGraph, surfaceGraph } from './surface-graph';

/** What is cut, and where it is seen. */
export interface SurfaceArrays {
  graph: SurfaceGraph;
  solid: SolidArrays;
}

/** What it takes to edit the seams of a mesh. */
export function makeSurface(mesh: DisplayMesh, isDisk: boolean): SurfaceArrays {
  return {
    graph: surfaceGraph(mesh, placesOf(mesh, isDisk), mesh.faces),
    solid: withTree(toUnitSphere(mesh), mesh.indices),
  };
}

/** A disk is cut where its vertices are apart, also where they are at one place. */
function placesOf({ positions }: DisplayMesh, isDisk: boolean): Uint32Array {
  if (isDisk) return Uint32Array.from({ length: positions.length / 3 }, (_, v) => v);
  return weld(positions, 3);
}
