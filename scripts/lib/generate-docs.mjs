// Tables between <!-- generated:NAME --> and <!-- /generated --> lines of the documentation.

import { PRECISIONS } from './formats.mjs';
import { isIn, isNullable, typesOf } from './report-schema.mjs';
import { flagOf, fullText, isOptionOf, ofPackage, ofProgram, rangeText } from './schema.mjs';

const TABLES = {
  'exit-codes': ({ exitCodes }) =>
    table(
      ['Exit code', 'Meaning'],
      exitCodes.map(({ code, text }) => [String(code), text]),
    ),
  statuses: ({ statuses }) =>
    table(
      ['Code', 'Exit code', 'Meaning'],
      statuses.map(({ name, exit, text }) => [`\`${name}\``, String(exit), text]),
    ),
  formats: ({ formats }) =>
    table(
      ['Format', 'What it is', 'Endings', 'Media types', 'Written with'],
      formats.map(({ title, text, files, precision }) => [
        title,
        text,
        files.map(({ ending }) => `\`${ending}\``).join(', '),
        files.map(({ type }) => `\`${type}\``).join(', '),
        precision ? PRECISIONS[precision] : 'only read',
      ]),
    ),
  'flatten-options': ({ flattenOptions }) => optionTable(flattenOptions),
  'unwrap-options': ({ unwrapOptions }) => optionTable(unwrapOptions),
  'pack-options': ({ packOptions }) => optionTable(packOptions),
  'bake-options': ({ bakeOptions }) => optionTable(bakeOptions),
  'verify-options': ({ verifyOptions }) => optionTable(verifyOptions),
};

/** `enum-NAME` and `struct-NAME`. */
function tableOf(region, schema) {
  const [kind, name] = region.split('-');
  const values = kind === 'enum' && schema.enums.find((each) => each.name === name)?.values;
  if (values)
    return table(
      ['Name', 'Meaning'],
      values.map((value) => [`\`${value.name}\``, value.text]),
    );
  const struct = kind === 'struct' && schema.structs.find((each) => each.name === name);
  return struct ? structTable(struct, typesOf(schema)) : TABLES[region]?.(schema);
}

function structTable({ fields, extends: base }, types) {
  const inherited = base ? types.get(base).struct.fields : [];
  return table(
    ['Key', 'Value', 'Meaning'],
    [...inherited, ...fields]
      .filter((field) => isIn(field, 'cli'))
      .map((field) => [`\`${field.name}\``, valueText(field, types), meaning(field)]),
  );
}

function meaning({ type, text, fields, nullFields, absent, ...field }) {
  const members =
    type === 'group'
      ? fields.map((member) => `\`${member.name}\` = ${member.text}`).join(', ')
      : '';
  const notes = [
    members,
    isNullable(field, 'cli') && `null ${field.null}`,
    nullFields && `null ${nullFields}`,
    absent && `absent ${absent}`,
    !isIn(field, 'package') && 'command line only',
  ];
  return [text, ...notes.filter(Boolean)].join('; ');
}

/** "number, radians", "list of text", "`ChartReport` or null". */
function valueText({ type, list, unit, fields, ...field }, types) {
  if (type === 'group') return fields.map(({ name }) => `\`${name}\``).join(', ');
  const { names, words, struct, options } = types.get(type);
  const few = names && !words && names.length < 8;
  const base = few
    ? names.map((name) => `\`${name}\``).join(', ')
    : (words ?? (struct ? `[\`${type}\`](#${type.toLowerCase()})` : options ? 'object' : 'text'));
  const text = list ? `list of ${base}` : base;
  return `${text}${isNullable(field, 'cli') ? ' or null' : ''}${unit && !struct ? `, ${unit}` : ''}`;
}

/** How a width and a height are written, on a command line or in JavaScript. */
const PAIR = '`2048x1024` or `[2048, 1024]`';

function optionTable(options) {
  return table(
    ['Option', 'Command line', 'Default', 'Range', 'Meaning'],
    options.map((option) => [
      `\`${option.name}\``,
      isOptionOf(option, 'cli') ? `\`${flagOf(option)}\`` : '',
      `\`${option.default}\``,
      rangeText(option, PAIR),
      fullText(option),
    ]),
  );
}

function table(head, rows) {
  const line = (cells) => `| ${cells.map((cell) => cell.replaceAll('|', '\\|')).join(' | ')} |`;
  return [line(head), `|${head.map(() => '---').join('|')}|`, ...rows.map(line)].join('\n');
}

/**
 * The document with its regions filled, undefined if it has none. Throws on an unknown or unclosed
 * region.
 */
export function fillRegions(text, schema, path) {
  const region = /^<!-- generated:([\w-]+) -->\n([\s\S]*?)^<!-- \/generated -->$/gm;
  const starts = text.match(/^<!-- generated:[\w-]+ -->$/gm) ?? [];
  if (starts.length === 0) return undefined;
  const shown = path.startsWith('wasm/') ? ofPackage(schema) : ofProgram(schema);
  let count = 0;
  const filled = text.replace(region, (_, name) => {
    const filling = tableOf(name, shown);
    if (!filling) throw new Error(`${path}: unknown region "generated:${name}"`);
    count += 1;
    return `<!-- generated:${name} -->\n${filling}\n<!-- /generated -->`;
  });
  if (count !== starts.length) throw new Error(`${path}: a generated region is not closed`);
  return filled;
}
