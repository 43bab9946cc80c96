// The structs of reports in C++, and the functions that visit their fields.

import { HEADER } from './generate-cpp.mjs';
import { isIn, PLAIN_TYPES, typesOf } from './report-schema.mjs';
import { pascalCase, sentence } from './schema.mjs';

const STANDARD = {
  array: 'std::array',
  cstddef: 'std::size_t',
  cstdint: /std::u?int\d/,
  limits: 'std::numeric_limits',
  optional: 'std::optional',
  string: 'std::string',
  vector: 'std::vector',
};

/** The headers with structs, as a map from name to text. */
export function renderReportHeaders(schema) {
  const types = typesOf(schema);
  const headers = new Map();
  for (const struct of schema.structs) {
    if (!struct.header) continue;
    headers.set(struct.header, [...(headers.get(struct.header) ?? []), struct]);
  }
  return [...headers].map(([name, structs]) => [name, renderHeader(name, structs, types)]);
}

function renderHeader(name, structs, types) {
  const body = structs.flatMap((struct) => [
    ...(struct.viewOf ? [] : [structText(struct, types)]),
    visitText(struct, types),
  ]);
  const text = body.join('\n');
  const standard = Object.keys(STANDARD).filter((header) => text.match(STANDARD[header]));
  const own = new Set(structs.flatMap((struct) => projectHeaders(struct, types)));
  own.delete(`generated/${name}.h`);
  const includes = [
    ...standard.map((header) => `#include <${header}>`),
    ...(standard.length > 0 && own.size > 0 ? [''] : []),
    ...[...own].sort().map((header) => `#include "abflat/${header}"`),
  ];
  const parts = [HEADER, `${includes.join('\n')}\n`, 'namespace abflat {\n', text];
  return `${[...parts, '}  // namespace abflat'].join('\n')}\n`;
}

/** The struct that stores a type in C++: a view is stored in full. */
function storedType(type, types) {
  const { struct } = types.get(type) ?? {};
  return struct?.viewOf ?? type;
}

function projectHeaders(struct, types) {
  const names = struct.fields.filter((field) => isIn(field, 'cpp')).map(({ type }) => type);
  return [...names, struct.extends, struct.viewOf].flatMap((type) => {
    const { header, struct: other } = types.get(type) ?? {};
    if (other?.cpp) return ['status.h'];
    return header ? [`generated/${header}.h`] : [];
  });
}

function cppType({ type, list, null: isNullable, absent }, types) {
  const stored = storedType(type, types);
  const struct = types.get(stored)?.struct;
  const base = PLAIN_TYPES[type]?.cpp ?? struct?.cpp ?? stored;
  if (list) return `std::vector<${base}>`;
  return struct && (isNullable || (absent && !struct.cpp)) ? `std::optional<${base}>` : base;
}

/** The value of a field before anything is known. */
function initializer(field, types) {
  if (field.default === 'NaN') return ' = std::numeric_limits<double>::quiet_NaN()';
  if ('default' in field) return ` = ${field.default}`;
  if (field.list) return '';
  if (field.type === 'boolean') return ' = false';
  const { names } = types.get(field.type);
  if (names) return ` = ${field.type}::${pascalCase(names[0])}`;
  return ['number', 'integer', 'count', 'index', 'long'].includes(field.type) ? ' = 0' : '';
}

/** The fields of a struct in C++; fields of a group are prefixed with its name. */
function membersOf({ fields }) {
  return fields
    .filter((field) => isIn(field, 'cpp'))
    .flatMap((field) => (field.type === 'group' ? grouped(field) : [field]));
}

function grouped({ name, text, fields }) {
  return fields.map((member) => ({
    ...member,
    name: `${name}${pascalCase(member.name)}`,
    text: `${text}: ${member.text}`,
  }));
}

/** Wraps a sentence into lines that are not too long. */
function comment(text, indent) {
  const lines = [''];
  for (const word of sentence(text).split(' ')) {
    if (indent.length + 4 + lines.at(-1).length + word.length > 100) lines.push('');
    lines.push(`${lines.pop()} ${word}`);
  }
  return lines.map((line) => `${indent}///${line}`).join('\n');
}

function structText(struct, types) {
  const lines = membersOf(struct).map((field) => {
    const unit = field.unit ? `, in ${field.unit}` : '';
    return `${comment(`${field.text}${unit}`, '  ')}\n  ${cppType(field, types)} ${field.name}${initializer(field, types)};`;
  });
  const base = struct.extends ? ` : ${struct.extends}` : '';
  return `${comment(struct.text, '')}\nstruct ${struct.name}${base} {\n${lines.join('\n')}\n};\n`;
}

/**
 * The code that reports a field to a visitor. Some fields are not in JSON, or are written by hand.
 */
function visitLines(field, types) {
  if (field.type === 'group')
    return [
      `  v.begin("${field.name}");`,
      ...field.fields.map(
        (member) => `  v.field("${member.name}", r.${field.name}${pascalCase(member.name)});`,
      ),
      '  v.end();',
    ];
  const { struct, options } = types.get(field.type);
  const special = struct?.cpp || struct?.viewOf ? lowerFirst(struct.name) : options && 'options';
  const value = struct?.viewOf ? 'r' : `r.${field.name}`;
  if (field.absent && !struct.cpp) return [`  if (${value}) v.field("${field.name}", *${value});`];
  return [`  v.${special || 'field'}("${field.name}", ${value});`];
}

const lowerFirst = (name) => name[0].toLowerCase() + name.slice(1);

function visitText(struct, types) {
  const fields = struct.fields.filter((field) => isIn(field, 'cpp') && isIn(field, 'cli'));
  const lines = fields.flatMap((field) => visitLines(field, types));
  if (struct.extends) lines.unshift(`  visitFields(static_cast<const ${struct.extends}&>(r), v);`);
  const name = struct.viewOf ? `visit${struct.name}` : 'visitFields';
  return `template <class Visitor>\nvoid ${name}(const ${struct.viewOf ?? struct.name}& r, Visitor& v) {\n${lines.join('\n')}\n}\n`;
}
