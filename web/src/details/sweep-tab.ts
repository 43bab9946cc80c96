import type { Report } from 'abflat';
import { element } from '../base/dom';
import type { FlattenSettings } from '../model/settings';
import { Job } from '../session/job';
import { SWEEP, TAB_JOBS } from '../words/details';
import type { Bound } from '../words/format';
import { LateChart, plots } from './late-chart';
import type { SweepPoint } from './sweep-chart';

type PlottedSettings = Pick<FlattenSettings, 'balance' | 'delaunay' | 'bounds'>;

/** Distortion over t, point by point. */
export class SweepTab {
  private readonly button = element('sweep', HTMLButtonElement);
  private readonly text = element('sweep-text', HTMLElement);
  private readonly readout = element('sweep-readout', HTMLElement);
  private readonly chart: LateChart;
  private isOffered = false;
  private readonly job = new Job((isRunning) => {
    this.button.textContent = isRunning ? TAB_JOBS.stop : SWEEP.start;
  });
  private points: SweepPoint[] = [];
  private plotted: PlottedSettings | null = null;
  private current = 2;

  /**
   * `measure` flattens with one t and resolves to null if that is infeasible; `choose` is called
   * with the t of a point.
   */
  constructor(
    private readonly measure: (t: Bound, signal: AbortSignal) => Promise<Report | null>,
    private readonly choose: (t: Bound) => void,
  ) {
    this.chart = new LateChart(element('sweep-chart', HTMLElement), 212, (text) => {
      this.readout.textContent = text ?? (this.points.length > 0 ? SWEEP.hint : '');
    });
    this.button.addEventListener('click', () => {
      if (!this.stop()) void this.run();
    });
  }

  /** The tab can be chosen from now on; before that, nothing is drawn. */
  offer(): void {
    if (this.isOffered) return;
    this.isOffered = true;
    this.draw();
  }

  /** The t of the layout on screen. */
  setCurrent(t: number): void {
    this.current = t;
    this.draw();
  }

  /** The other settings of points; without points for these, the plot is empty. */
  use({ balance, delaunay, bounds }: PlottedSettings): void {
    const { plotted } = this;
    const isSame = balance === plotted?.balance && delaunay === plotted.delaunay;
    this.plotted = { balance, delaunay, bounds };
    if (!isSame || bounds !== plotted?.bounds) this.clear();
  }

  /** Resets for another mesh. */
  clear(): void {
    this.job.stop();
    this.points = [];
    this.text.textContent = '';
    this.draw();
  }

  /** Returns whether there was anything to stop. */
  stop(): boolean {
    if (!this.job.isRunning) return false;
    this.job.stop();
    this.text.textContent = TAB_JOBS.stopped;
    return true;
  }

  private async run(): Promise<void> {
    this.points = [];
    this.draw();
    try {
      await this.job.start((signal) => this.sweep(signal));
    } catch (error) {
      this.text.textContent = error instanceof Error ? error.message : String(error);
    }
  }

  private async sweep(signal: AbortSignal): Promise<void> {
    const { SWEEP_T } = await plots();
    signal.throwIfAborted();
    for (const [i, t] of SWEEP_T.entries()) {
      this.text.textContent = SWEEP.progress(i + 1, SWEEP_T.length);
      const report = await this.measure(t, signal);
      signal.throwIfAborted();
      this.points.push({ t, chart: report?.charts[0] ?? null });
      this.draw();
    }
    const skipped = this.points.filter(({ chart }) => !chart).map(({ t }) => t);
    this.text.textContent = skipped.length > 0 ? SWEEP.skipped(skipped) : '';
  }

  private draw(): void {
    if (!this.readout.textContent && this.points.length > 0) this.readout.textContent = SWEEP.hint;
    if (this.points.length === 0) this.readout.textContent = '';
    if (!this.isOffered) return;
    const { points, current } = this;
    this.chart.show(({ sweepChart }) => sweepChart(points, current, this.choose));
  }
}
