import { BufferAttribute, BufferGeometry, DoubleSide, type Ray } from 'three';
import { MeshBVH, type SerializedBVH } from 'three-mesh-bvh';

/** Triangles in 3D: `points` has xyz per vertex; `tree` is the hierarchy of their boxes. */
export interface SolidArrays {
  points: Float32Array;
  indices: Uint32Array;
  tree: SerializedBVH;
}

export interface Hit {
  triangle: number;
  distance: number;
}

/** Slow for many triangles. */
export function withTree(points: Float32Array, indices: Uint32Array): SolidArrays {
  const bvh = new MeshBVH(geometryOf(points, indices), { indirect: true });
  const tree = MeshBVH.serialize(bvh, { cloneBuffers: false });
  return { points, indices, tree: { ...tree, index: null } };
}

/** Triangles that can be hit by rays. */
export class Solid {
  readonly points: Float32Array;
  readonly indices: Uint32Array;
  private readonly bvh: MeshBVH;

  constructor({ points, indices, tree }: SolidArrays) {
    this.points = points;
    this.indices = indices;
    this.bvh = MeshBVH.deserialize(tree, geometryOf(points, indices), { setIndex: false });
  }

  /** The first triangle that a ray hits, from either side. */
  firstHit(ray: Ray): Hit | null {
    const hit = this.bvh.raycastFirst(ray, DoubleSide);
    return hit && { triangle: hit.faceIndex ?? -1, distance: hit.distance };
  }
}

function geometryOf(points: Float32Array, indices: Uint32Array): BufferGeometry {
  return new BufferGeometry()
    .setAttribute('position', new BufferAttribute(points, 3))
    .setIndex(new BufferAttribute(indices, 1));
}
