// The faces of an FBX, of which three.js makes triangles: it leaves out what it cannot triangulate.

import { unzlibSync } from 'fflate';

const NAMES = [/Vertices/, /PolygonVertexIndex/].map(({ source }) =>
  new TextEncoder().encode(source),
);
/** Types of arrays, and the size of what is in front of their values. */
const ARRAY = /[dfi]/;
const HEAD = 13;
const IN_TEXT = /\b(?:(Vertices)|PolygonVertexIndex):\s*\*(\d+)\s*\{\s*a:([^}]*)\}/g;

/** What follows one another in a geometry. */
type List = { coordinates: number } | { corners: Int32Array };

export interface Faces {
  /** Whether one has more than three corners. */
  hasPolygons: boolean;
  /** Whether all their vertices are there. */
  areWhole: boolean;
}

export function facesOf(bytes: Uint8Array, isBinary: boolean): Faces {
  const faces = { hasPolygons: false, areWhole: true };
  let vertices = 0;
  for (const list of isBinary ? inBinary(bytes) : inText(new TextDecoder().decode(bytes))) {
    if ('coordinates' in list) {
      vertices = list.coordinates / 3;
      continue;
    }
    const { corners } = list;
    if (corners.length > 3 * ends(corners)) faces.hasPolygons = true;
    if (corners.some((v) => (v < 0 ? ~v : v) >= vertices)) faces.areWhole = false;
  }
  return faces;
}

/** The last corner of each face is negative. */
const ends = (corners: Int32Array) => corners.reduce((sum, v) => sum + Number(v < 0), 0);

function* inText(text: string): Generator<List> {
  for (const [, vertices, count, list] of text.matchAll(IN_TEXT))
    yield vertices
      ? { coordinates: Number(count) }
      : { corners: Int32Array.from(list.split(','), Number) };
}

function* inBinary(bytes: Uint8Array): Generator<List> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  // The length of a name is in front of it.
  for (let at = 0; at + HEAD < bytes.length; ++at) {
    const which = NAMES.findIndex(
      (name) => bytes[at] === name.length && name.every((byte, i) => bytes[at + 1 + i] === byte),
    );
    if (which < 0) continue;
    const head = at + 1 + NAMES[which].length;
    if (!ARRAY.test(String.fromCharCode(bytes[head]))) continue;
    const [count, isPacked, size] = [1, 5, 9].map((by) => view.getUint32(head + by, true));
    if (which === 0) yield { coordinates: count };
    else yield { corners: integers(bytes.subarray(head + HEAD), isPacked ? size : 0, count) };
  }
}

/** `packed`: bytes that they take where they are compressed. */
function integers(bytes: Uint8Array, packed: number, count: number): Int32Array {
  const values = packed > 0 ? unzlibSync(bytes.subarray(0, packed)) : bytes;
  return new Int32Array(values.slice(0, 4 * count).buffer);
}
