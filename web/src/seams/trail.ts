import { otherEnd, type SurfaceGraph } from '../surface/surface-graph';

/**
 * To a place behind it, a trail goes back unless that is so many times as far as the way there:
 * then it closes a loop.
 */
const DETOUR = 1.5;

/** A path along edges that grows at its end, and is taken back where it goes back. */
export class Trail {
  /** One more than edges. */
  readonly places: number[];
  readonly edges: number[] = [];

  constructor(
    private readonly graph: SurfaceGraph,
    start: number,
  ) {
    this.places = [start];
  }

  get end(): number {
    return this.places[this.edges.length];
  }

  /** Follows a shortest path that begins at its end. */
  follow(path: number[]): void {
    const end = path.reduce((place, edge) => otherEnd(this.graph, edge, place), this.end);
    const known = this.places.lastIndexOf(end);
    const goesBack =
      known >= 0 && this.length(this.edges.slice(known)) <= DETOUR * this.length(path);
    if (goesBack) this.shorten(known);
    else for (const edge of path) this.step(edge);
  }

  private step(edge: number): void {
    const count = this.edges.length;
    if (edge === this.edges[count - 1]) {
      this.shorten(count - 1);
      return;
    }
    this.places.push(otherEnd(this.graph, edge, this.end));
    this.edges.push(edge);
  }

  private shorten(count: number): void {
    this.edges.length = count;
    this.places.length = count + 1;
  }

  private length(edges: number[]): number {
    return edges.reduce((sum, edge) => sum + this.graph.lengths[edge], 0);
  }
}
