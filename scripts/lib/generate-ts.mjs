// The TypeScript side of the schema.

import { coreFormats, writtenFormats } from './formats.mjs';
import { isIn } from './report-schema.mjs';
import {
  BOUNDS,
  constantCase,
  fullText,
  OPTION_TYPES,
  ofPackage,
  ofProgram,
  optionSets,
  pascalCase,
  rangeText,
  sentence,
} from './schema.mjs';

export const TS_HEADER = '// Generated from core/schema by scripts/generate.mjs, do not edit.\n';

export function literal(value) {
  if (typeof value !== 'string') return String(value);
  return `'${value.replace(/\\/g, '\\\\').replace(/'/g, "\\'").replace(/\n/g, '\\n')}'`;
}

function object(entries) {
  return `{ ${entries.map(([key, value]) => `${key}: ${literal(value)}`).join(', ')} }`;
}

function statusParts({ statuses }, { statuses: ofModule }) {
  const names = statuses.map(({ name }) => literal(name));
  const rows = statuses.map(({ name, exit, text }) => {
    return `  ${name}: ${object([
      ['exit', exit],
      ['text', text],
    ])},`;
  });
  return [
    `/** Those of the module, in the order of the C++ enum (index = number of the code), then the package's own. */`,
    `export const STATUS_NAMES = [\n${names.map((name) => `  ${name},`).join('\n')}\n] as const;\n`,
    `export const MODULE_STATUS_COUNT = ${ofModule.length};\n`,
    'export type StatusName = (typeof STATUS_NAMES)[number];\n',
    '/** Exit code of the command line program and meaning of every status. */',
    `export const STATUSES: Readonly<Record<StatusName, { readonly exit: number; readonly text: string }>> = {\n${rows.join('\n')}\n};\n`,
  ];
}

export const union = (names) => names.map((name) => literal(name)).join(' | ');

function tsType(option) {
  if (option.type === 'choice') return pascalCase(option.name);
  const pair = option.type === 'size' ? ['readonly [width: number, height: number]'] : [];
  return [OPTION_TYPES[option.type], ...pair, ...Object.keys(option.words ?? {}).map(literal)].join(
    ' | ',
  );
}

/** What a caller may pass, checked by type against the row below it. */
function infoFields(option) {
  const fields = ['type', 'default', ...BOUNDS].filter((key) => key in option);
  const entries = fields.map((key) => `${key}: ${literal(option[key])}`);
  if (option.words) entries.push(`words: ${object(Object.entries(option.words))}`);
  if (option.choices)
    entries.push(`choices: [${option.choices.map(({ name }) => literal(name)).join(', ')}]`);
  entries.push(
    `text: ${literal(fullText(option))}`,
    `range: ${literal(rangeText(option, '[2048, 1024]'))}`,
  );
  return `  ${option.name}: { ${entries.join(', ')} },`;
}

function optionParts({ verb, text, options, shared }) {
  const choices = options.filter(({ type }) => type === 'choice');
  const aliases = choices
    .filter((option) => !shared.includes(option.name))
    .map(
      ({ name, choices: list }) =>
        `export type ${pascalCase(name)} = ${union(list.map((choice) => choice.name))};\n`,
    );
  const types = options.map((option) => `  ${option.name}: ${tsType(option)};`);
  const values = options.map((option) => `  ${option.name}: ${literal(option.default)},`);
  const name = pascalCase(verb);
  // Their defaults are squares.
  const squares = options
    .filter(({ type, default: value }) => type === 'size' && typeof value === 'number')
    .map((option) => ` & { readonly ${option.name}: number }`);
  return [
    ...aliases,
    `/** ${text} */`,
    `export interface ${name}OptionValues {\n${types.join('\n')}\n}\n`,
    `export const ${verb.toUpperCase()}_DEFAULTS: Readonly<${name}OptionValues>${squares.join('')} = {\n${values.join('\n')}\n};\n`,
    '/** Type, default, bounds and help text of every option, in the order of the C++ side; `range` says the bounds in words. */',
    `export const ${verb.toUpperCase()}_OPTIONS = {\n${options.map(infoFields).join('\n')}\n} as const;\n`,
  ];
}

const unionType = (name, text, names) =>
  `/** ${sentence(text)} */\nexport type ${name} = ${union(names)};\n`;

/** A constant for each value that is a bit. */
const bitsOf = (name, text, values) =>
  `/** The bits for ${text}. */\nexport const ${constantCase(name)} = ${object(values.map((value, i) => [value.name, 1 << i]))} as const;\n`;

/** In a file of their own, so that who needs a bit does not load the texts of options. */
export function renderBits(schema) {
  const parts = schema.enums
    .filter(({ bits }) => bits)
    .map(({ name, text, values }) => bitsOf(name, text, values));
  return `${[TS_HEADER, ...parts].join('\n').trimEnd()}\n`;
}

