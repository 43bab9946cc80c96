// What core/schema may contain. Everything generated relies on these checks.

export const OPTION_TYPES = {
  number: 'number',
  integer: 'number',
  size: 'number',
  boolean: 'boolean',
  choice: 'string',
};
export const BOUNDS = ['above', 'atLeast', 'below', 'atMost'];

const BOUND_WORDS = { above: 'above', atLeast: 'at least', below: 'below', atMost: 'at most' };

/** Returns the schema, or throws one sentence that names the entry at fault. */
export function checkSchema(schema) {
  checkUnique(schema.exitCodes, 'exitCodes');
  checkUnique(schema.statuses, 'statuses');
  const own = schema.statuses.filter((status) => !isOptionOf(status, 'cli'));
  if (own.some((status, i) => status !== schema.statuses.at(i - own.length)))
    throw new Error('statuses: those of the package alone come last');
  const exits = new Set(schema.exitCodes.map((exit) => exit.code));
  for (const status of schema.statuses) {
    if (!exits.has(status.exit)) {
      throw new Error(`status ${status.name}: there is no exit code ${status.exit}`);
    }
  }
  checkUnique(schema.flattenOptions, 'flattenOptions');
  for (const option of schema.flattenOptions) checkOption(option);
  const { flattenOptions } = schema;
  const unwrapOptions = resolvedSet('unwrapOptions', schema, flattenOptions);
  const packOptions = resolvedSet('packOptions', schema, [...unwrapOptions, ...flattenOptions]);
  const bakeOptions = resolvedSet('bakeOptions', schema, [...unwrapOptions, ...flattenOptions]);
  const verifyOptions = resolvedSet('verifyOptions', schema, unwrapOptions);
  for (const { name, values } of schema.enums) checkUnique(values, `enum ${name}`);
  checkUnique(schema.enums, 'enums');
  return { ...schema, unwrapOptions, packOptions, bakeOptions, verifyOptions };
}

/** A set whose options may be those of others: by name alone, or with `like` and what differs. */
function resolvedSet(list, schema, others) {
  const options = schema[list].map((option) => {
    const { like, ...changes } = typeof option === 'string' ? { like: option } : option;
    if (!like) return option;
    const found = others.find(({ name }) => name === like);
    if (!found) throw new Error(`${list}: there is no option "${like}" in another set`);
    return typeof option === 'string' ? found : { ...found, ...changes };
  });
  checkUnique(options, list);
  for (const option of options) checkOption(option);
  return options;
}

/**
 * The sets of options: their names, their options, and which of those another set has defined. A
 * set of which a product has none is left out.
 */
export function optionSets(schema) {
  const { flattenOptions, unwrapOptions, packOptions, bakeOptions, verifyOptions } = schema;
  return [
    {
      verb: 'flatten',
      text: 'The options of flattening that are plain values, with their defaults.',
      options: flattenOptions,
      shared: [],
    },
    {
      verb: 'unwrap',
      text: 'The options of unwrapping that are plain values, with their defaults.',
      options: unwrapOptions,
      shared: namesOf(flattenOptions),
    },
    {
      verb: 'pack',
      text: 'The options of packing a layout that are plain values, with their defaults.',
      options: packOptions,
      shared: namesOf([...flattenOptions, ...unwrapOptions]),
    },
    {
      verb: 'bake',
      text: 'The options of baking that are plain values, with their defaults.',
      options: bakeOptions,
      shared: namesOf([...flattenOptions, ...unwrapOptions]),
    },
    {
      verb: 'verify',
      text: 'What a layout must keep to, as plain values, with their defaults.',
      options: verifyOptions,
      shared: namesOf(unwrapOptions),
    },
  ].filter(({ options }) => options.length > 0);
}

const namesOf = (options) => options.map(({ name }) => name);

/** Whether an option is one of a product: `package`, or `cli`, for which C++ has it. */
export const isOptionOf = ({ in: products = OPTION_PRODUCTS }, product) =>
  products.includes(product);

const OPTION_PRODUCTS = ['cli', 'package'];

/** The schema without the options and statuses of the package alone. */
export function ofProgram(schema) {
  return {
    ...schema,
    statuses: schema.statuses.filter((status) => isOptionOf(status, 'cli')),
    bakeOptions: schema.bakeOptions.filter((option) => isOptionOf(option, 'cli')),
  };
}

/**
 * The schema without what the npm package lacks: options of the program alone, and what is for
 * research. Of that, the remaining ones keep the numbers they have in C++, so they must come first.
 */
