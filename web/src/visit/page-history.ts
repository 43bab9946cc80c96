import { StepButtons } from '../controls/step-buttons';
import { HistoryTab } from '../details/history-tab';
import type { Outcome } from '../model/model';
import type { Settings } from '../model/settings';
import { type Step, type StepList, Steps } from '../session/steps';
import { CHANGES } from '../words/run';

/** Undo, redo and the list of all steps. `restore` is called with a step to go back to, and what to say. */
export class PageHistory {
  private readonly steps = new Steps(() => this.show());
  private readonly buttons = new StepButtons({
    undo: () => this.goTo(this.steps.current - 1),
    redo: () => this.goTo(this.steps.current + 1),
  });
  private readonly tab = new HistoryTab((step) => this.goTo(step));

  constructor(private readonly restore: (step: Step, said: string) => void) {}

  /** Another mesh was opened. */
  begin(text: string, settings: Settings): void {
    this.steps.begin(text, settings);
  }

  /** To go on with when the mesh is shown again. */
  get list(): StepList {
    return this.steps.list;
  }

  /** A mesh is shown again; returns its current step. */
  resume(list: StepList): Step {
    this.steps.resume(list);
    return list.steps[list.at];
  }

  /** The user wants something else; `what`, if the settings do not say so. */
  change(settings: Settings, what?: string): void {
    this.steps.change(settings, what);
  }

  /** The current step has a result. */
  settle(outcome: Outcome): void {
    this.steps.settle(outcome);
  }

  /** What came last of these settings; null if nothing that is still there. */
  resultOf(settings: Settings): Outcome | null {
    return this.steps.resultOf(settings);
  }

  /** Undoes or repeats all between the current step and another one. */
  private goTo(to: number): void {
    const { all, current } = this.steps;
    const last = all[Math.max(current, to)];
    const step = this.steps.go(to);
    const said = to < current ? CHANGES.undone : CHANGES.redone;
    if (step) this.restore(step, said(last.text));
  }

  private show(): void {
    const { all, current, canUndo, canRedo } = this.steps;
    this.buttons.show(canUndo ? all[current].text : null, canRedo ? all[current + 1].text : null);
    this.tab.show(all, current);
  }
}
