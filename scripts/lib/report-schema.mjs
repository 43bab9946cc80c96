// The structs of reports: what core/schema/report.json may contain, and the full form of each
// field.

import { optionSets, pascalCase } from './schema.mjs';

/** Types that need no definition: in C++, in TypeScript and in words. */
export const PLAIN_TYPES = {
  number: { cpp: 'double', ts: 'number', words: 'number' },
  integer: { cpp: 'int', ts: 'number', words: 'integer' },
  count: { cpp: 'std::size_t', ts: 'number', words: 'integer' },
  index: { cpp: 'std::uint32_t', ts: 'number', words: 'integer' },
  long: { cpp: 'std::int64_t', ts: 'number', words: 'integer' },
  boolean: { cpp: 'bool', ts: 'boolean', words: 'boolean' },
  text: { cpp: 'std::string', ts: 'string', words: 'text' },
  pair: { cpp: 'std::array<std::uint32_t, 2>', ts: '[number, number]', words: 'pair of integers' },
  numbers: { cpp: 'std::vector<double>', ts: 'Float64Array', words: 'list of numbers' },
};
/**
 * Where a struct or a field may appear: in the C++ library, in the program's JSON, in the package.
 */
const PRODUCTS = ['cpp', 'cli', 'package'];
const FIELD_KEYS = [
  ...['name', 'type', 'list', 'fields', 'text', 'unit', 'default', 'in'],
  ...['null', 'nullIn', 'nullFields', 'absent'],
];

/** Whether a struct or a field is part of a product. */
export const isIn = ({ in: products = PRODUCTS }, product) => products.includes(product);

/** Whether a field may be null in the JSON of a product. */
export const isNullable = (field, product) =>
  'null' in field && [undefined, product].includes(field.nullIn);

/** Every type that a field may have, by name: plain ones, structs, enums, choices and options. */
export function typesOf(schema) {
  const types = new Map(Object.entries(PLAIN_TYPES));
  types.set('StatusName', { names: schema.statuses.map(({ name }) => name), words: 'status code' });
  for (const { name, values } of schema.enums)
    types.set(name, { names: values.map((value) => value.name), header: 'names' });
  for (const { verb, options, shared } of optionSets(schema)) {
    types.set(`${pascalCase(verb)}OptionValues`, { options, header: `${verb}_options` });
    for (const { name, choices } of options.filter((option) => !shared.includes(option.name)))
      if (choices)
        types.set(pascalCase(name), {
          names: choices.map((choice) => choice.name),
          packageNames: choices.filter(({ research }) => !research).map((choice) => choice.name),
          header: `${verb}_options`,
        });
  }
  for (const struct of schema.structs) types.set(struct.name, { struct, header: struct.header });
  return types;
}

/**
 * The schema with every field of every struct spelled out. Throws one sentence about what is wrong.
 */
export function resolveStructs(schema) {
  const done = new Map();
  for (const struct of schema.structs) {
    const resolved = { ...struct, fields: fieldsOf(struct, schema, done) };
    done.set(struct.name, resolved);
  }
  const structs = [...done.values()];
  const types = typesOf({ ...schema, structs });
  for (const struct of structs) checkStruct(struct, types);
  return { ...schema, structs };
}

function fieldsOf(struct, schema, done) {
  const { name, stagesOf, viewOf, fields } = struct;
  if (viewOf) return fields.map((field) => viewed(find(done, `${viewOf}.${field}`, name), struct));
  const stages = schema.enums
    .find((each) => each.name === 'Stage')
    .values.filter((value) => value.of.includes(stagesOf))
    .map((stage) => ({
      name: stage.name,
      type: 'number',
      ...(struct.unit && { unit: struct.unit }),
      text: stage.text,
    }));
  return [...stages, ...fields.map((field) => alike(field, name, done))];
}

/** A field of a view; the path is always known. */
function viewed(field, view) {
  if (field.type === 'text' || !view.null) return field;
  return { ...field, null: view.null, nullIn: view.nullIn };
}

/** A field given as text, or with `like`, is copied from another struct. */
function alike(field, owner, done) {
  if (typeof field === 'string') return find(done, field, owner);
  if (!('like' in field)) return field;
  const { like, ...changes } = field;
  const found = find(done, like, owner);
  if (found.type !== 'group') return { ...found, ...changes };
  const members = found.fields.map((member) => ({ ...member, ...changes }));
  return { ...found, ...changes, fields: members };
}

function find(done, path, owner) {
  const [struct, name] = path.split('.');
  const found = done.get(struct)?.fields.find((field) => field.name === name);
  if (!found) throw new Error(`${owner}: there is no field ${path} above it`);
  return found;
}

function checkStruct({ name, text, fields, cpp, viewOf, header, ...struct }, types) {
  if (!text) throw new Error(`${name} has no text`);
  if (!header && !cpp && isIn(struct, 'cpp')) throw new Error(`${name} has no header`);
  const names = new Set();
  for (const field of fields) {
    if (names.has(field.name)) throw new Error(`${name}: ${field.name} is listed twice`);
    names.add(field.name);
    checkField(field, name, types);
  }
}

function checkField(field, owner, types) {
  const where = `${owner}.${field.name}`;
  if (!/^[a-z][A-Za-z0-9]*$/.test(field.name)) throw new Error(`${where}: bad name`);
  if (!field.text) throw new Error(`${where} has no text`);
  for (const key of Object.keys(field))
    if (!FIELD_KEYS.includes(key)) throw new Error(`${where}: unknown key "${key}"`);
  for (const product of field.in ?? [])
    if (!PRODUCTS.includes(product)) throw new Error(`${where}: unknown product "${product}"`);
  if (field.type === 'group') for (const member of field.fields) checkField(member, where, types);
  else if (!types.has(field.type)) throw new Error(`${where}: unknown type "${field.type}"`);
}
