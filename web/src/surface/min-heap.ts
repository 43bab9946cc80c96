/**
 * A binary heap of the numbers 0 to `size` - 1, each at most once; the one with the smallest key
 * comes first.
 */
export class MinHeap {
  private readonly items: Uint32Array;
  private readonly keys: Float64Array;
  /** One more than the index of each item; 0: not in the heap. */
  private readonly at: Uint32Array;
  private count = 0;

  constructor(size: number) {
    this.items = new Uint32Array(size);
    this.keys = new Float64Array(size);
    this.at = new Uint32Array(size);
  }

  /** Adds an item, or lowers its key. */
  add(item: number, key: number): void {
    this.keys[item] = key;
    this.rise(this.at[item] > 0 ? this.at[item] - 1 : this.count++, item);
  }

  /** Takes as long as there are items, however many there could be. */
  clear(): void {
    for (; this.count > 0; --this.count) this.at[this.items[this.count - 1]] = 0;
  }

  take(): number | undefined {
    if (this.count === 0) return undefined;
    const first = this.items[0];
    this.at[first] = 0;
    this.count -= 1;
    if (this.count > 0) this.sink(this.items[this.count]);
    return first;
  }

  private put(index: number, item: number): void {
    this.items[index] = item;
    this.at[item] = index + 1;
  }

  private rise(from: number, item: number): void {
    let i = from;
    while (i > 0) {
      const parent = (i - 1) >> 1;
      if (this.keys[this.items[parent]] <= this.keys[item]) break;
      this.put(i, this.items[parent]);
      i = parent;
    }
    this.put(i, item);
  }

  /** Moves an item down from the root. */
  private sink(item: number): void {
    let i = 0;
    for (;;) {
      let child = 2 * i + 1;
      if (child >= this.count) break;
      const right = child + 1;
      if (right < this.count && this.keys[this.items[right]] < this.keys[this.items[child]])
        child = right;
      if (this.keys[this.items[child]] >= this.keys[item]) break;
      this.put(i, this.items[child]);
      i = child;
    }
    this.put(i, item);
  }
}
