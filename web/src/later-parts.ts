/** In milliseconds: the user looks at the first layout. */
const DELAY = 2000;

/** What a first layout does not need is loaded once there is one: later the page needs no connection. */
export class LaterParts {
  private isAsked = false;

  constructor(private readonly parts: (() => Promise<unknown>)[]) {}

  load(): void {
    if (this.isAsked) return;
    this.isAsked = true;
    setTimeout(() => {
      // What is missing then is reported when it is needed.
      for (const part of this.parts) part().catch(() => undefined);
    }, DELAY);
  }
}
