import { buffersOf } from '../base/buffers';
import type { Outcome } from '../model/model';
import { type Settings, sameSettings } from '../model/settings';
import { type Change, changeBetween } from './change';

/** One line of the history: what the user asked for, and what came of it. */
export interface Step {
  text: string;
  settings: Settings;
  /** Null until there is a result, or if it took too much memory to keep. */
  outcome: Outcome | null;
}

/** All steps, and the number of the current one. */
export interface StepList {
  steps: Step[];
  at: number;
}

/** Enough for an afternoon's work. */
const MOST_STEPS = 200;
/** Bytes of all results that are kept, and with those that undo and redo lead to: three of a million triangles. */
const MOST_BYTES = 2 ** 28;
const MOST_BYTES_NEAR = 2 ** 29;
/** In milliseconds: changes of a stream that follow faster belong together. */
const TOGETHER = 1000;

/** Everything the user has asked for since the mesh was opened, with undo and redo. */
export class Steps {
  private steps: Step[] = [];
  private at = -1;
  private stream: string | undefined;
  private changedAt = 0;

  /** `changed` is called whenever there is something else to show. */
  constructor(
    private readonly changed: () => void,
    private readonly now = () => performance.now(),
  ) {}

  get all(): readonly Step[] {
    return this.steps;
  }

  /** The number of the current step; -1 if there is none. */
  get current(): number {
    return this.at;
  }

  /** To go on with later; what is done in between does not change it. */
  get list(): StepList {
    return { steps: this.steps.map((step) => ({ ...step })), at: this.at };
  }

  /** Goes on with another mesh where it was left. */
  resume({ steps, at }: StepList): void {
    this.steps = steps;
    this.at = at;
    this.stream = undefined;
    this.changed();
  }

  get canUndo(): boolean {
    return this.at > 0;
  }

  get canRedo(): boolean {
    return this.at + 1 < this.steps.length;
  }

  /** Starts over with another mesh. */
  begin(text: string, settings: Settings): void {
    this.steps = [{ text, settings, outcome: null }];
    this.at = 0;
    this.stream = undefined;
    this.changed();
  }

  /** The user wants something else; steps that were undone are gone. `text`: what, if not in the settings. */
  change(settings: Settings, text?: string): void {
    const before = this.steps[this.at];
    if (!before) return;
    const change: Change = text ? { text } : changeBetween(before.settings, settings);
    const isMore = this.at > 0 && change.stream !== undefined && this.goesOn(change.stream);
    this.stream = change.stream;
    this.changedAt = this.now();
    const kept = this.steps.slice(0, isMore ? this.at : this.at + 1);
    this.steps = [...kept, { text: change.text, settings, outcome: null }].slice(-MOST_STEPS);
    this.at = this.steps.length - 1;
    this.changed();
  }

  private goesOn(stream: string): boolean {
    const isLast = this.at === this.steps.length - 1;
    const isSoon = this.now() - this.changedAt < TOGETHER || this.steps[this.at].outcome === null;
    return isLast && stream === this.stream && isSoon;
  }

  /** The result of the current step, if these are its settings. */
  settle(outcome: Outcome): void {
    const step = this.steps[this.at];
    if (!step || !sameSettings(step.settings, outcome.settings)) return;
    step.outcome = outcome;
    this.forget();
  }

  /** The result of the last step so far that asked for these settings; null if there is none. */
  resultOf(settings: Settings): Outcome | null {
    const before = this.steps.slice(0, this.at + 1).reverse();
    const step = before.find((step) => step.outcome && sameSettings(step.settings, settings));
    return step?.outcome ?? null;
  }

  /** Makes a step the current one. */
  go(to: number): Step | null {
    const step = this.steps[to];
    if (!step || to === this.at) return null;
    this.at = to;
    this.stream = undefined;
    this.changed();
    return step;
  }

  /** Drops the results that are farthest from the current step and do not fit into memory. */
  private forget(): void {
    const near = this.steps
      .map((step, i) => ({ step, distance: Math.abs(i - this.at) }))
      .sort((a, b) => a.distance - b.distance);
    const kept = new Set<ArrayBuffer>();
    let bytes = 0;
    for (const { step, distance } of near) {
      if (!step.outcome) continue;
      const own = buffersOf(step.outcome.result).filter((buffer) => !kept.has(buffer));
      const size = own.reduce((sum, { byteLength }) => sum + byteLength, 0);
      const most = distance > 1 ? MOST_BYTES : MOST_BYTES_NEAR;
      if (distance > 0 && size > 0 && bytes + size > most) step.outcome = null;
      else {
        for (const buffer of own) kept.add(buffer);
        bytes += size;
      }
    }
  }
}
