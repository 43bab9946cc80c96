/** Enough for an afternoon's work. */
const MOST = 200;

/** A value that changes, with undo and redo. */
export class History<T> {
  private past: T[] = [];
  private future: T[] = [];

  constructor(private value: T) {}

  get current(): T {
    return this.value;
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  change(value: T): void {
    this.past = [...this.past, this.value].slice(-MOST);
    this.future = [];
    this.value = value;
  }

  /** Returns whether there was anything to undo. */
  undo(): boolean {
    return this.move(this.past, this.future);
  }

  redo(): boolean {
    return this.move(this.future, this.past);
  }

  private move(from: T[], to: T[]): boolean {
    const value = from.pop();
    if (value === undefined) return false;
    to.push(this.value);
    this.value = value;
    return true;
  }
}
