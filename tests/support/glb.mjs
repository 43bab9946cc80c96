// glTF files for tests: made from arrays, and read without the program.

const COMPONENTS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };
const ARRAYS = {
  5120: Int8Array,
  5121: Uint8Array,
  5122: Int16Array,
  5123: Uint16Array,
  5125: Uint32Array,
  5126: Float32Array,
};
const codeOf = (array) => Number(Object.keys(ARRAYS).find((c) => array instanceof ARRAYS[c]));
const padded = (bytes, filler = 0) =>
  Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, filler)]);
const bytesOf = (array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength);

/** Collects views and accessors; the rest of the JSON is the caller's. */
export class GlbMaker {
  json = { asset: { version: '2.0' }, buffers: [], bufferViews: [], accessors: [] };
  #bytes = Buffer.alloc(0);

  view(bytes, more = {}) {
    this.#bytes = padded(this.#bytes);
    const byteOffset = this.#bytes.length;
    this.#bytes = Buffer.concat([this.#bytes, bytes]);
    return (
      this.json.bufferViews.push({ buffer: 0, byteOffset, byteLength: bytes.length, ...more }) - 1
    );
  }

  /**
   * Adds an accessor of a typed array; `box` adds min and max. Elements whose size is not a
   * multiple of 4 bytes are padded.
   */
  accessor(array, type, { box = false, target, ...more } = {}) {
    const size = COMPONENTS[type] * array.BYTES_PER_ELEMENT;
    const count = array.length / COMPONENTS[type];
    const isVertices = target === 34962;
    const stride = isVertices && size % 4 !== 0 ? size + 4 - (size % 4) : undefined;
    const rows = Buffer.alloc(count * (stride ?? size));
    for (let i = 0; i < count; i++)
      bytesOf(array).copy(rows, i * (stride ?? size), i * size, (i + 1) * size);
    const view = this.view(rows, {
      ...(stride && { byteStride: stride }),
      ...(target && { target }),
    });
    return this.add(view, array, type, { ...(box && boxOf(array, COMPONENTS[type])), ...more });
  }

  /** Adds an accessor of values that are already in a view. */
  add(bufferView, array, type, more = {}) {
    const count = array.length / COMPONENTS[type];
    const accessor = { bufferView, componentType: codeOf(array), count, type, ...more };
    return this.json.accessors.push(accessor) - 1;
  }

  /** Several arrays in one view, element by element. */
  interleaved(arrays, type) {
    const size = COMPONENTS[type] * arrays[0].BYTES_PER_ELEMENT;
    const count = arrays[0].length / COMPONENTS[type];
    const rows = Array.from({ length: count }, (_, i) =>
      Buffer.concat(arrays.map((a) => bytesOf(a).subarray(i * size, (i + 1) * size))),
    );
    const view = this.view(Buffer.concat(rows), {
      byteStride: size * arrays.length,
      target: 34962,
    });
    return arrays.map((a, i) => this.add(view, a, type, { byteOffset: i * size }));
  }

  /** Adds an accessor that is zero except for some elements. */
  sparse(count, type, indices, values, more = {}) {
    const sparse = {
      count: indices.length,
      indices: { bufferView: this.view(bytesOf(indices)), componentType: codeOf(indices) },
      values: { bufferView: this.view(bytesOf(values)) },
    };
    const componentType = codeOf(values);
    return this.json.accessors.push({ componentType, count, type, sparse, ...more }) - 1;
  }

