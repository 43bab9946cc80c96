import { loadPart } from '../base/load-part';
import { Job } from '../session/job';
import type { Session } from '../session/session';
import { EXPORT } from '../words/export';
import type { Workshop } from '../workshop/workshop';
import type { ExportRequest } from './export-mesh';

export const savingParts = () => loadPart(import('./saving-parts'));

export interface ExporterEvents {
  say(text: string): void;
  /** Something that takes long, and can be stopped, is done in part. */
  progress(fraction: number, what: string): void;
  /** The work whose progress was shown has ended. */
  ended(text: string): void;
  /** What to know about a file that was written. */
  noted(notes: string[]): void;
  /** A file has the layout. */
  exported(request: ExportRequest): void;
  failed(request: ExportRequest, error: Error): void;
}

/** Exports one file at a time. A file that abflat has to write first waits for the run in flight. */
export class Exporter {
  private readonly job = new Job(() => undefined);
  /** Whether progress of the export in flight was shown. */
  private isShown = false;

  constructor(
    private readonly session: Session,
    private readonly workshop: Workshop,
    private readonly events: ExporterEvents,
  ) {}

  /** `remark`: what is to be said of it besides. */
  export(request: ExportRequest, remark: string): void {
    this.job
      .start(async (signal) => {
        const { exportMesh } = await savingParts();
        const { done, notes } = await exportMesh(request, {
          workshop: this.workshop,
          aside: (work) => this.session.aside(work, signal),
          say: (text) => this.events.say(text),
          progress: (fraction, what) => {
            this.isShown = true;
            this.events.progress(fraction, what);
          },
        });
        if (signal.aborted) return;
        this.events.exported(request);
        this.end(remark ? `${done}. ${remark}` : done);
        this.events.noted(notes);
      })
      .catch((error: Error) => {
        this.end(EXPORT.notExported);
        this.events.failed(request, error);
      });
  }

  /** Returns whether there was anything to stop. */
  stop(): boolean {
    if (!this.job.isRunning) return false;
    this.job.stop();
    this.end(EXPORT.cancelled);
    return true;
  }

  private end(text: string): void {
    if (this.isShown) this.events.ended(text);
    else this.events.say(text);
    this.isShown = false;
  }
}
