// The Python side of the schema: the options of each call, with their types.

import {
  constantCase,
  fullText,
  kebabCase,
  ofPackage,
  optionSets,
  pascalCase,
  rangeText,
} from './schema.mjs';

const HEADER = `# Generated from core/schema by scripts/generate.mjs, do not edit.
"""The options of each call."""

from __future__ import annotations

from typing import Literal, NamedTuple, TypedDict, Union

Value = Union[bool, float, str]


class OptionInfo(NamedTuple):
    """An option: its name in the schema, its default, its range and what it does."""

    name: str
    default: Value
    range: str
    text: str
`;

const TYPES = {
  number: 'float',
  integer: 'int',
  size: 'Union[int, tuple[int, int]]',
  boolean: 'bool',
};

/** Python reads JSON's texts and numbers the same way. */
const literal = (value) => {
  if (typeof value === 'boolean') return value ? 'True' : 'False';
  return JSON.stringify(value);
};

const snakeCase = (name) => kebabCase(name).replaceAll('-', '_');

function typeOf({ type, words, choices }) {
  const texts = choices?.map(({ name }) => name) ?? Object.keys(words ?? {});
  const named = texts.length > 0 ? `Literal[${texts.map(literal).join(', ')}]` : undefined;
  if (type === 'choice') return named;
  return named ? `Union[${TYPES[type]}, ${named}]` : TYPES[type];
}

const infoOf = (option) =>
  `    ${literal(snakeCase(option.name))}: OptionInfo(${[
    option.name,
    option.default,
    rangeText(option, '(2048, 1024)'),
    fullText(option),
  ]
    .map(literal)
    .join(', ')}),`;

function renderSet({ verb, text, options }) {
  const types = options.map((option) => `    ${snakeCase(option.name)}: ${typeOf(option)}`);
  return [
    `\nclass ${pascalCase(verb)}Options(TypedDict, total=False):\n    """${text}"""\n\n${types.join('\n')}\n`,
    `\n${verb.toUpperCase()}_OPTIONS: dict[str, OptionInfo] = {\n${options.map(infoOf).join('\n')}\n}\n`,
  ];
}

/** A value for each bit. */
function renderBits({ name, text, values }) {
  const bits = values.map((value, i) => `    ${literal(value.name)}: ${1 << i},`);
  return `\n# The bits for ${text}.\n${constantCase(name)}: dict[str, int] = {\n${bits.join('\n')}\n}\n`;
}

/** Baking is for files, which Python does not read. */
export function renderPython(schema) {
  const sets = optionSets(ofPackage(schema)).filter(({ verb }) => verb !== 'bake');
  const bits = schema.enums.filter((each) => each.bits).map(renderBits);
  return `${[HEADER, ...sets.flatMap(renderSet), ...bits].join('\n').trimEnd()}\n`;
}