  glb() {
    this.json.buffers = [{ byteLength: this.#bytes.length }];
    return glbOf(this.json, this.#bytes);
  }

  /** The .gltf text with its buffer at `uri`, by default embedded in the text; and the buffer. */
  gltf(uri = `data:application/octet-stream;base64,${this.#bytes.toString('base64')}`) {
    const json = { ...this.json, buffers: [{ byteLength: this.#bytes.length, uri }] };
    return { text: JSON.stringify(json), buffer: this.#bytes };
  }
}

export function boxOf(array, size) {
  const column = (d) => Array.from(array).filter((_, i) => i % size === d);
  const all = Array.from({ length: size }, (_, d) => column(d));
  const extreme = (of) => all.map((numbers) => numbers.reduce((a, b) => of(a, b)));
  return { min: extreme(Math.min), max: extreme(Math.max) };
}

export function glbOf(json, buffer) {
  const chunk = (type, bytes) => {
    const header = Buffer.alloc(8);
    header.writeUInt32LE(bytes.length, 0);
    header.writeUInt32LE(type, 4);
    return Buffer.concat([header, bytes]);
  };
  const text = Buffer.from(typeof json === 'string' ? json : JSON.stringify(json));
  const body = Buffer.concat([
    chunk(0x4e4f534a, padded(text, 0x20)),
    chunk(0x004e4942, padded(buffer)),
  ]);
  const header = Buffer.alloc(12);
  header.write('glTF', 0, 'latin1');
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(12 + body.length, 8);
  return Buffer.concat([header, body]);
}

/** `{ json, buffer }` of a .glb, or of a .gltf whose buffer is in a data URI. */
export function parseGltf(bytes) {
  if (bytes.toString('latin1', 0, 4) !== 'glTF') {
    const json = JSON.parse(bytes.toString());
    return { json, buffer: Buffer.from(json.buffers[0].uri.split(',')[1], 'base64') };
  }
  const size = bytes.readUInt32LE(12);
  return {
    json: JSON.parse(bytes.toString('utf8', 20, 20 + size)),
    buffer: bytes.subarray(28 + size),
  };
}

/** Elements of an accessor as arrays of their components, with sparse ones applied. */
export function elementsOf({ json, buffer }, index) {
  const { bufferView, byteOffset = 0, componentType, count, type, sparse } = json.accessors[index];
  const read = (viewIndex, offset, kind, n, components) => {
    const view = json.bufferViews[viewIndex];
    const size = components * kind.BYTES_PER_ELEMENT;
    const begin = (view.byteOffset ?? 0) + offset;
    return Array.from({ length: n }, (_, i) => {
      const at = begin + i * (view.byteStride ?? size);
      const bytes = Uint8Array.from(buffer.subarray(at, at + size));
      return Array.from(new kind(bytes.buffer));
    });
  };
  const kind = ARRAYS[componentType];
  const components = COMPONENTS[type];
  const out =
    bufferView === undefined
      ? Array.from({ length: count }, () => Array(components).fill(0))
      : read(bufferView, byteOffset, kind, count, components);
  if (!sparse) return out;
  const { indices, values } = sparse;
  const at = read(
    indices.bufferView,
    indices.byteOffset ?? 0,
    ARRAYS[indices.componentType],
    sparse.count,
    1,
  );
  const put = read(values.bufferView, values.byteOffset ?? 0, kind, sparse.count, components);
  at.forEach(([i], k) => {
    out[i] = put[k];
  });
  return out;
}

/** Vertices of the triangles of a primitive, [a, b, c] each. */
export function trianglesOf(model, primitive) {
  const count = model.json.accessors[primitive.attributes.POSITION].count;
  const v =
    primitive.indices === undefined
      ? Array.from({ length: count }, (_, i) => i)
      : elementsOf(model, primitive.indices).flat();
  const mode = primitive.mode ?? 4;
  if (mode === 4)
    return Array.from({ length: Math.floor(v.length / 3) }, (_, i) => v.slice(3 * i, 3 * i + 3));
  const odd = (i) => (mode === 5 ? i % 2 : 0);
  return v
    .slice(2)
    .map((_, i) =>
      mode === 5 ? [v[i], v[i + 1 + odd(i)], v[i + 2 - odd(i)]] : [v[i + 1], v[i + 2], v[0]],
    );
}

/** All primitives as one OBJ text, `transform(mesh)` applied to positions; v upwards. */
export function objOf(model, { set = 0, transform = () => (p) => p } = {}) {
  const lines = [];
  let first = 1;
  for (const [m, mesh] of model.json.meshes.entries())
    for (const primitive of mesh.primitives.filter((p) => (p.mode ?? 4) >= 4)) {
      const positions = elementsOf(model, primitive.attributes.POSITION);
      lines.push(...positions.map((p) => `v ${transform(m)(p).join(' ')}`));
      const uv = elementsOf(model, primitive.attributes[`TEXCOORD_${set}`]);
      lines.push(...uv.map(([u, v]) => `vt ${u} ${1 - v}`));
      for (const face of trianglesOf(model, primitive))
        lines.push(`f ${face.map((v) => `${v + first}/${v + first}`).join(' ')}`);
      first += positions.length;
    }
  return `${lines.join('\n')}\n`;
}
