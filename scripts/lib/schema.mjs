// What core/schema/abflat.json may contain. Everything generated relies on these checks.

export const OPTION_TYPES = { number: 'number', integer: 'number', boolean: 'boolean' };
export const BOUNDS = ['above', 'atLeast', 'below', 'atMost'];

const BOUND_WORDS = { above: 'above', atLeast: 'at least', below: 'below', atMost: 'at most' };

/** Returns the schema, or throws one sentence that names the entry at fault. */
export function checkSchema(schema) {
  checkUnique(schema.exitCodes, 'exitCodes');
  checkUnique(schema.statuses, 'statuses');
  checkUnique(schema.flattenOptions, 'flattenOptions');
  const exits = new Set(schema.exitCodes.map((exit) => exit.code));
  for (const status of schema.statuses) {
    if (!exits.has(status.exit)) {
      throw new Error(`status ${status.name}: there is no exit code ${status.exit}`);
    }
  }
  for (const option of schema.flattenOptions) checkOption(option);
  return schema;
}

function checkUnique(entries, list) {
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
  if (typeof option.default !== jsType)
    throw new Error(`option ${option.name}: default is not a ${jsType}`);
  for (const bound of BOUNDS) {
    if (!(bound in option)) continue;
    if (jsType !== 'number' || typeof option[bound] !== 'number') {
      throw new Error(`option ${option.name}: "${bound}" needs a number type and a number`);
    }
  }
}

/** "above 0 and at most 2" for people; empty without bounds. */
export function rangeText(option) {
  const parts = BOUNDS.filter((bound) => bound in option);
  return parts.map((bound) => `${BOUND_WORDS[bound]} ${option[bound]}`).join(' and ');
}

export function pascalCase(name) {
  return name[0].toUpperCase() + name.slice(1);
}
