/**
 * Work that yields to the user's runs: it is aborted when one begins and starts over once that has
 * ended.
 */
export class Background {
  private readonly current = new Set<AbortController>();
  private gate: Promise<void> | null = null;
  private open: () => void = () => undefined;

  pause(): void {
    this.gate ??= new Promise((resolve) => {
      this.open = resolve;
    });
    for (const controller of this.current) controller.abort();
  }

  resume(): void {
    this.gate = null;
    this.open();
  }

  /** Rejects with what `work` rejects with, or when `signal` is aborted. */
  async run<T>(work: (signal: AbortSignal) => Promise<T>, signal: AbortSignal): Promise<T> {
    for (;;) {
      while (this.gate) await this.gate;
      signal.throwIfAborted();
      const controller = new AbortController();
      const stop = () => controller.abort();
      signal.addEventListener('abort', stop);
      this.current.add(controller);
      try {
        return await work(controller.signal);
      } catch (error) {
        if (signal.aborted || !controller.signal.aborted) throw error;
      } finally {
        this.current.delete(controller);
        signal.removeEventListener('abort', stop);
      }
    }
  }
}
