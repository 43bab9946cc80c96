import { loadPart } from '../base/load-part';
import { Job } from '../session/job';
import type { Session } from '../session/session';
import { writeAgain } from '../session/write-again';
import { EXPORT } from '../words/export';
import type { Workshop } from '../workshop/workshop';
import type { ExportRequest } from './export-mesh';

export const exportMeshes = () => loadPart(import('./export-mesh'));

export interface ExporterEvents {
  say(text: string): void;
  /** A file has the layout. */
  exported(request: ExportRequest): void;
  failed(request: ExportRequest, error: Error): void;
}

/** Exports one file at a time. A file that abflat has to write first waits for the run in flight. */
export class Exporter {
  private readonly job = new Job(() => undefined);

  constructor(
    private readonly session: Session,
    private readonly workshop: Workshop,
    private readonly events: ExporterEvents,
  ) {}

  /** `remark`: what is to be said of it besides. */
  export(request: ExportRequest, remark: string): void {
    this.job
      .start(async (signal) => {
        const { exportMesh } = await exportMeshes();
        const done = await exportMesh(request, {
          workshop: this.workshop,
          again: (outcome, format) => {
            this.events.say(EXPORT.writing(format.toUpperCase()));
            return this.session.aside(
              (abflat, input, signal) =>
                writeAgain(abflat, input, outcome, format, this.workshop, signal),
              signal,
            );
          },
        });
        if (signal.aborted) return;
        this.events.exported(request);
        this.events.say(remark ? `${done}. ${remark}` : done);
      })
      .catch((error: Error) => {
        this.events.say(EXPORT.notExported);
        this.events.failed(request, error);
      });
  }

  /** Returns whether there was anything to stop. */
  stop(): boolean {
    if (!this.job.isRunning) return false;
    this.job.stop();
    this.events.say(EXPORT.cancelled);
    return true;
  }
}