/** A union of all names, or of the stages of each call of the package. */
function enumParts(schema) {
  return schema.enums.flatMap(({ name, text, values, bits, ...products }) => {
    if (bits || !isIn(products, 'package')) return [];
    const all = new Set(values.flatMap((value) => value.of ?? []));
    if (all.size === 0)
      return unionType(
        name,
        text,
        values.map((value) => value.name),
      );
    return [...all].map((call) =>
      unionType(
        `${pascalCase(call)}${name}`,
        `${text} of ${call}`,
        values.filter((value) => value.of.includes(call)).map((value) => value.name),
      ),
    );
  });
}

/** Arrays that a caller may pass to `unwrap`, in the order of the C++ enum. */
function arrayParts({ unwrapArrays }) {
  const types = { number: 'Float32Array | Float64Array', index: 'Uint32Array' };
  const fields = unwrapArrays.map(
    ({ name, type, word, text }) =>
      `  /** ${sentence(text)} */\n  ${name}?: ${types[type]}${word ? ` | ${literal(word)}` : ''};`,
  );
  const rows = unwrapArrays.map(({ name, type, of, multiple = 1, word }) => {
    const entries = Object.entries({ type, ...(of && { of }), multiple, ...(word && { word }) });
    return `  ${name}: ${object(entries)},`;
  });
  return [
    `export interface UnwrapArrays {\n${fields.join('\n')}\n}\n`,
    '/** Element types, what they are numbers of, and what may stand for them, in the order of the C++ side. */',
    `export const UNWRAP_ARRAYS = {\n${rows.join('\n')}\n} as const;\n`,
  ];
}

/** The files that the module writes, in the order of the C++ enum. */
const moduleFiles = ({ formats }) => writtenFormats(coreFormats(formats));

function fileParts(schema) {
  const files = moduleFiles(schema);
  const rounded = ' The layout is rounded to single precision if it stays valid.';
  const options = files.map(
    ({ name, title, precision }) =>
      `  /** Also return the input as ${title} with the new texcoords.${precision === 'single' ? rounded : ''} */\n  ${name}?: boolean;`,
  );
  const results = files.map(
    ({ name, title, encoding }) =>
      `  /** ${title} when asked for with \`${name}: true\`, ${encoding}. */\n  ${name}?: Uint8Array;`,
  );
  return [
    `export const WRITTEN_FORMATS = [${files.map(({ name }) => literal(name)).join(', ')}] as const;\n`,
    'export type WrittenFormat = (typeof WRITTEN_FORMATS)[number];\n',
    `export interface FileOptions {\n${options.join('\n')}\n}\n`,
    `export interface Files {\n${results.join('\n')}\n}\n`,
  ];
}

/** Options whose code is loaded when they are first used, so each set has a file of its own. */
const isLate = ({ verb }) => ['bake', 'verify'].includes(verb);

export const lateSets = (schema) => optionSets(ofPackage(schema)).filter(isLate);

/** By verb, the file of each of these sets. */
export const renderLateOptions = (schema) =>
  lateSets(schema).map((set) => [
    set.verb,
    `${[TS_HEADER, ...optionParts(set)].join('\n').trimEnd()}\n`,
  ]);

/** What the options are for that the page has controls for; of verify, all that the package knows of them. */
export function renderOptionTexts({ unwrapOptions, packOptions, verifyOptions }) {
  const table = (name, options) => {
    const rows = options.map((option) => `  ${option.name}: ${literal(fullText(option))},`);
    return `export const ${name} = {\n${rows.join('\n')}\n} as const;\n`;
  };
  return [
    TS_HEADER,
    table('UNWRAP_TEXTS', unwrapOptions),
    table('PACK_TEXTS', packOptions),
    `export const VERIFY_OPTIONS = {\n${verifyOptions.map(infoFields).join('\n')}\n} as const;\n`,
  ].join('\n');
}

export function renderTypeScript(schema) {
  const parts = [
    TS_HEADER,
    ...statusParts(schema, ofProgram(schema)),
    ...optionSets(ofPackage(schema))
      .filter((set) => !isLate(set))
      .flatMap(optionParts),
    ...enumParts(schema),
    ...arrayParts(schema),
    ...fileParts(schema),
  ];
  return `${parts.join('\n').trimEnd()}\n`;
}

/**
 * What the module returns, by name: arrays, then files; their numbers and element types. What each
 * is stays in the schema, since workers are sent with the comments of this object.
 */
export function renderResultArrays(schema) {
  const kinds = { number: 'Float64Array', index: 'Uint32Array', byte: 'Uint8Array' };
  const files = moduleFiles(schema).map(({ name }) => ({ name, type: 'byte' }));
  const rows = [...schema.resultArrays, ...files].map(
    ({ name, type }, i) => `  ${name}: { field: ${i}, Kind: ${kinds[type]} },`,
  );
  const comment = '/** What the module has after a call; `field` is the number of the C++ enum. */';
  return `${TS_HEADER}\n${comment}\nexport const RESULT_ARRAYS = {\n${rows.join('\n')}\n} as const;\n`;
}
