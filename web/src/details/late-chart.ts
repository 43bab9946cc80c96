import { loadPart, reasonOf } from '../base/load-part';
import type { Chart } from '../plot/chart';
import type { ChartSpec } from '../plot/chart-spec';

export const plots = () => loadPart(import('./plots'));
type Plots = Awaited<ReturnType<typeof plots>>;

/** A chart that is drawn as soon as what draws it is there. */
export class LateChart {
  private chart: Chart | null = null;
  private specOf: ((plots: Plots) => ChartSpec) | null = null;

  /** As of `Chart`; `read` also gets why nothing can be drawn. */
  constructor(
    private readonly figure: HTMLElement,
    private readonly height: number,
    private readonly read: (text: string | null) => void,
  ) {
    // Its place, so that nothing moves when it comes.
    figure.classList.add('chart');
    figure.style.minHeight = `${height}px`;
  }

  show(specOf: (plots: Plots) => ChartSpec): void {
    this.specOf = specOf;
    plots().then(
      (loaded) => {
        if (this.specOf !== specOf) return;
        this.chart ??= new loaded.Chart(this.figure, this.height, this.read);
        this.chart.show(specOf(loaded));
      },
      (error: Error) => this.read(reasonOf(error)),
    );
  }
}
