import type { NearbyPaths } from '../surface/nearby-paths';
import { NO_MARKS, type SeamMarks } from '../view/seam-overlay';
import type { Pixel, Sight } from '../view/sight';
import { SEAMS } from '../words/seams';
import { edgesUnder, withinReach } from './brush';
import type { SeamModel } from './seam-model';
import { endsOf, placeAt, type Targets } from './seam-targets';
import { Trail } from './trail';

/** So many take only a few milliseconds, and reach far. */
const MOST_PLACES = 1 << 13;

/** Seams that are drawn by one drag, and changed at its end. */
export interface SeamStroke {
  readonly marks: SeamMarks;
  readonly hint: string;
  /** Goes on along these pixels. */
  follow(along: Pixel[], sight: Sight): void;
  /** Returns how many edges it has changed. */
  finish(): number;
  /** What it has done. */
  text(count: number): string;
}

/** Cuts along edges. */
export class CutStroke implements SeamStroke {
  private readonly trail: Trail;

  constructor(
    private readonly model: SeamModel,
    private readonly targets: Targets,
    private readonly paths: NearbyPaths,
    start: number,
  ) {
    this.trail = new Trail(model.graph, start);
  }

  get marks(): SeamMarks {
    const { model, trail } = this;
    const cut = endsOf(model.graph, model.alike(trail.edges));
    return { ...NO_MARKS, cut, vertices: Uint32Array.of(trail.places[0], trail.end) };
  }

  get hint(): string {
    return SEAMS.painting(new Set(this.trail.edges).size);
  }

  /** As far as that is quick: the rest may come nearer later. */
  follow(along: Pixel[], sight: Sight): void {
    const { trail, targets, model } = this;
    // It meets itself where it comes near, so that it can close a loop, and go back.
    const wanted = [...targets.places, ...trail.places];
    const near = withinReach(model.surface.solid, sight, along, wanted);
    const known = trail.places.length;
    let left = MOST_PLACES;
    for (const at of along) {
      const place = placeAt(model.surface, sight, at, [...near, ...trail.places.slice(known)]);
      if (place < 0 || place === trail.end) continue;
      const path = this.paths.between(trail.end, place, left);
      if (!path) return;
      trail.follow(path);
      left -= this.paths.reached;
    }
  }

  finish(): number {
    return this.model.cut([...new Set(this.trail.edges)]);
  }

  text(count: number): string {
    return count > 0 ? SEAMS.painted(count) : SEAMS.nothingPainted;
  }
}

/** Joins each edge that it goes over. */
export class JoinStroke implements SeamStroke {
  private readonly met = new Set<number>();

  constructor(
    private readonly model: SeamModel,
    private readonly targets: Targets,
  ) {}

  get marks(): SeamMarks {
    return { ...NO_MARKS, joined: endsOf(this.model.graph, this.model.alike(this.own)) };
  }

  get hint(): string {
    const { size } = this.met;
    const { length } = this.own;
    return length === 0 && size > 0 ? SEAMS.neededHere(size) : SEAMS.erasing(length);
  }

  follow(along: Pixel[], sight: Sight): void {
    const { graph, surface } = this.model;
    for (const at of along)
      for (const edge of edgesUnder(surface.solid, sight, at, graph.ends, this.targets.seams))
        this.met.add(edge);
  }

  finish(): number {
    return this.model.join([...this.met]);
  }

  text(count: number): string {
    if (count > 0) return SEAMS.erased(count);
    return this.met.size > 0 ? SEAMS.needed : SEAMS.nothingErased;
  }

  /** The others are needed. */
  private get own(): number[] {
    const { own } = this.model;
    return [...this.met].filter((edge) => own[edge]);
  }
}
