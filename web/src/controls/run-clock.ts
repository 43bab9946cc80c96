/** Milliseconds of a run before which nothing can be said of its end. */
const SETTLED = 2000;

/** A run that has done so much of its work has come to its end. */
const DONE = 0.9;

/** The share of a run's time that has passed when it has done a share of its work. */
export type Pace = (work: number) => number;

/** What is expected of a run of which nothing is known. */
const EVEN: Pace = (work) => work;

/** How much of its time a run has taken, and what is left. */
export class RunClock {
  private readonly start: number;
  private passed = 0;
  /** What was done, and the milliseconds when it was. */
  private readonly reports: [work: number, time: number][] = [[0, 0]];

  /** `expected`: of an earlier run that was like this. */
  constructor(
    private readonly expected: Pace = EVEN,
    private readonly now: () => number = () => performance.now(),
  ) {
    this.start = now();
  }

  /** `work`: the share that abflat has done. `left`: seconds; null while that is not known. */
  at(work: number): { passed: number; left: number | null } {
    const elapsed = this.now() - this.start;
    if (work > this.reports[this.reports.length - 1][0]) this.reports.push([work, elapsed]);
    // A bar does not go back.
    this.passed = Math.max(this.passed, this.expected(work));
    const isKnown = elapsed >= SETTLED && this.passed > 0;
    const left = isKnown ? rounded((elapsed * (1 / this.passed - 1)) / 1000) : null;
    return { passed: this.passed, left };
  }

  /** How this run went, now that it has ended; null if it did not come to its end. */
  pace(): Pace | null {
    const total = this.now() - this.start;
    if (this.reports[this.reports.length - 1][0] < DONE || total <= 0) return null;
    const reports = [...this.reports, [1, total]];
    return (work) => {
      const next = Math.max(
        1,
        reports.findIndex(([then]) => then >= work),
      );
      const [[w0, t0], [w1, t1]] = [reports[next - 1], reports[next]];
      const share = w1 > w0 ? (work - w0) / (w1 - w0) : 1;
      return (t0 + share * (t1 - t0)) / total;
    };
  }
}

/** Fewer digits the more it is, so that it does not flicker. */
function rounded(seconds: number): number {
  const step = seconds < 10 ? 1 : 5;
  return Math.max(1, step * Math.round(seconds / step));
}
