// Tables between <!-- generated:NAME --> and <!-- /generated --> lines of the documentation.

import { flagOf, fullText, rangeText, withoutResearch } from './schema.mjs';

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
  'flatten-options': ({ flattenOptions }) => optionTable(flattenOptions),
  'unwrap-options': ({ unwrapOptions }) => optionTable(unwrapOptions),
};

function optionTable(options) {
  return table(
    ['Option', 'Command line', 'Default', 'Range', 'Meaning'],
    options.map((option) => [
      `\`${option.name}\``,
      `\`${flagOf(option)}\``,
      `\`${option.default}\``,
      rangeText(option),
      fullText(option),
    ]),
  );
}

function table(head, rows) {
  const line = (cells) => `| ${cells.map((cell) => cell.replaceAll('|', '\\|')).join(' | ')} |`;
  return [line(head), `|${head.map(() => '---').join('|')}|`, ...rows.map(line)].join('\n');
}

/**
 * The document with its regions filled, undefined when it has none. Throws on an unknown or open
 * region.
 */
export function fillRegions(text, schema, path) {
  const region = /^<!-- generated:([\w-]+) -->\n([\s\S]*?)^<!-- \/generated -->$/gm;
  const starts = text.match(/^<!-- generated:[\w-]+ -->$/gm) ?? [];
  if (starts.length === 0) return undefined;
  const shown = path.startsWith('wasm/') ? withoutResearch(schema) : schema;
  let count = 0;
  const filled = text.replace(region, (_, name) => {
    if (!TABLES[name]) throw new Error(`${path}: unknown region "generated:${name}"`);
    count += 1;
    return `<!-- generated:${name} -->\n${TABLES[name](shown)}\n<!-- /generated -->`;
  });
  if (count !== starts.length) throw new Error(`${path}: a generated region is not closed`);
  return filled;
}
