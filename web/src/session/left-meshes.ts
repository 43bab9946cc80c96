import { buffersOf } from '../base/buffers';
import type { Opened, Outcome, Source } from '../model/model';
import type { Settings } from '../model/settings';
import type { Step, StepList } from './steps';

/** A mesh as it was when another one was shown in its place. */
export interface Left {
  opened: Omit<Opened, 'drawing'>;
  /** Its last outcome, which the next run takes over what it can from. */
  outcome: Outcome | null;
  history: StepList;
  /** What was asked for: of the other kind of layout, then of the one that was chosen. */
  settings: Settings[];
}

/** What was asked for last, and what came of it. */
export const currentStep = ({ history: { steps, at } }: Left): Step => steps[at];

/** Bytes of all results in the histories of meshes that are not shown: three of a million triangles. */
const MOST_BYTES = 2 ** 28;

/** The meshes that are open but not shown, each as it was left. */
export class LeftMeshes {
  /** The one that was left last is the last one. */
  private readonly all = new Map<Source, Left>();

  get(source: Source): Left | undefined {
    return this.all.get(source);
  }

  leave({ opened, ...rest }: Left & { opened: Opened }): void {
    const { drawing: _, ...read } = opened;
    this.all.delete(read.source);
    this.all.set(read.source, { opened: read, ...rest });
    this.forget();
  }

  /** It is shown again, or closed. */
  drop(source: Source): void {
    this.all.delete(source);
  }

  /**
   * Drops the results of earlier steps that do not fit into memory, those of the mesh that was left
   * longest ago first. What a mesh is shown with again is kept.
   */
  private forget(): void {
    const kept = new Set<ArrayBuffer>();
    let bytes = 0;
    for (const { history, outcome } of [...this.all.values()].reverse())
      for (const [i, step] of nearest(history)) {
        if (!step.outcome) continue;
        const own = buffersOf(step.outcome.result).filter((buffer) => !kept.has(buffer));
        const size = own.reduce((sum, { byteLength }) => sum + byteLength, 0);
        const isNeeded = i === history.at || step.outcome === outcome;
        if (!isNeeded && bytes + size > MOST_BYTES) step.outcome = null;
        else {
          for (const buffer of own) kept.add(buffer);
          bytes += size;
        }
      }
  }
}

/** Steps with their numbers, those nearest to the current one first. */
const nearest = ({ steps, at }: StepList) =>
  [...steps.entries()].sort(([a], [b]) => Math.abs(a - at) - Math.abs(b - at));
