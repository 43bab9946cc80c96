import type { UnwrapResult } from 'abflat';
import type { Unwrapped } from '../model/model';
import type { Kept } from '../model/settings';

/** Which charts are locked, across the atlases of one mesh. */
export class Locks {
  private shown: UnwrapResult | null = null;
  /** Charts of the atlas on screen that were locked when it was made. */
  private locked: Uint32Array = new Uint32Array();
  /** Charts of the atlas on screen that have the uv of the file. */
  private ofFile: ReadonlySet<number> = new Set();
  private asked: Kept | undefined;

  /** The charts that the next run must keep; a new object after every change. */
  get kept(): Kept | undefined {
    return this.asked;
  }

  /** The locked charts of the atlas on screen. */
  get charts(): Set<number> {
    if (!this.shown) return new Set();
    const isCurrent = this.asked?.layout === this.shown;
    return new Set(isCurrent ? this.asked?.charts : this.locked);
  }

  /** Charts of the atlas on screen that nothing can move while the uv of the file are kept. */
  get keptUvs(): ReadonlySet<number> {
    return this.ofFile;
  }

  /** All charts of the atlas on screen that stay where they are. */
  get staying(): ReadonlySet<number> {
    return new Set([...this.charts, ...this.ofFile]);
  }

  clear(): void {
    this.shown = null;
    this.ofFile = new Set();
    this.asked = undefined;
  }

  /** Takes back or repeats what was locked. */
  restore(kept: Kept | undefined): void {
    this.asked = kept;
  }

  show({ result, settings }: Unwrapped): void {
    this.shown = result;
    this.locked = lockedCharts(result, settings.kept);
    this.ofFile = settings.fixedFaces ? chartsOfFile(result, this.locked) : new Set();
    // Otherwise the user has locked or unlocked charts in the meantime, and another run will
    // follow.
    if (settings.kept === this.asked) this.asked = { layout: result, charts: this.locked };
  }

  toggle(chart: number): void {
    if (!this.shown || this.ofFile.has(chart)) return;
    const { charts } = this;
    if (!charts.delete(chart)) charts.add(chart);
    this.asked = { layout: this.shown, charts: Uint32Array.from(charts) };
  }
}

/**
 * The locked charts in the new atlas: fixed charts that contain triangles of theirs. Other charts
 * are fixed because the file has uv for them.
 */
function lockedCharts({ report, chartOfTriangle }: UnwrapResult, kept?: Kept): Uint32Array {
  const before = new Set(kept?.charts);
  const locked = new Set<number>();
  if (kept && before.size > 0)
    chartOfTriangle.forEach((chart, triangle) => {
      if (before.has(kept.layout.chartOfTriangle[triangle]) && report.charts[chart]?.fixed)
        locked.add(chart);
    });
  return Uint32Array.from(locked);
}

/** Charts that are where they are for no other reason than that the file has them there. */
function chartsOfFile({ report }: UnwrapResult, locked: Uint32Array): Set<number> {
  const given = report.charts.flatMap(({ solver }, chart) => (solver === 'given' ? chart : []));
  return new Set(given.filter((chart) => !locked.includes(chart)));
}
