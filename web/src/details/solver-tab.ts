import type { ChartReport } from 'abflat';
import { create, element } from '../base/dom';
import { SOLVER, SOLVERS } from '../words/details';
import { LateChart } from './late-chart';
import { notes } from './notes';

const NAMES: Record<string, string> = SOLVERS;

/** How the layout was found: notes and the solver's convergence. */
export class SolverTab {
  private readonly notes = element('notes', HTMLUListElement);
  private readonly summary = element('solver-summary', HTMLElement);
  private readonly plots = element('solver-plots', HTMLElement);
  private readonly readout = element('solver-readout', HTMLElement);
  private readonly residuals: LateChart;
  private readonly activeSet: LateChart;

  constructor() {
    const read = (text: string | null) => {
      this.readout.textContent = text ?? SOLVER.hint;
    };
    read(null);
    this.residuals = new LateChart(element('residual-chart', HTMLElement), 132, read);
    this.activeSet = new LateChart(element('active-chart', HTMLElement), 92, read);
  }

  show(chart: ChartReport): void {
    const { history } = chart;
    this.notes.replaceChildren(...notes(chart).map((note) => create('li', '', note)));
    this.notes.hidden = this.notes.childElementCount === 0;
    this.summary.textContent = summary(chart);
    this.plots.hidden = history.length === 0;
    if (history.length === 0) return;
    this.residuals.show(({ residualChart }) => residualChart(history));
    this.activeSet.show(({ activeSetChart }) => activeSetChart(history));
  }

  /** There is no layout. */
  clear(): void {
    this.notes.hidden = true;
    this.summary.textContent = '';
    this.plots.hidden = true;
  }
}

function summary({ solver, iterations, converged, constraintResidual }: ChartReport): string {
  const name = NAMES[solver] ?? solver;
  if (iterations === 0) return name;
  return SOLVER.summary(name, iterations, converged, constraintResidual);
}
