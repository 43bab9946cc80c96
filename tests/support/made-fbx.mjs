// Makes FBX files, as text and binary, in the way of exporters.

import { deflateSync } from 'node:zlib';

/** Values of a node that are written as an array. */
class Values {
  constructor(type, list) {
    Object.assign(this, { type, list });
  }
}
const doubles = (list) => new Values('d', list.flat());
const ints = (list) => new Values('i', list.flat());
const longs = (list) => new Values('l', list.map(BigInt));
const floats = (list) => new Values('f', list);
/** A number of 64 bits: an id. */
const long = (value) => new Values('L', value);
const node = (name, values = [], children = []) => ({ name, values, children });

const property = (name, type, ...values) =>
  node('P', [name, type, '', 'A', ...values.map((x) => (typeof x === 'string' ? x : Number(x)))]);
const properties = (...list) => node('Properties70', [], list);

/** Ids of all that refers to each other. */
let next = 1000;
const newId = () => ++next;

/**
 * `objects`: each `{ name, vertices, faces, uv, material, translation, rotation, scaling, parent, more }`; `uv` is a list of
 * sets, each with texcoords of every corner. `materials`: `{ name, color, more, image }`, where an image is `{ file, content }`
 * and goes with a `slot`. `extra` has further nodes, made from the ids: a function of `{ models, geometries, add, connect }`.
 */
export function fbxTree({ objects, materials = [], up = 1, unit = 1, version = 7400, extra }) {
  const nodes = [];
  const connections = [];
  const add = (kind, name, type, children = []) => {
    const id = newId();
    nodes.push(node(kind, [long(id), { kind, name }, type], children));
    return id;
  };
  const connect = (from, to, slot) =>
    connections.push(
      node('C', slot ? ['OP', long(from), long(to), slot] : ['OO', long(from), long(to)]),
    );
  const materialIds = materials.map((material) => addMaterial(material, add, connect));
  const [models, geometries] = [[], []];
  for (const object of objects) {
    const { name, translation = [0, 0, 0], rotation = [0, 0, 0], scaling = [1, 1, 1] } = object;
    const model = add('Model', name, object.type ?? (object.faces ? 'Mesh' : 'Null'), [
      properties(
        property('Lcl Translation', 'Lcl Translation', ...translation),
        property('Lcl Rotation', 'Lcl Rotation', ...rotation),
        property('Lcl Scaling', 'Lcl Scaling', ...scaling),
      ),
    ]);
    models.push(model);
    connect(model, object.parent === undefined ? 0 : models[object.parent]);
    if (!object.faces) continue;
    const shared = object.sameAs === undefined ? null : geometries[object.sameAs];
    const geometry = shared ?? add('Geometry', name, 'Mesh', geometryNodes(object));
    geometries.push(geometry);
    connect(geometry, model);
    for (const material of [object.material ?? []].flat()) connect(materialIds[material], model);
  }
  extra?.({ models, geometries, add, connect });
  return {
    version,
    nodes: [
      node('FBXHeaderExtension', [], [node('FBXVersion', [version])]),
      node(
        'GlobalSettings',
        [],
        [properties(property('UpAxis', 'int', up), property('UnitScaleFactor', 'double', unit))],
      ),
      node('Objects', [], nodes),
      node('Connections', [], connections),
    ],
  };
}

/** Each face ends with a negative number. */
const cornersOf = (faces) =>
  faces.flatMap((face) => face.map((v, i) => (i === face.length - 1 ? -v - 1 : v)));

function geometryNodes({ vertices, faces, uv = [], materialOfFace, more = [] }) {
  return [
    node('Vertices', [doubles(vertices)]),
    node('PolygonVertexIndex', [ints(cornersOf(faces))]),
    ...uv.map((set, i) =>
      node(
        'LayerElementUV',
        [i],
        [
          node('Name', [`UVMap${i}`]),
          node('MappingInformationType', ['ByPolygonVertex']),
          node('ReferenceInformationType', ['IndexToDirect']),
          node('UV', [doubles(set)]),
          node('UVIndex', [ints(set.map((_, c) => c))]),
        ],
      ),
    ),
    ...(materialOfFace
      ? [
          node(
            'LayerElementMaterial',
            [0],
            [
              node('MappingInformationType', ['ByPolygon']),
              node('ReferenceInformationType', ['IndexToDirect']),
              node('Materials', [ints(materialOfFace)]),
            ],
          ),
        ]
      : []),
    ...more,
  ];
}

function addMaterial({ name, color, images = [], more = [] }, add, connect) {
  const material = add('Material', name, '', [
    node('ShadingModel', ['phong']),
    properties(...(color ? [property('DiffuseColor', 'Color', ...color)] : []), ...more),
  ]);
  for (const { slot = 'DiffuseColor', file, content } of images) {
    const texture = add('Texture', file, '', [
      node('FileName', [`C:\\art\\${file}`]),
      node('RelativeFilename', [file]),
    ]);
    const video = add('Video', file, 'Clip', [
      node('Filename', [`C:\\art\\${file}`]),
      node('RelativeFilename', [file]),
      ...(content ? [node('Content', [content])] : []),
    ]);
    connect(texture, material, slot);
    connect(video, texture);
  }
  return material;
}

