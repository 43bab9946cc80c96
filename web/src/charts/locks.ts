import type { UnwrapReport, UnwrapResult } from 'abflat';
import type { Unwrapped } from '../lay-out';

/** Charts that are to stay where they are. */
export interface Kept {
  layout: UnwrapResult;
  charts: Uint32Array;
}

/** Which charts are locked, across the atlases of one mesh. */
export class Locks {
  private shown: UnwrapResult | null = null;
  private wish: Kept | undefined;

  /** What the next run is to keep; another object after every change. */
  get kept(): Kept | undefined {
    return this.wish;
  }

  /** Of the atlas on screen. */
  get charts(): Set<number> {
    if (!this.shown) return new Set();
    const isCurrent = this.wish?.layout === this.shown;
    return new Set(isCurrent ? this.wish?.charts : fixedCharts(this.shown.report));
  }

  clear(): void {
    this.shown = null;
    this.wish = undefined;
  }

  show({ result, settings }: Unwrapped): void {
    this.shown = result;
    // Otherwise the user has locked or unlocked meanwhile, which a further run will follow.
    if (settings.kept === this.wish)
      this.wish = { layout: result, charts: fixedCharts(result.report) };
  }

  toggle(chart: number): void {
    if (!this.shown) return;
    const { charts } = this;
    if (!charts.delete(chart)) charts.add(chart);
    this.wish = { layout: this.shown, charts: Uint32Array.from(charts) };
  }
}

function fixedCharts({ charts }: UnwrapReport): Uint32Array {
  return Uint32Array.from(charts.flatMap(({ fixed }, i) => (fixed ? [i] : [])));
}
