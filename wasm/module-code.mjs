// The functions of a WebAssembly module, and the same module with its functions in another order.
// The format: https://webassembly.github.io/spec/core/binary/

const SECTION = {
  imports: 2,
  functions: 3,
  globals: 6,
  exports: 7,
  start: 8,
  elements: 9,
  code: 10,
};
const FUNCTION = 0;
const END = 0x0b;

const range = (first, last) => Array.from({ length: last - first + 1 }, (_, i) => first + i);

/** Reads a module's bytes from `at` on. */
class Reader {
  constructor(bytes, at = 0) {
    this.bytes = bytes;
    this.at = at;
  }

  byte() {
    return this.bytes[this.at++];
  }

  /** An unsigned number of up to 32 bits. */
  number() {
    let out = 0;
    for (let scale = 1; ; scale *= 128) {
      const byte = this.byte();
      out += (byte & 127) * scale;
      if (byte < 128) return out;
    }
  }

  /** A number of any size and sign, of which only the end matters. */
  skipNumber() {
    while (this.byte() >= 128);
  }

  /** What follows `length` numbers. */
  skipNumbers(length) {
    for (let i = 0; i < length; ++i) this.skipNumber();
  }

  take(length) {
    this.at += length;
    return this.bytes.subarray(this.at - length, this.at);
  }
}

/** The bytes of an unsigned number. */
function encoded(value) {
  const out = [];
  let rest = value;
  for (; rest >= 128; rest = Math.floor(rest / 128)) out.push((rest % 128) + 128);
  out.push(rest);
  return Buffer.from(out);
}

function sectionsOf(bytes) {
  const reader = new Reader(bytes, 8);
  const out = [];
  while (reader.at < bytes.length) {
    const id = reader.byte();
    out.push({ id, content: reader.take(reader.number()) });
  }
  return out;
}

const contentOf = (sections, id) => sections.find((section) => section.id === id)?.content;

function countImports(sections) {
  const content = contentOf(sections, SECTION.imports);
  if (!content) return 0;
  const reader = new Reader(content);
  let functions = 0;
  for (let left = reader.number(); left > 0; --left) {
    for (let names = 0; names < 2; ++names) reader.take(reader.number());
    const kind = reader.byte();
    if (kind === FUNCTION) ++functions;
    // Tables and globals begin with one byte, a table goes on as a memory does.
    if (kind === 1 || kind === 3) reader.byte();
    if (kind === FUNCTION || kind === 3) reader.skipNumber();
    else reader.skipNumbers((reader.byte() & 1) + 1);
  }
  return functions;
}

function bodiesOf(sections) {
  const reader = new Reader(contentOf(sections, SECTION.code));
  return Array.from({ length: reader.number() }, () => reader.take(reader.number()));
}

/** The functions that a module contains, and how many it imports, which come before them. */
export function functionsOf(bytes) {
  const sections = sectionsOf(bytes);
  return { bodies: bodiesOf(sections), imported: countImports(sections) };
}

/** unreachable, nop, else, end, return, drop, select, ref.is_null; comparisons and arithmetic. */
const ALONE = new Set([0x00, 0x01, 0x05, END, 0x0f, 0x1a, 0x1b, 0xd1, ...range(0x45, 0xc4)]);
/** block, loop, if, br, br_if; locals, globals, tables, the size of memory, constants, ref.null. */
const WITH_NUMBER = new Set([
  ...[0x02, 0x03, 0x04, 0x0c, 0x0d, 0x3f, 0x40, 0x41, 0x42, 0xd0],
  ...range(0x20, 0x26),
]);
/** Loads and stores; call_indirect. */
const WITH_TWO = new Set([...range(0x28, 0x3e), 0x11]);

const unknown = (what) => new Error(`The module has ${what}, which is not known here.`);

/** Passes what follows an instruction other than a call. */
function skipRest(reader, code) {
  if (ALONE.has(code)) return;
  if (WITH_NUMBER.has(code)) reader.skipNumber();
  else if (WITH_TWO.has(code)) reader.skipNumbers(2);
  else if (code === 0x0e)
    reader.skipNumbers(reader.number() + 1); // br_table
  else if (code === 0x1c)
    reader.take(reader.number()); // select with types
  else if (code === 0x43) reader.take(4);
  else if (code === 0x44) reader.take(8);
  else if (code === 0xfc) skipBulk(reader, reader.number());
  else if (code === 0xfd) skipVector(reader, reader.number());
  else if (code === 0xfe)
    reader.skipNumbers(reader.number() === 3 ? 1 : 2); // 3: a fence
  else throw unknown(`the instruction ${code}`);
}

