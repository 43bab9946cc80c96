/** The parts of an atlas that its colours depend on. */
export interface ColoredAtlas {
  indices: Uint32Array;
  /** Per triangle; not a valid chart number for a triangle without area. */
  chartOfTriangle: Uint32Array;
  chartCount: number;
  /** Edges of the charts' outlines, as pairs of vertices. */
  edges: Uint32Array;
  /** Per vertex, the same number for vertices that are one in 3D. */
  places: Uint32Array;
  uv: Float64Array;
}

/**
 * The least number of cells along the side of a tile. Charts in the same or adjacent cells lie side
 * by side.
 */
const LEAST_CELLS = 96;
/**
 * The most charts that are compared where many meet, such as at the tip of a cone in pieces: there
 * are no more colours anyway.
 */
const MOST_AT_ONCE = 16;

/** Which charts are neighbours of which. */
export class ChartNeighbours {
  /** Along an edge of the surface. */
  readonly byEdge: Set<number>[];
  /** At a point of the surface; includes those of `byEdge`. */
  readonly byPoint: Set<number>[];
  /** In the layout. */
  readonly inLayout: Set<number>[];

  constructor({ indices, chartOfTriangle, chartCount, edges, places, uv }: ColoredAtlas) {
    const none = () => Array.from({ length: chartCount }, () => new Set<number>());
    this.byEdge = none();
    this.byPoint = none();
    this.inLayout = none();
    const chartOf = new Uint32Array(places.length).fill(chartCount);
    for (let c = 0; c < indices.length; ++c)
      chartOf[indices[c]] = chartOfTriangle[Math.floor(c / 3)];
    const cells = Math.max(LEAST_CELLS, Math.ceil(2 * Math.sqrt(chartCount)));
    const onEdges = new Meetings(this.byEdge);
    const atPoints = new Meetings(this.byPoint);
    const inCells = new Meetings(this.inLayout);
    for (let i = 0; i < edges.length; i += 2) {
      const a = edges[i];
      const b = edges[i + 1];
      const chart = chartOf[a];
      if (chart >= chartCount) continue;
      const from = places[a];
      const to = places[b];
      onEdges.meet(Math.min(from, to) * places.length + Math.max(from, to), chart);
      atPoints.meet(from, chart);
      atPoints.meet(to, chart);
      meetAlong(uv, a, b, cells, (cell) => inCells.meet(cell, chart));
    }
    inCells.meetAcross([1, ROW - 1, ROW, ROW + 1]);
  }
}

/** Offset from a cell to the one above it. */
const ROW = 2 ** 22;

/** Calls `meet` with the cells along an edge, sampled at most a cell's width apart. */
function meetAlong(
  uv: Float64Array,
  a: number,
  b: number,
  cells: number,
  meet: (cell: number) => void,
): void {
  const u = cells * uv[2 * a];
  const v = cells * uv[2 * a + 1];
  const du = cells * uv[2 * b] - u;
  const dv = cells * uv[2 * b + 1] - v;
  const steps = Math.min(cells, Math.ceil(Math.hypot(du, dv)));
  for (let i = 0; i <= steps; ++i) {
    const share = i / (steps || 1);
    meet(Math.floor(u + share * du) + ROW * Math.floor(v + share * dv));
  }
}

/** Charts that meet at the same place become neighbours. */
class Meetings {
  private readonly at = new Map<number, number[]>();

  constructor(private readonly neighbours: Set<number>[]) {}

  meet(place: number, chart: number): void {
    const here = this.at.get(place);
    if (!here) this.at.set(place, [chart]);
    else if (here.length < MOST_AT_ONCE && !here.includes(chart)) {
      for (const other of here) this.join(chart, other);
      here.push(chart);
    }
  }

  /** Those at places that differ by one of `steps` become neighbours as well. */
  meetAcross(steps: number[]): void {
    for (const [place, charts] of this.at)
      for (const step of steps)
        for (const other of this.at.get(place + step) ?? [])
          for (const chart of charts) if (chart !== other) this.join(chart, other);
  }

  private join(a: number, b: number): void {
    this.neighbours[a].add(b);
    this.neighbours[b].add(a);
  }
}
