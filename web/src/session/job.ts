/** Runs one long task at a time, which can be stopped. */
export class Job {
  private controller: AbortController | null = null;

  /** `changed` is called when the task begins and when it has ended. */
  constructor(private readonly changed: (isRunning: boolean) => void) {}

  get isRunning(): boolean {
    return this.controller !== null;
  }

  /** Resolves when the task has ended; being stopped is not an error. */
  async start(task: (signal: AbortSignal) => Promise<void>): Promise<void> {
    this.stop();
    const controller = new AbortController();
    this.controller = controller;
    this.changed(true);
    try {
      await task(controller.signal);
    } catch (error) {
      if (!controller.signal.aborted) throw error;
    } finally {
      if (this.controller === controller) this.end();
    }
  }

  stop(): void {
    if (!this.controller) return;
    this.controller.abort();
    this.end();
  }

  private end(): void {
    this.controller = null;
    this.changed(false);
  }
}
