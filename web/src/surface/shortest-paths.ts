import { MinHeap } from './min-heap';
import { otherEnd, type SurfaceGraph } from './surface-graph';

const NONE = 0xffffffff;

/** Shortest paths along edges from one place to all others, found only as far as requested. */
export class ShortestPaths {
  /** From the start; final once the place is reached. */
  private readonly distances: Float64Array;
  /** The last edge on the path to each place. */
  private readonly lastEdge: Uint32Array;
  private readonly isReached: Uint8Array;
  private readonly heap: MinHeap;

  constructor(
    private readonly graph: SurfaceGraph,
    readonly start: number,
  ) {
    const placeCount = graph.places.length;
    this.distances = new Float64Array(placeCount).fill(Infinity);
    this.lastEdge = new Uint32Array(placeCount).fill(NONE);
    this.isReached = new Uint8Array(placeCount);
    this.distances[start] = 0;
    this.heap = new MinHeap(placeCount);
    this.heap.add(start, 0);
  }

  /** Reaches that many more places; returns whether there are none left. */
  grow(count: number): boolean {
    for (let i = 0; i < count; ++i) if (!this.step()) return true;
    return false;
  }

  /** Whether the path to a place is known already. */
  hasReached(place: number): boolean {
    return this.isReached[place] === 1;
  }

  /** From the start; infinite if there is no path. */
  distanceTo(place: number): number {
    this.reach(place);
    return this.distances[place];
  }

  /** The edges from the start to a place; empty if there is no path. */
  to(place: number): number[] {
    this.reach(place);
    const edges: number[] = [];
    for (let v = place; this.lastEdge[v] !== NONE; ) {
      const edge = this.lastEdge[v];
      edges.push(edge);
      v = otherEnd(this.graph, edge, v);
    }
    return edges.reverse();
  }

  private reach(place: number): void {
    while (!this.isReached[place] && this.step());
  }

  /** Reaches the nearest unreached place; returns whether there was one. */
  private step(): boolean {
    const v = this.heap.take();
    if (v === undefined) return false;
    this.isReached[v] = 1;
    const { firstAt, edgesAt, lengths } = this.graph;
    for (let i = firstAt[v]; i < firstAt[v + 1]; ++i) {
      const edge = edgesAt[i];
      const to = otherEnd(this.graph, edge, v);
      const distance = this.distances[v] + lengths[edge];
      if (distance >= this.distances[to]) continue;
      this.distances[to] = distance;
      this.lastEdge[to] = edge;
      this.heap.add(to, distance);
    }
    return true;
  }
}
