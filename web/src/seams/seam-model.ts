import type { Solid } from '../surface/solid';
import type { SurfaceGraph } from '../surface/surface-graph';
import { History } from './history';
import { AUTOMATIC, type SeamChoice, type SeamSources } from './seam-choice';
import { type EdgeFlags, flagsOf, pairsOf, seamRun } from './seam-edges';

/** What is cut, and where it appears on screen. */
export interface Surface {
  graph: SurfaceGraph;
  solid: Solid;
}

/** The seams of one mesh: what the user wants, with undo, and what the atlas on screen has. */
export class SeamModel {
  private readonly history = new History(AUTOMATIC);
  private made: Surface | null = null;
  /** The atlas's seams, two vertices each; null until there is one. */
  private shownPairs: Uint32Array | null = null;
  private shownFlags: EdgeFlags | null = null;
  private wanted: EdgeFlags | null = null;
  private both: EdgeFlags | null = null;
  /** The seams found for choices without edges, two vertices per seam edge. */
  private readonly found = new WeakMap<SeamChoice, Uint32Array>();

  /** `makeSurface` is called when editing begins. */
  constructor(private readonly makeSurface: () => Surface) {}

  get surface(): Surface {
    this.made ??= this.makeSurface();
    return this.made;
  }

  get graph(): SurfaceGraph {
    return this.surface.graph;
  }

  get choice(): SeamChoice {
    return this.history.current;
  }

  get canUndo(): boolean {
    return this.history.canUndo;
  }

  get canRedo(): boolean {
    return this.history.canRedo;
  }

  /**
   * The seams that editing starts from: those asked for, or else those found for the choice, or
   * else those on screen. After undo, the atlas on screen does not match the choice yet.
   */
  get own(): EdgeFlags {
    const { edges, isCutFurther } = this.choice;
    const listed = isCutFurther ? null : edges;
    const pairs = listed ?? this.found.get(this.choice) ?? this.shownPairs;
    this.wanted ??= flagsOf(this.graph, pairs ?? new Uint32Array());
    return this.wanted;
  }

  /** The own seams, plus those that charts need to be disks. */
  get all(): EdgeFlags {
    const { own, shown } = this;
    this.both ??= shown ? either(own, shown) : own;
    return this.both;
  }

  /**
   * The seams of the atlas now on screen, two vertices each; `isOfChoice` is false if the atlas is
   * of an earlier choice.
   */
  show(pairs: Uint32Array, isOfChoice = true): void {
    if (isOfChoice) this.found.set(this.choice, pairs);
    this.shownPairs = pairs;
    this.shownFlags = null;
    this.forget();
  }

  /** Returns how many of these edges were not seams before. */
  cut(edges: number[]): number {
    const { own } = this;
    return this.set(
      edges.filter((e) => this.graph.isInner[e] && !own[e]),
      1,
    );
  }

  /** Returns how many of these edges were seams before. */
  join(edges: number[]): number {
    const { own } = this;
    return this.set(
      edges.filter((e) => own[e]),
      0,
    );
  }

  /**
   * The seam through an edge, from junction to junction. Seams that were only added to get disks do
   * not end others.
   */
  run(edge: number): number[] {
    return seamRun(this.graph, this.own[edge] ? this.own : this.all, edge);
  }

  setSources(sources: SeamSources): void {
    this.change({ sources, edges: null });
  }

  setEdges(edges: Uint32Array): void {
    this.change({ sources: this.choice.sources, edges });
  }

  /** Adds automatic seams to those asked for. */
  cutFurther(): void {
    const { sources, edges } = this.choice;
    this.change(
      edges
        ? { sources, edges, isCutFurther: true }
        : { sources: { ...sources, auto: true }, edges },
    );
  }

  undo(): boolean {
    this.forget();
    return this.history.undo();
  }

  redo(): boolean {
    this.forget();
    return this.history.redo();
  }

  private get shown(): EdgeFlags | null {
    if (this.shownPairs) this.shownFlags ??= flagsOf(this.graph, this.shownPairs);
    return this.shownFlags;
  }

  private set(edges: number[], value: 0 | 1): number {
    if (edges.length === 0) return 0;
    const flags = this.own.slice();
    for (const edge of edges) flags[edge] = value;
    this.setEdges(pairsOf(this.graph, flags));
    return edges.length;
  }

  private change(choice: SeamChoice): void {
    this.forget();
    this.history.change(choice);
  }

  private forget(): void {
    this.wanted = null;
    this.both = null;
  }
}

function either(a: EdgeFlags, b: EdgeFlags): EdgeFlags {
  const flags = a.slice();
  for (let edge = 0; edge < flags.length; ++edge) flags[edge] |= b[edge];
  return flags;
}
