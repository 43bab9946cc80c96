import type { CompareProgress, Comparison, MethodResult } from 'abflat';
import { element } from '../base/dom';
import { loadPart } from '../base/load-part';
import { Job } from '../session/job';
import { METHODS, TAB_JOBS } from '../words/details';

export const methodTables = () => loadPart(import('./method-table'));

export type Compare = (
  signal: AbortSignal,
  onProgress: (progress: CompareProgress) => void,
) => Promise<Comparison>;

/** The mesh flattened by other methods; one of them at a time can be shown. */
export class MethodsTab {
  private readonly button = element('compare', HTMLButtonElement);
  private readonly text = element('compare-text', HTMLElement);
  private readonly results = element('methods', HTMLElement);
  private readonly problem = element('method-problem', HTMLElement);
  private readonly job = new Job((isRunning) => {
    this.button.textContent = isRunning ? TAB_JOBS.stop : METHODS.start;
  });
  private comparison: Comparison | null = null;
  private selected: MethodResult | null = null;

  /** `show` is called with the method to show, or null for the page's own result. */
  constructor(
    private readonly compare: Compare,
    private readonly show: (method: MethodResult | null, comparison: Comparison) => void,
  ) {
    this.button.addEventListener('click', () => {
      if (!this.stop()) void this.run();
    });
  }

  /** Goes back to the page's own result. Returns whether anything else was shown. */
  leave(): boolean {
    if (!this.selected) return false;
    this.select(null);
    return true;
  }

  /** Resets for another mesh. */
  clear(): void {
    this.job.stop();
    this.comparison = null;
    this.selected = null;
    this.text.textContent = '';
    this.problem.textContent = '';
    this.results.replaceChildren();
  }

  /** Returns whether there was anything to stop. */
  stop(): boolean {
    if (!this.job.isRunning) return false;
    this.job.stop();
    this.text.textContent = TAB_JOBS.stopped;
    return true;
  }

  private async run(): Promise<void> {
    this.leave();
    this.text.textContent = TAB_JOBS.starting;
    try {
      await this.job.start(async (signal) => {
        const comparison = await this.compare(signal, ({ fraction }) => {
          if (!signal.aborted) this.text.textContent = METHODS.progress(fraction);
        });
        const { methodTable } = await methodTables();
        signal.throwIfAborted();
        this.comparison = comparison;
        this.text.textContent = '';
        this.problem.textContent = '';
        const table = methodTable(comparison.methods, (method) =>
          this.select(method === this.selected ? null : method),
        );
        this.results.replaceChildren(table);
      });
    } catch (error) {
      this.text.textContent = error instanceof Error ? error.message : String(error);
    }
  }

  private select(method: MethodResult | null): void {
    if (!this.comparison) return;
    this.selected = method;
    this.results.querySelectorAll('button').forEach((button, i) => {
      button.ariaPressed = String(this.comparison?.methods[i] === method);
    });
    this.problem.textContent = method?.problem ?? '';
    this.show(method, this.comparison);
  }
}
