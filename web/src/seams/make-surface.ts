import type { DisplayMesh } from '../mesh';
import { toUnitSphere } from '../unit-sphere';
import { weld } from '../weld';
import type { Surface } from './seam-model';
import { surfaceGraph } from './surface-graph';

/** What it takes to edit the seams of a mesh. */
export function makeSurface(mesh: DisplayMesh, isDisk: boolean): Surface {
  return {
    graph: surfaceGraph(mesh, placesOf(mesh, isDisk), mesh.faces),
    solid: { points: toUnitSphere(mesh), indices: mesh.indices },
  };
}

/** A disk is cut where its vertices are apart, also where they are at one place. */
function placesOf({ positions }: DisplayMesh, isDisk: boolean): Uint32Array {
  if (isDisk) return Uint32Array.from({ length: positions.length / 3 }, (_, v) => v);
  return weld(positions, 3);
}
