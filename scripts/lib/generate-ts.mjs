// The TypeScript side of the schema.

import { BOUNDS, OPTION_TYPES, rangeText } from './schema.mjs';

const HEADER = '// Generated from core/schema/abflat.json by scripts/generate.mjs, do not edit.\n';

function literal(value) {
  if (typeof value !== 'string') return String(value);
  return `'${value.replace(/\\/g, '\\\\').replace(/'/g, "\\'").replace(/\n/g, '\\n')}'`;
}

function object(entries) {
  return `{ ${entries.map(([key, value]) => `${key}: ${literal(value)}`).join(', ')} }`;
}

function statusParts(statuses) {
  const names = statuses.map(({ name }) => literal(name));
  const rows = statuses.map(({ name, exit, text }) => {
    return `  ${name}: ${object([
      ['exit', exit],
      ['text', text],
    ])},`;
  });
  return [
    `/** In the order of the C++ enum: index = number of the code. */`,
    `export const STATUS_NAMES = [\n${names.map((name) => `  ${name},`).join('\n')}\n] as const;\n`,
    'export type StatusName = (typeof STATUS_NAMES)[number];\n',
    '/** Exit code of the command line program and meaning of every status. */',
    `export const STATUSES: Readonly<Record<StatusName, { readonly exit: number; readonly text: string }>> = {\n${rows.join('\n')}\n};\n`,
  ];
}

function exitParts(exitCodes) {
  const rows = exitCodes.map(({ name, code, text }) => {
    return `  ${object([
      ['code', code],
      ['name', name],
      ['text', text],
    ])},`;
  });
  return [
    '/** Exit codes of the command line program. */',
    `export const EXIT_CODES = [\n${rows.join('\n')}\n] as const;\n`,
  ];
}

function optionParts(options) {
  const types = options.map(({ name, type }) => `  readonly ${name}: ${OPTION_TYPES[type]};`);
  const values = options.map((option) => `  ${option.name}: ${literal(option.default)},`);
  const rows = options.map((option) => {
    const fields = ['type', 'default', ...BOUNDS, 'text'].filter((key) => key in option);
    const entries = fields.map((key) => [key, option[key]]);
    return `  ${option.name}: ${object([...entries, ['range', rangeText(option)]])},`;
  });
  return [
    `export interface FlattenDefaults {\n${types.join('\n')}\n}\n`,
    `export const FLATTEN_DEFAULTS: FlattenDefaults = {\n${values.join('\n')}\n};\n`,
    '/** Type, default, bounds and help text of every option; `range` says the bounds in words. */',
    `export const FLATTEN_OPTIONS = {\n${rows.join('\n')}\n} as const;`,
  ];
}

export function renderTypeScript({ exitCodes, statuses, flattenOptions }) {
  const parts = [
    HEADER,
    ...statusParts(statuses),
    ...exitParts(exitCodes),
    ...optionParts(flattenOptions),
  ];
  return `${parts.join('\n')}\n`;
}
