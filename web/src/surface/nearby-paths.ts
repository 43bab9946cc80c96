import { MinHeap } from './min-heap';
import { otherEnd, type SurfaceGraph } from './surface-graph';

const NONE = 0xffffffff;

/**
 * Shortest paths along edges between places that are near each other. Takes as long as there are
 * places about as near, however large the surface is.
 */
export class NearbyPaths {
  private readonly distances: Float64Array;
  private readonly lastEdge: Uint32Array;
  private readonly heap: MinHeap;
  /** The places that the last search has met. */
  private met: number[] = [];
  /** How many places the last search has reached. */
  reached = 0;

  constructor(private readonly graph: SurfaceGraph) {
    const { length } = graph.places;
    this.distances = new Float64Array(length).fill(Infinity);
    this.lastEdge = new Uint32Array(length).fill(NONE);
    this.heap = new MinHeap(length);
  }

  /** The edges from one place to another; null if that is not among the `most` nearest ones. */
  between(from: number, to: number, most: number): number[] | null {
    this.begin(from);
    for (this.reached = 0; this.reached < most; ++this.reached) {
      const place = this.heap.take();
      if (place === undefined) return null;
      if (place === to) return this.pathTo(to);
      this.goOn(place);
    }
    return null;
  }

  private begin(from: number): void {
    for (const place of this.met) {
      this.distances[place] = Infinity;
      this.lastEdge[place] = NONE;
    }
    this.heap.clear();
    this.met = [];
    this.meet(from, 0);
  }

  private goOn(place: number): void {
    const { firstAt, edgesAt, lengths } = this.graph;
    for (let i = firstAt[place]; i < firstAt[place + 1]; ++i) {
      const edge = edgesAt[i];
      const to = otherEnd(this.graph, edge, place);
      const distance = this.distances[place] + lengths[edge];
      if (distance >= this.distances[to]) continue;
      this.meet(to, distance);
      this.lastEdge[to] = edge;
    }
  }

  private meet(place: number, distance: number): void {
    if (this.distances[place] === Infinity) this.met.push(place);
    this.distances[place] = distance;
    this.heap.add(place, distance);
  }

  private pathTo(to: number): number[] {
    const edges: number[] = [];
    for (let place = to; this.lastEdge[place] !== NONE; ) {
      const edge = this.lastEdge[place];
      edges.push(edge);
      place = otherEnd(this.graph, edge, place);
    }
    return edges.reverse();
  }
}
