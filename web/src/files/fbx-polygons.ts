// Whether an FBX has faces with more than three corners, of which three.js makes triangles.

import { unzlibSync } from 'fflate';

const NAME = new TextEncoder().encode('PolygonVertexIndex');
/** The type of an array of whole numbers, and the size of what is in front of its values. */
const INTEGERS = 'i'.charCodeAt(0);
const HEAD = 13;
const IN_TEXT = /\bPolygonVertexIndex:\s*\*\d+\s*\{\s*a:([^}]*)\}/g;

export function hasPolygons(bytes: Uint8Array, isBinary: boolean): boolean {
  const lists = isBinary ? inBinary(bytes) : inText(new TextDecoder().decode(bytes));
  for (const corners of lists) if (corners.length > 3 * ends(corners)) return true;
  return false;
}

/** The last corner of each face is negative. */
const ends = (corners: Int32Array) => corners.reduce((sum, v) => sum + Number(v < 0), 0);

function* inText(text: string): Generator<Int32Array> {
  for (const [, list] of text.matchAll(IN_TEXT)) yield Int32Array.from(list.split(','), Number);
}

function* inBinary(bytes: Uint8Array): Generator<Int32Array> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (let at = bytes.indexOf(NAME[0]); at >= 0; at = bytes.indexOf(NAME[0], at + 1)) {
    if (!NAME.every((letter, i) => bytes[at + i] === letter)) continue;
    const head = at + NAME.length;
    if (bytes[head] !== INTEGERS) continue;
    const [count, isPacked, size] = [1, 5, 9].map((by) => view.getUint32(head + by, true));
    const start = head + HEAD;
    const values = isPacked
      ? unzlibSync(bytes.subarray(start, start + size))
      : bytes.slice(start, start + 4 * count);
    yield new Int32Array(values.slice().buffer);
  }
}
