import type { FaceSurface } from './face-surface';

/** The edges around a growing set of faces, without those between two of them. */
export class FaceOutline {
  private readonly edges = new Set<number>();
  private from: ReadonlySet<number> | null = null;
  private count = 0;

  constructor(private readonly surface: FaceSurface) {}

  /** Two vertices for each edge. Only what was added to the set since the last call is looked at. */
  around(faces: ReadonlySet<number>): Uint32Array {
    if (faces !== this.from || faces.size < this.count) {
      this.edges.clear();
      this.count = 0;
    }
    this.from = faces;
    let i = 0;
    for (const face of faces) if (i++ >= this.count) this.add(face);
    this.count = faces.size;
    const { ends } = this.surface.graph;
    return Uint32Array.from([...this.edges].flatMap((e) => [ends[2 * e], ends[2 * e + 1]]));
  }

  /** An edge that was there lies between two faces now. */
  private add(face: number): void {
    for (const edge of this.surface.edgesOf(face))
      if (!this.edges.delete(edge)) this.edges.add(edge);
  }
}
