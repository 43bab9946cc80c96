import { nextTask } from './next-task';

/** Bytes copied per task. */
const PIECE = 1 << 22;

/** The buffers in a value, including those of its typed arrays, each once. */
export function buffersOf(value: unknown): ArrayBuffer[] {
  const found = new Set<ArrayBuffer>();
  const visit = (each: unknown) => {
    if (ArrayBuffer.isView(each)) found.add(each.buffer as ArrayBuffer);
    else if (each instanceof ArrayBuffer) found.add(each);
    else if (typeof each === 'object' && each !== null) Object.values(each).forEach(visit);
  };
  visit(value);
  return [...found];
}

/**
 * A value whose typed arrays are copies, to be transferred. They are made piece by piece so that
 * the page stays responsive: posting the arrays themselves in a message would copy all of them at
 * once, which takes several times as long.
 */
export async function copied<T>(value: T): Promise<T> {
  if (ArrayBuffer.isView(value)) return (await copyOf(value as unknown as Uint8Array)) as T;
  if (Array.isArray(value)) return value; // no array of arrays is large
  if (!isRecord(value)) return value;
  const copy: Record<string, unknown> = {};
  for (const [name, each] of Object.entries(value)) copy[name] = await copied(each);
  return copy as T;
}

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && Object.getPrototypeOf(value) === Object.prototype;

async function copyOf(array: Uint8Array): Promise<Uint8Array> {
  const copy = new (array.constructor as Uint8ArrayConstructor)(array.length);
  const step = PIECE / array.BYTES_PER_ELEMENT;
  for (let from = 0; from < array.length; from += step) {
    if (from > 0) await nextTask();
    copy.set(array.subarray(from, from + step), from);
  }
  if (array.byteLength > PIECE / 8) await nextTask();
  return copy;
}