export function ofPackage(schema) {
  const kept = (options) =>
    leading(options, 'options').map((option) =>
      option.choices?.some(({ research }) => research)
        ? { ...option, choices: leading(option.choices, `option ${option.name}`) }
        : option,
    );
  return {
    ...schema,
    flattenOptions: kept(schema.flattenOptions),
    unwrapOptions: kept(schema.unwrapOptions),
    packOptions: kept(schema.packOptions),
    verifyOptions: schema.verifyOptions.filter((option) => isOptionOf(option, 'package')),
    bakeOptions: schema.bakeOptions.filter((option) => isOptionOf(option, 'package')),
  };
}

function leading(entries, where) {
  const count = entries.filter(({ research }) => !research).length;
  const late = entries.slice(count).find(({ research }) => !research);
  if (late) throw new Error(`${where}: ${late.name} follows one that is for research`);
  return entries.slice(0, count);
}

/** Throws if an entry of a list has no proper name, no text, or a name that another has. */
export function checkUnique(entries, list) {
  const names = new Set();
  for (const { name, text } of entries) {
    if (!/^[A-Za-z][A-Za-z0-9]*$/.test(name)) throw new Error(`${list}: bad name "${name}"`);
    if (names.has(name)) throw new Error(`${list}: ${name} is listed twice`);
    if (typeof text !== 'string' || text === '') throw new Error(`${list}: ${name} has no text`);
    names.add(name);
  }
}

function checkOption(option) {
  const jsType = OPTION_TYPES[option.type];
  if (!jsType) throw new Error(`option ${option.name}: unknown type "${option.type}"`);
  for (const product of option.in ?? [])
    if (!OPTION_PRODUCTS.includes(product))
      throw new Error(`option ${option.name}: unknown product "${product}"`);
  if (option.type === 'choice') return checkChoice(option);
  if ('unit' in option && !(option.unit in UNITS && jsType === 'number'))
    throw new Error(`option ${option.name}: unknown unit "${option.unit}"`);
  if (['integer', 'size'].includes(option.type) && !('atLeast' in option && 'atMost' in option))
    throw new Error(`option ${option.name}: an integer needs "atLeast" and "atMost"`);
  const isWord = option.words && Object.hasOwn(option.words, option.default);
  if (typeof option.default !== jsType && !isWord)
    throw new Error(`option ${option.name}: default is not a ${jsType}`);
  for (const bound of BOUNDS) {
    if (!(bound in option)) continue;
    if (jsType !== 'number' || typeof option[bound] !== 'number') {
      throw new Error(`option ${option.name}: "${bound}" needs a number type and a number`);
    }
  }
}

function checkChoice(option) {
  checkUnique(option.choices ?? [], `option ${option.name}`);
  if (!option.choices?.some(({ name }) => name === option.default))
    throw new Error(`option ${option.name}: default is not one of its choices`);
}

/**
 * "above 0 and at most 2, or auto" for people; empty without bounds. `pair`: how a width and a
 * height are written.
 */
export function rangeText(option, pair) {
  if (option.type === 'choice') return option.choices.map(({ name }) => name).join(', ');
  const bounds = BOUNDS.filter((bound) => bound in option);
  const limits = bounds.map((bound) => `${BOUND_WORDS[bound]} ${option[bound]}`).join(' and ');
  const isSize = option.type === 'size';
  const whole = (isSize || option.type === 'integer') && 'whole';
  const parts = [limits, whole, isSize && `or two of these, as in ${pair}`]
    .filter(Boolean)
    .join(', ');
  return [parts, ...Object.keys(option.words ?? {})].filter(Boolean).join(', or ');
}

/**
 * Units that an option may be written with on a command line, as in "3G", and their size in the
 * option's own unit.
 */
export const UNITS = { MB: { M: 1, G: 1024, T: 1024 * 1024 } };

/** The text of an option with the meaning of its choices. */
export function fullText(option) {
  if (option.type !== 'choice') return option.text;
  return `${option.text}: ${option.choices.map(({ name, text }) => `${name} = ${text}`).join('; ')}`;
}

/** The option's command line flag; a boolean's flag is named after the effect of giving it. */
export function flagOf({ name, default: value }) {
  return `--${value === true ? 'no-' : ''}${kebabCase(name)}`;
}

/** A text as a whole sentence. */
export function sentence(text) {
  return `${pascalCase(text)}.`;
}

export function pascalCase(name) {
  return name[0].toUpperCase() + name.slice(1);
}

export const constantCase = (name) =>
  kebabCase(name[0].toLowerCase() + name.slice(1))
    .replaceAll('-', '_')
    .toUpperCase();

export function kebabCase(name) {
  return name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
}
