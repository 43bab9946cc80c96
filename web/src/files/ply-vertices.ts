// Numbers of the vertices of a PLY, as far as they come first in the file and have no lists.

export interface PlyNumbers {
  /** Those asked for, vertex by vertex. */
  values: Float64Array;
  /** The largest value of their type; 1 for floating-point numbers. */
  largest: number;
}

type Read = (view: DataView, at: number, isLittle: boolean) => number;

interface Type {
  size: number;
  largest: number;
  read: Read;
}

const TYPES: Record<string, Type> = Object.fromEntries(
  (
    [
      [['char', 'int8'], 1, 2 ** 7 - 1, (view, at) => view.getInt8(at)],
      [['uchar', 'uint8'], 1, 2 ** 8 - 1, (view, at) => view.getUint8(at)],
      [['short', 'int16'], 2, 2 ** 15 - 1, (view, at, little) => view.getInt16(at, little)],
      [['ushort', 'uint16'], 2, 2 ** 16 - 1, (view, at, little) => view.getUint16(at, little)],
      [['int', 'int32'], 4, 2 ** 31 - 1, (view, at, little) => view.getInt32(at, little)],
      [['uint', 'uint32'], 4, 2 ** 32 - 1, (view, at, little) => view.getUint32(at, little)],
      [['float', 'float32'], 4, 1, (view, at, little) => view.getFloat32(at, little)],
      [['double', 'float64'], 8, 1, (view, at, little) => view.getFloat64(at, little)],
    ] as [string[], number, number, Read][]
  ).flatMap(([names, size, largest, read]) => names.map((name) => [name, { size, largest, read }])),
);

interface Layout {
  format: string;
  count: number;
  properties: { name: string; type: Type; offset: number }[];
  /** Bytes of a vertex. */
  stride: number;
  /** Where the first vertex begins. */
  start: number;
}

/** Null if the vertices do not have all of these properties, or cannot be read so simply. */
export function plyVertexNumbers(bytes: Uint8Array, names: string[]): PlyNumbers | null {
  const layout = layoutOf(bytes);
  const columns = names.map((name) => layout?.properties.findIndex((each) => each.name === name));
  if (!layout || columns.some((column) => column === undefined || column < 0)) return null;
  const wanted = columns as number[];
  const { largest } = layout.properties[wanted[0]].type;
  const values = layout.format === 'ascii' ? fromText : fromBinary;
  return { values: values(bytes, layout, wanted), largest };
}

/** A header is plain text, however the rest is written. */
const MOST_HEADER = 1 << 16;

function layoutOf(bytes: Uint8Array): Layout | null {
  const text = new TextDecoder('latin1').decode(bytes.subarray(0, MOST_HEADER));
  const end = /^end_header[ \t]*(\r\n|\n|\r)/m.exec(text);
  if (!end) return null;
  const lines = text
    .slice(0, end.index)
    .split(/[\r\n]+/)
    .map((line) => line.trim().split(/\s+/));
  const elements = lines.filter(([keyword]) => keyword === 'element');
  if (elements[0]?.[1] !== 'vertex') return null;
  const from = lines.indexOf(elements[0]) + 1;
  const to = elements[1] ? lines.indexOf(elements[1]) : lines.length;
  const layout: Layout = {
    format: lines.find(([keyword]) => keyword === 'format')?.[1] ?? '',
    count: Number(elements[0][2]),
    properties: [],
    stride: 0,
    start: end.index + end[0].length,
  };
  for (const [keyword, kind, name] of lines.slice(from, to)) {
    if (keyword !== 'property') continue;
    const type = TYPES[kind];
    if (!type) return null; // a list
    layout.properties.push({ name, type, offset: layout.stride });
    layout.stride += type.size;
  }
  return layout;
}

function fromText(bytes: Uint8Array, { count, properties, start }: Layout, columns: number[]) {
  const values = new Float64Array(columns.length * count);
  const words = new TextDecoder('latin1').decode(bytes.subarray(start)).matchAll(/\S+/g);
  const places = properties.map((_, p) => columns.indexOf(p));
  for (let i = 0; i < count; ++i)
    for (const place of places) {
      const { value } = words.next();
      if (place >= 0) values[columns.length * i + place] = Number(value?.[0]);
    }
  return values;
}

function fromBinary(bytes: Uint8Array, layout: Layout, columns: number[]) {
  const { count, properties, start, stride, format } = layout;
  const values = new Float64Array(columns.length * count);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const isLittle = format !== 'binary_big_endian';
  for (let i = 0; i < count; ++i)
    for (const [k, column] of columns.entries()) {
      const { type, offset } = properties[column];
      values[columns.length * i + k] = type.read(view, start + stride * i + offset, isLittle);
    }
  return values;
}
