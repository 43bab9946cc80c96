// A reader and a writer of PLY files, independent of the library. Files are { format, comments,
// elements: [{ name, properties: [{ name, type, countType? }], rows }] }; a row has one value per
// property: a number, or an array for a list.

const TYPES = {
  char: ['Int8', 1],
  uchar: ['Uint8', 1],
  short: ['Int16', 2],
  ushort: ['Uint16', 2],
  int: ['Int32', 4],
  uint: ['Uint32', 4],
  float: ['Float32', 4],
  double: ['Float64', 8],
};

export const PLY_FORMATS = ['ascii', 'binary_little_endian', 'binary_big_endian'];

const numbersOf = (property, value) => (property.countType ? [value.length, ...value] : [value]);
const typesOf = (property, value) =>
  property.countType ? [property.countType, ...value.map(() => property.type)] : [property.type];

function headerText({ format, comments = [], elements }) {
  const lines = ['ply', `format ${format} 1.0`, ...comments.map((text) => `comment ${text}`)];
  for (const { name, properties, rows } of elements) {
    lines.push(`element ${name} ${rows.length}`);
    for (const { name, type, countType } of properties)
      lines.push(`property ${countType ? `list ${countType} ` : ''}${type} ${name}`);
  }
  return `${[...lines, 'end_header'].join('\n')}\n`;
}

/** The file as bytes. */
export function plyBytes(file) {
  const parts = [Buffer.from(headerText(file))];
  const little = file.format === 'binary_little_endian';
  for (const { properties, rows } of file.elements)
    for (const row of rows) {
      const numbers = properties.flatMap((property, p) => numbersOf(property, row[p]));
      if (file.format === 'ascii') {
        parts.push(Buffer.from(`${numbers.join(' ')}\n`));
        continue;
      }
      const types = properties.flatMap((property, p) => typesOf(property, row[p]));
      types.forEach((type, i) => {
        const [kind, size] = TYPES[type];
        const view = new DataView(new ArrayBuffer(size));
        view[`set${kind}`](0, numbers[i], little);
        parts.push(Buffer.from(view.buffer));
      });
    }
  return Buffer.concat(parts);
}

function parseHeader(bytes) {
  const end = bytes.indexOf('end_header\n') + 'end_header\n'.length;
  const file = { format: '', comments: [], elements: [] };
  for (const line of bytes.toString('latin1', 0, end).split('\n')) {
    const [keyword, ...words] = line.split(' ');
    if (keyword === 'format') file.format = words[0];
    if (keyword === 'comment') file.comments.push(words.join(' '));
    if (keyword === 'element')
      file.elements.push({ name: words[0], count: Number(words[1]), properties: [], rows: [] });
    if (keyword === 'property') {
      const isList = words[0] === 'list';
      const [type, name] = isList ? words.slice(2) : words;
      const property = isList ? { name, type, countType: words[1] } : { name, type };
      file.elements.at(-1).properties.push(property);
    }
  }
  return { file, end };
}

/** Throws if the file is shorter or longer than its header says. */
export function parsePly(bytes) {
  const { file, end } = parseHeader(bytes);
  const isText = file.format === 'ascii';
  const words = isText ? bytes.toString('latin1', end).split(/\s+/).filter(Boolean) : [];
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = isText ? 0 : end;
  const next = (type) => {
    if (isText) return Number(words[at++]);
    const [kind, size] = TYPES[type];
    at += size;
    return view[`get${kind}`](at - size, file.format === 'binary_little_endian');
  };
  for (const element of file.elements) {
    for (let row = 0; row < element.count; row++)
      element.rows.push(
        element.properties.map(({ type, countType }) =>
          countType ? Array.from({ length: next(countType) }, () => next(type)) : next(type),
        ),
      );
    delete element.count;
  }
  const size = isText ? words.length : bytes.length;
  if (at !== size) throw new Error(`read to ${at} of ${size}`);
  return file;
}

export const elementOf = (file, name) => file.elements.find((element) => element.name === name);

/** The values of one property, or the rows of several. */
export function column(element, ...names) {
  const indices = names.map((name) =>
    element.properties.findIndex((property) => property.name === name),
  );
  if (indices.includes(-1)) throw new Error(`${element.name} has no ${names}`);
  return element.rows.map((row) =>
    names.length === 1 ? row[indices[0]] : indices.map((i) => row[i]),
  );
}

/** OBJ text with the positions, the texcoords s and t if there are any, and the faces. */
export function plyToObj(file) {
  const vertex = elementOf(file, 'vertex');
  const hasUv = vertex.properties.some(({ name }) => name === 's');
  const lines = column(vertex, 'x', 'y', 'z').map((xyz) => `v ${xyz.join(' ')}`);
  if (hasUv) lines.push(...column(vertex, 's', 't').map((uv) => `vt ${uv.join(' ')}`));
  for (const corners of column(elementOf(file, 'face'), 'vertex_indices'))
    lines.push(`f ${corners.map((v) => (hasUv ? `${v + 1}/${v + 1}` : v + 1)).join(' ')}`);
  return `${lines.join('\n')}\n`;
}