/** A cube of quads. */
export const CUBE_VERTICES = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, (i >> 1) & 1, i >> 2]);
export const CUBE_QUADS = [
  [0, 2, 3, 1],
  [4, 5, 7, 6],
  [0, 1, 5, 4],
  [2, 6, 7, 3],
  [0, 4, 6, 2],
  [1, 3, 7, 5],
];

export const fbxParts = { node, doubles, floats, ints, long, longs, properties, property };

// As text.

export const asText = ({ version, nodes }) =>
  `; FBX ${[...String(version / 100)].join('.').replace(/\.$/, '')} project file\n${nodes.map((each) => textOf(each, '')).join('')}`;

function textOf({ name, values, children }, indent) {
  const inner = `${indent}\t`;
  const [first] = values;
  if (first instanceof Values && Array.isArray(first.list))
    return `${indent}${name}: *${first.list.length} {\n${inner}a: ${first.list.join(',')}\n${indent}}\n`;
  if (Buffer.isBuffer(first)) return `${indent}${name}: ,\n${inner}"${first.toString('base64')}"\n`;
  // Most exporters leave no blanks between numbers.
  const head = `${indent}${name}: ${values
    .map(textValue)
    .join(', ')
    .replace(/, (?=[-\d])/g, ',')}`;
  if (children.length === 0 && values.length > 0 && !(first instanceof Values && name !== 'C'))
    return `${head}\n`;
  return `${head} {\n${children.map((each) => textOf(each, inner)).join('')}${indent}}\n`;
}

const textValue = (value) => {
  if (value instanceof Values) return String(value.list);
  if (typeof value === 'number') return String(value);
  return `"${value.kind ? `${value.kind}::${value.name}` : value}"`;
};

// Binary.

const MAGIC = Buffer.from('Kaydara FBX Binary  \0\x1a\0', 'latin1');
const FOOTER = 160;

export function asBinary({ version, nodes }) {
  const head = Buffer.alloc(4);
  head.writeUInt32LE(version);
  const parts = [MAGIC, head];
  let at = MAGIC.length + head.length;
  for (const each of [...nodes, null]) {
    const bytes = binaryOf(each, at);
    parts.push(bytes);
    at += bytes.length;
  }
  return Buffer.concat([...parts, Buffer.alloc(FOOTER + 16 - (at % 16))]);
}

/** `at`: where it begins in the file. An empty record ends a list. */
function binaryOf(each, at) {
  if (!each) return Buffer.alloc(13);
  const { name, values, children } = each;
  const content = Buffer.concat(values.map(binaryValue));
  const head = Buffer.alloc(13 + name.length);
  const parts = [head, content];
  let end = at + head.length + content.length;
  for (const child of children.length > 0 ? [...children, null] : []) {
    const bytes = binaryOf(child, end);
    parts.push(bytes);
    end += bytes.length;
  }
  head.writeUInt32LE(end, 0);
  head.writeUInt32LE(values.length, 4);
  head.writeUInt32LE(content.length, 8);
  head.writeUInt8(name.length, 12);
  head.write(name, 13, 'latin1');
  return Buffer.concat(parts);
}

function binaryValue(value) {
  if (value instanceof Values && Array.isArray(value.list)) return binaryList(value);
  if (value instanceof Values)
    return typed('L', 8, (b) => b.writeBigInt64LE(BigInt(value.list), 1));
  if (typeof value === 'number')
    return Number.isInteger(value)
      ? typed('I', 4, (b) => b.writeInt32LE(value, 1))
      : typed('D', 8, (b) => b.writeDoubleLE(value, 1));
  if (Buffer.isBuffer(value)) return lengthFirst('R', value);
  return lengthFirst('S', Buffer.from(value.kind ? `${value.name}\0\x01${value.kind}` : value));
}

const ARRAYS = { d: Float64Array, f: Float32Array, i: Int32Array, l: BigInt64Array };

/** Long ones are compressed. */
function binaryList({ type, list }) {
  const raw = Buffer.from(ARRAYS[type].from(list).buffer);
  const isPacked = list.length > 128;
  const data = isPacked ? deflateSync(raw) : raw;
  const head = typed(type, 12, (b) => {
    b.writeUInt32LE(list.length, 1);
    b.writeUInt32LE(Number(isPacked), 5);
    b.writeUInt32LE(data.length, 9);
  });
  return Buffer.concat([head, data]);
}

function lengthFirst(type, data) {
  return Buffer.concat([typed(type, 4, (b) => b.writeUInt32LE(data.length, 1)), data]);
}

function typed(type, size, write) {
  const out = Buffer.alloc(1 + size);
  out.write(type, 0, 'latin1');
  write(out);
  return out;
}
