// A strict reader for XML without DTD: throws at the first thing that is not well-formed.

const NAME = '[A-Za-z_][\\w.:-]*';
const TEXT = '[^<&]|&(?:amp|lt|gt|quot|apos|#\\d+|#x[\\da-fA-F]+);';
const ATTRIBUTE = new RegExp(`\\s+(${NAME})="((?:(?!")(?:${TEXT}))*)"`, 'y');
const OPEN = new RegExp(`<(${NAME})`, 'y');
const CLOSE = new RegExp(`</(${NAME})\\s*>`, 'y');
const CONTENT = new RegExp(`(?:${TEXT})+`, 'y');
const DECLARATION = /<\?xml version="1\.0" encoding="UTF-8"\?>\n/y;
// biome-ignore lint/suspicious/noControlCharactersInRegex: they are what XML forbids
const FORBIDDEN = /[\u0000-\u0008\u000b\u000c\u000e-\u001f\ufffe\uffff]/;

class Reader {
  constructor(text) {
    this.text = text;
    this.at = 0;
  }
  take(pattern) {
    pattern.lastIndex = this.at;
    const match = pattern.exec(this.text);
    if (match) this.at = pattern.lastIndex;
    return match;
  }
  fail(what) {
    throw new Error(`${what} at ${this.at}: ${this.text.slice(this.at, this.at + 60)}`);
  }
  attributes(name) {
    const out = {};
    for (let match = this.take(ATTRIBUTE); match; match = this.take(ATTRIBUTE)) {
      if (match[1] in out) this.fail(`<${name}> has two attributes ${match[1]}`);
      out[match[1]] = match[2];
    }
    return out;
  }
}

/** All elements in order, each `{ name, attributes, depth }`. Takes the bytes of a file. */
export function parseXml(bytes) {
  const text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  if (FORBIDDEN.test(text)) throw new Error('a character that XML forbids');
  const reader = new Reader(text);
  reader.take(DECLARATION);
  const elements = [];
  const open = [];
  while (reader.at < text.length) {
    if (open.length > 0 && reader.take(CONTENT)) continue;
    const closing = reader.take(CLOSE);
    if (closing) {
      if (open.pop() !== closing[1]) reader.fail(`</${closing[1]}> closes another element`);
      continue;
    }
    const opening = reader.take(OPEN);
    if (!opening) {
      if (open.length === 0 && /^\s*$/.test(text.slice(reader.at))) break;
      reader.fail('not well-formed');
    }
    if (open.length === 0 && elements.length > 0) reader.fail('a second root');
    const attributes = reader.attributes(opening[1]);
    elements.push({ name: opening[1], attributes, depth: open.length });
    if (reader.take(/\s*\/>/y)) continue;
    if (!reader.take(/\s*>/y)) reader.fail(`<${opening[1]}> has no end`);
    open.push(opening[1]);
  }
  if (open.length > 0) throw new Error(`<${open.pop()}> is not closed`);
  return elements;
}
