import { reasonOf } from '../base/load-part';
import { Job } from '../session/job';
import { GATHERING } from '../words/opening';

export interface GatherEvents {
  /** Files are being gathered: how much of them is there, from 0 to 1, and what to say. */
  gathering(fraction: number, text: string): void;
  /** Nothing is gathered any more; `text` says how it ended. */
  gathered(text: string): void;
  files(files: File[]): void;
  refused(reason: string): void;
}

export interface Gathered {
  /** Of what will be opened, for people. */
  name: string;
  /** What is being done. */
  doing: string;
  task(signal: AbortSignal): Promise<File[]>;
}

/** Files that take time to get, before they are opened. One set at a time; the latest one wins. */
export class Gathering {
  private readonly job = new Job(() => undefined);

  constructor(private readonly events: GatherEvents) {}

  start({ name, doing, task }: Gathered): void {
    let files: File[] = [];
    this.job
      .start(async (signal) => {
        this.events.gathering(0, doing);
        files = await task(signal);
      })
      .then(() => {
        if (files.length === 0) return; // it was stopped
        this.events.gathered(GATHERING.got(name));
        this.events.files(files);
      })
      .catch((error: Error) => {
        this.events.gathered(GATHERING.notOpened(name));
        this.events.refused(reasonOf(error));
      });
  }

  /** Shows how much of the current set is there. */
  progress(fraction: number, text: string): void {
    if (this.job.isRunning) this.events.gathering(fraction, text);
  }

  /** Returns whether there was anything to stop. */
  stop(): boolean {
    if (!this.job.isRunning) return false;
    this.job.stop();
    this.events.gathered(GATHERING.cancelled);
    return true;
  }
}
