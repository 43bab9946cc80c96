import { MinHeap } from './min-heap';
import { otherEnd, type SurfaceGraph } from './surface-graph';

const NONE = 0xffffffff;

/** Shortest paths along edges from one place to all others. */
export class ShortestPaths {
  /** From the start; infinite where there is no way. */
  readonly distances: Float64Array;
  /** The last edge on the way to each place. */
  private readonly lastEdge: Uint32Array;

  constructor(
    private readonly graph: SurfaceGraph,
    readonly start: number,
  ) {
    const { firstAt, edgesAt, lengths } = graph;
    const placeCount = graph.places.length;
    this.distances = new Float64Array(placeCount).fill(Infinity);
    this.lastEdge = new Uint32Array(placeCount).fill(NONE);
    this.distances[start] = 0;
    const heap = new MinHeap(placeCount);
    heap.add(start, 0);
    for (let v = heap.take(); v !== undefined; v = heap.take()) {
      for (let i = firstAt[v]; i < firstAt[v + 1]; ++i) {
        const edge = edgesAt[i];
        const to = otherEnd(graph, edge, v);
        const distance = this.distances[v] + lengths[edge];
        if (distance >= this.distances[to]) continue;
        this.distances[to] = distance;
        this.lastEdge[to] = edge;
        heap.add(to, distance);
      }
    }
  }

  /** The edges from the start to a place; empty where there is no way. */
  to(place: number): number[] {
    const edges: number[] = [];
    for (let v = place; this.lastEdge[v] !== NONE; ) {
      const edge = this.lastEdge[v];
      edges.push(edge);
      v = otherEnd(this.graph, edge, v);
    }
    return edges.reverse();
  }
}
