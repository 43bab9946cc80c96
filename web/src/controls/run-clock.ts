/** Milliseconds of a run before which nothing can be said of its end. */
const SETTLED = 2000;

/** Where in the work that abflat reports a surface is first flat, and is packed. */
const FLAT = 0.76;
const PACKING = 0.88;
/** The share of the time that has passed where packing begins. */
const BEFORE_PACKING = 0.94;

/** Unwrapping tries more seams after the first, which the work that it reports says nothing about. */
export interface Search {
  /** How many times as long that takes. */
  times: number;
  isSure: boolean;
}

export const usualSearch = (triangles: number): Search => {
  if (triangles <= 20_000) return { times: 5, isSure: true };
  // Then only what has a front is searched, such as a head.
  if (triangles <= 120_000) return { times: 2.5, isSure: false };
  return { times: 1.2, isSure: true };
};

/** How much of its time a run has taken, and what is left. */
export class RunClock {
  private readonly start: number;
  private passed = 0;
  private work = 0;
  /** When the work last grew before packing. */
  private grown = 0;
  private isPacking = false;

  /** `search`: as of usualSearch; null: the work goes on evenly. */
  constructor(
    public search: Search | null,
    private readonly now: () => number = () => performance.now(),
  ) {
    this.start = now();
  }

  /** `work`: the share that abflat has done. `left`: seconds; null while that is not known. */
  at(work: number): { passed: number; left: number | null } {
    const elapsed = this.now() - this.start;
    const share = this.search === null ? work : this.searching(work, elapsed, this.search.times);
    // A bar does not go back.
    this.passed = Math.max(this.passed, share);
    const isSure = this.isPacking || (this.search?.isSure !== false && share < BEFORE_PACKING);
    const isKnown = isSure && elapsed >= SETTLED && share > 0;
    const left = isKnown ? rounded((elapsed * (1 / this.passed - 1)) / 1000) : null;
    return { passed: this.passed, left };
  }

  private searching(work: number, elapsed: number, times: number): number {
    if (work >= PACKING) {
      // The next run on this mesh takes as long.
      if (!this.isPacking && this.grown > 0)
        this.search = { times: elapsed / this.grown, isSure: true };
      this.isPacking = true;
      return BEFORE_PACKING + ((work - PACKING) / (1 - PACKING)) * (1 - BEFORE_PACKING);
    }
    if (work > this.work) {
      this.work = work;
      this.grown = elapsed;
    }
    const first = Math.min(1, this.work / FLAT);
    const expected = first > 0 ? (times * this.grown) / first : Infinity;
    return BEFORE_PACKING * Math.min(1, elapsed / expected);
  }
}

/** Fewer digits the more it is, so that it does not flicker. */
function rounded(seconds: number): number {
  const step = seconds < 10 ? 1 : 5;
  return Math.max(1, step * Math.round(seconds / step));
}
