// Writes to and reads from the memory of a WebAssembly module. Addresses are as the module returns
// them.

/** Thrown through the module by its allocator. */
export class OutOfMemory extends Error {}

export class Heap {
  /** The most bytes that it may grow to. */
  readonly maxBytes: number;
  readonly #memory: WebAssembly.Memory;

  constructor(memory: WebAssembly.Memory, maxBytes: number) {
    this.#memory = memory;
    this.maxBytes = maxBytes;
  }

  get bytes(): number {
    return this.#memory.buffer.byteLength;
  }

  writeBytes(address: number, values: Uint8Array | Uint8ClampedArray): void {
    new Uint8Array(this.#memory.buffer, address >>> 0, values.length).set(values);
  }

  writeNumbers(address: number, values: ArrayLike<number>): void {
    new Uint32Array(this.#memory.buffer, address >>> 0, values.length).set(values);
  }

  writeReals(address: number, values: Float32Array | Float64Array): void {
    new Float64Array(this.#memory.buffer, address >>> 0, values.length).set(values);
  }

  /** As numbers of single precision. */
  writeFloats(address: number, values: Float32Array | Float64Array): void {
    new Float32Array(this.#memory.buffer, address >>> 0, values.length).set(values);
  }

  readString(address: number): string {
    return readString(this.#memory, address);
  }

  /** `bytes` is as the module returns it. Shared memory can be neither transferred nor decoded, but its copy can. */
  copy(address: number, bytes: number): ArrayBuffer {
    try {
      return new Uint8Array(this.#memory.buffer, address >>> 0, bytes >>> 0).slice().buffer;
    } catch (error) {
      throw error instanceof RangeError ? new OutOfMemory() : error;
    }
  }

  /** Sizes beyond 32 bits must not reach the module. */
  checkBytes(bytes: number): void {
    if (bytes >= this.maxBytes) throw new OutOfMemory();
  }
}

/** Reads a zero-terminated string. */
export function readString(memory: WebAssembly.Memory, address: number): string {
  const bytes = new Uint8Array(memory.buffer, address >>> 0);
  return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
}
