// The JSON Schema of files with rules for verify, which editors complete and check by.

import { ofProgram, sentence } from './schema.mjs';

const BOUNDS = {
  above: 'exclusiveMinimum',
  atLeast: 'minimum',
  below: 'exclusiveMaximum',
  atMost: 'maximum',
};

function numberOf(option) {
  const type = option.type === 'number' ? 'number' : 'integer';
  const bounds = Object.entries(BOUNDS).filter(([name]) => name in option);
  return { type, ...Object.fromEntries(bounds.map(([name, key]) => [key, option[name]])) };
}

function typeOf(option) {
  if (option.type === 'boolean') return { type: 'boolean' };
  const number = numberOf(option);
  const pair = { type: 'array', items: number, minItems: 2, maxItems: 2 };
  const words = Object.keys(option.words ?? {}).map((word) => ({ const: word }));
  const kinds = [number, ...(option.type === 'size' ? [pair] : []), ...words];
  return kinds.length > 1 ? { anyOf: kinds } : number;
}

export function renderRules(schema) {
  const properties = ofProgram(schema).verifyOptions.map((option) => [
    option.name,
    { description: sentence(option.text), default: option.default, ...typeOf(option) },
  ]);
  const rules = {
    $schema: 'https://json-schema.org/draft/2020-12/schema',
    title: 'Rules for abflat verify',
    type: 'object',
    properties: { $schema: { type: 'string' }, ...Object.fromEntries(properties) },
    additionalProperties: false,
  };
  return `${JSON.stringify(rules, null, 2)}\n`;
}
