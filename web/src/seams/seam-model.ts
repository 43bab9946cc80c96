import { edgeLoop } from '../surface/edge-loop';
import type { Solid } from '../surface/solid';
import type { SurfaceGraph } from '../surface/surface-graph';
import { AUTOMATIC, type SeamChoice, type SeamSources, seamWords } from './seam-choice';
import { type EdgeFlags, flagsOf, pairsOf, seamRun } from './seam-edges';

/** What is cut, and where it appears on screen. */
export interface Surface {
  graph: SurfaceGraph;
  solid: Solid;
  /** What finds it under the pointer. */
  aiming: typeof import('./aiming');
}

/** Which edges are cut or joined together. */
export type Symmetry = (graph: SurfaceGraph, edges: number[]) => number[];

/** The seams of one mesh: what the user wants, and what the atlas on screen has. */
export class SeamModel {
  private made: Surface | null = null;
  /** The atlas's seams, two vertices each; null until there is one. */
  private shownPairs: Uint32Array | null = null;
  private shownFlags: EdgeFlags | null = null;
  private wanted: EdgeFlags | null = null;
  private both: EdgeFlags | null = null;
  /** The seams found for choices that leave some to find, two vertices per seam edge. */
  private readonly found = new Map<Uint32Array | string, Uint32Array>();

  /** `findSurface` is called when editing begins; null: there is none yet. `asked`: what to begin with. */
  constructor(
    private readonly findSurface: () => Surface | null,
    private asked: SeamChoice = AUTOMATIC,
    private readonly symmetry: () => Symmetry = () => (_, edges) => edges,
  ) {}

  /** Edges, and those that are to be cut or joined with them. */
  alike(edges: number[]): number[] {
    return this.symmetry()(this.graph, edges);
  }

  /** Whether its seams can be edited. */
  get isReady(): boolean {
    this.made ??= this.findSurface();
    return this.made !== null;
  }

  get surface(): Surface {
    this.made ??= this.findSurface();
    if (!this.made) throw new Error('Seams are edited before there is a surface.');
    return this.made;
  }

  get graph(): SurfaceGraph {
    return this.surface.graph;
  }

  get choice(): SeamChoice {
    return this.asked;
  }

  /**
   * The seams that editing starts from: those asked for, or else those found for the choice, or
   * else those on screen, which may be of an earlier choice.
   */
  get own(): EdgeFlags {
    const { edges, isCutFurther } = this.choice;
    const listed = isCutFurther ? null : edges;
    const pairs = listed ?? this.found.get(nameOf(this.choice)) ?? this.shownPairs;
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
    if (isOfChoice) this.found.set(nameOf(this.choice), pairs);
    this.shownPairs = pairs;
    this.shownFlags = null;
    this.forget();
  }

  /** Returns how many of these edges were not seams before. */
  cut(edges: number[]): number {
    const { own } = this;
    return this.set(
      this.alike(edges).filter((e) => this.graph.isInner[e] && !own[e]),
      1,
    );
  }

  /** Returns how many of these edges were seams before. */
  join(edges: number[]): number {
    const { own } = this;
    return this.set(
      this.alike(edges).filter((e) => own[e]),
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

  /** The edges of the loop through an edge that are not cut yet. */
  loop(edge: number): number[] {
    const { graph, own } = this;
    return edgeLoop(graph, edge).filter((e) => !own[e]);
  }

  /** The edges that bend by more than this and are not cut yet. */
  sharpEdges(degrees: number): number[] {
    const { graph, own } = this;
    const edges: number[] = [];
    graph.bends.forEach((bend, edge) => {
      if (bend > degrees && !own[edge]) edges.push(edge);
    });
    return edges;
  }

  setSources(sources: SeamSources): void {
    this.change({ sources, edges: null });
  }

  setEdges(edges: Uint32Array): void {
    this.change({ sources: this.choice.sources, edges });
  }

  /** Adds automatic seams to those asked for, or to those on screen where they are automatic. */
  cutFurther(): void {
    const { sources, edges } = this.choice;
    const kept = edges ?? (sources.auto ? this.shownPairs : null);
    this.change(
      kept
        ? { sources, edges: kept, isCutFurther: true }
        : { sources: { ...sources, auto: true }, edges },
    );
  }

  /** Takes back or repeats what was chosen. */
  restore(choice: SeamChoice): void {
    this.change(choice);
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
    this.asked = choice;
  }

  private forget(): void {
    this.wanted = null;
    this.both = null;
  }
}

/** What choices with the same seams to find have in common. */
const nameOf = ({ edges, sources }: SeamChoice) => edges ?? seamWords(sources);

function either(a: EdgeFlags, b: EdgeFlags): EdgeFlags {
  const flags = a.slice();
  for (let edge = 0; edge < flags.length; ++edge) flags[edge] |= b[edge];
  return flags;
}
