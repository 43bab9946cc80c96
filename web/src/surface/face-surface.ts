import type { Solid } from './solid';
import type { SurfaceGraph } from './surface-graph';
import { edgeBetween } from './surface-graph';

/** A surface by its faces: polygons, or single triangles. */
export class FaceSurface {
  /** The first triangle of each face, and the end of the last; null: each triangle is a face. */
  private readonly first: Uint32Array | null;

  /** `faces`: the face of each triangle, in ascending order, if that is not the triangle itself. */
  constructor(
    readonly graph: SurfaceGraph,
    readonly solid: Solid,
    private readonly faces?: Uint32Array,
  ) {
    this.first = faces ? startsOf(faces) : null;
  }

  faceOf(triangle: number): number {
    return this.faces ? this.faces[triangle] : triangle;
  }

  trianglesOf(face: number): number[] {
    const { first } = this;
    if (!first) return [face];
    return Array.from({ length: first[face + 1] - first[face] }, (_, i) => first[face] + i);
  }

  /** The edges around a face. */
  edgesOf(face: number): number[] {
    const { indices } = this.solid;
    const found: number[] = [];
    for (const f of this.trianglesOf(face))
      for (let k = 0; k < 3; ++k) {
        const edge = edgeBetween(this.graph, indices[3 * f + k], indices[3 * f + ((k + 1) % 3)]);
        // None inside a face.
        if (edge >= 0) found.push(edge);
      }
    return found;
  }
}

function startsOf(faces: Uint32Array): Uint32Array {
  const count = faces.length > 0 ? faces[faces.length - 1] + 1 : 0;
  const starts = new Uint32Array(count + 1);
  for (const face of faces) starts[face + 1] += 1;
  for (let f = 0; f < count; ++f) starts[f + 1] += starts[f];
  return starts;
}