/** Conversions that saturate, and what works on whole memories and tables. */
function skipBulk(reader, code) {
  if (code > 17) throw unknown(`the instruction 252 ${code}`);
  if (code >= 8) reader.skipNumbers([8, 10, 12, 14].includes(code) ? 2 : 1);
}

function skipVector(reader, code) {
  const isLane = (code >= 21 && code <= 34) || (code >= 84 && code <= 91);
  if (code <= 11 || (code >= 84 && code <= 93)) reader.skipNumbers(2);
  if (code === 12 || code === 13) reader.take(16);
  if (isLane) reader.byte();
}

/**
 * Instructions up to the end of the body or, of a constant, up to its own; calls and references have
 * `renamed` functions.
 */
function rewritten(reader, renamed, isConstant = false) {
  const parts = [];
  let from = reader.at;
  while (reader.at < reader.bytes.length) {
    const code = reader.byte();
    // call, return_call, ref.func
    if (code === 0x10 || code === 0x12 || code === 0xd2) {
      parts.push(reader.bytes.subarray(from, reader.at), encoded(renamed(reader.number())));
      from = reader.at;
    } else {
      skipRest(reader, code);
      if (isConstant && code === END) break;
    }
  }
  parts.push(reader.bytes.subarray(from, reader.at));
  return Buffer.concat(parts);
}

function rewrittenBody(body, renamed) {
  const reader = new Reader(body);
  for (let left = reader.number(); left > 0; --left) reader.skipNumbers(2);
  const locals = body.subarray(0, reader.at);
  return Buffer.concat([locals, rewritten(reader, renamed)]);
}

/** How often each function is called, the imported ones first. */
export function callsOf(bytes) {
  const { bodies, imported } = functionsOf(bytes);
  const calls = new Uint32Array(imported + bodies.length);
  const count = (name) => {
    ++calls[name];
    return name;
  };
  for (const body of bodies) rewrittenBody(body, count);
  return calls;
}

const withLength = (content) => Buffer.concat([encoded(content.length), content]);
const list = (items) => Buffer.concat([encoded(items.length), ...items]);

function rewrittenExports(content, renamed) {
  const reader = new Reader(content);
  const items = Array.from({ length: reader.number() }, () => {
    const name = reader.take(reader.number());
    const kind = reader.byte();
    const index = reader.number();
    const own = encoded(kind === FUNCTION ? renamed(index) : index);
    return Buffer.concat([withLength(name), Buffer.from([kind]), own]);
  });
  return list(items);
}

function rewrittenElements(content, renamed) {
  const reader = new Reader(content);
  const items = Array.from({ length: reader.number() }, () => {
    const start = reader.at;
    const flags = reader.number();
    if (flags > 3) throw unknown(`a list of functions of kind ${flags}`);
    if (flags === 2) reader.skipNumber();
    if (flags === 0 || flags === 2) rewritten(reader, renamed, true);
    if (flags > 0) reader.byte();
    const head = content.subarray(start, reader.at);
    const names = Array.from({ length: reader.number() }, () => encoded(renamed(reader.number())));
    return Buffer.concat([head, list(names)]);
  });
  return list(items);
}

function rewrittenGlobals(content, renamed) {
  const reader = new Reader(content);
  const items = Array.from({ length: reader.number() }, () => {
    const type = reader.take(2);
    return Buffer.concat([type, rewritten(reader, renamed, true)]);
  });
  return list(items);
}

/** The module with its functions in `order`: their numbers in functionsOf, the new first one first. */
export function reordered(bytes, order) {
  const sections = sectionsOf(bytes);
  const imported = countImports(sections);
  const place = new Uint32Array(order.length);
  for (const [i, old] of order.entries()) place[old] = i;
  const renamed = (name) => (name < imported ? name : imported + place[name - imported]);
  const rewrite = {
    [SECTION.functions]: (content) => {
      const reader = new Reader(content);
      const types = Array.from({ length: reader.number() }, () => encoded(reader.number()));
      return list(order.map((old) => types[old]));
    },
    [SECTION.globals]: (content) => rewrittenGlobals(content, renamed),
    [SECTION.exports]: (content) => rewrittenExports(content, renamed),
    [SECTION.start]: (content) => encoded(renamed(new Reader(content).number())),
    [SECTION.elements]: (content) => rewrittenElements(content, renamed),
    [SECTION.code]: () => {
      const bodies = bodiesOf(sections).map((body) => withLength(rewrittenBody(body, renamed)));
      return list(order.map((old) => bodies[old]));
    },
  };
  const parts = sections.map(({ id, content }) =>
    Buffer.concat([Buffer.from([id]), withLength(rewrite[id]?.(content) ?? content)]),
  );
  return Buffer.concat([bytes.subarray(0, 8), ...parts]);
}
