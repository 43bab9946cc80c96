// The C++ side of the schema: two headers, excluded from clang-format.

import { BOUNDS, pascalCase, rangeText } from './schema.mjs';

const HEADER = `// Generated from core/schema/abflat.json by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once
`;

const CPP_TYPES = { number: 'double', integer: 'int', boolean: 'bool' };

/**
 * A JSON string is a valid C++ string literal as long as it is ASCII; the schema's texts are UTF-8
 * as is.
 */
const literal = (text) => JSON.stringify(text);

function enumClass(name, comment, entries) {
  const lines = entries.map(([id, value, text]) => `  ${id} = ${value},  ///< ${text}`);
  return `/// ${comment}\nenum class ${name} : int {\n${lines.join('\n')}\n};\n`;
}

/** Cases with the same value share one return. */
function switchFunction(signature, type, cases, fallback) {
  const labels = new Map();
  for (const [id, value] of cases) {
    labels.set(value, [...(labels.get(value) ?? []), `    case ${type}::${id}:`]);
  }
  const lines = [...labels].map(([value, group]) => `${group.join('\n')}\n      return ${value};`);
  return `${signature} {\n  switch (code) {\n${lines.join('\n')}\n  }\n  return ${fallback};\n}\n`;
}

export function renderStatusCode({ exitCodes, statuses }) {
  const exitName = (code) => exitCodes.find((exit) => exit.code === code).name;
  const parts = [
    HEADER,
    'namespace abflat {\n',
    enumClass(
      'ExitCode',
      'What the command line program returns.',
      exitCodes.map(({ name, code, text }) => [name, code, text]),
    ),
    enumClass(
      'StatusCode',
      'Why a call has no result.',
      statuses.map(({ name, text }, i) => [name, i, text]),
    ),
    `constexpr int kExitCodeCount = ${exitCodes.length};`,
    `constexpr int kStatusCodeCount = ${statuses.length};\n`,
    '/// "NonManifoldEdge"; the name that reports and error objects carry.',
    switchFunction(
      'inline const char* statusName(StatusCode code)',
      'StatusCode',
      statuses.map(({ name }) => [name, literal(name)]),
      literal('Internal'),
    ),
    '/// What the status means, without the place.',
    switchFunction(
      'inline const char* statusText(StatusCode code)',
      'StatusCode',
      statuses.map(({ name, text }) => [name, literal(text)]),
      literal(''),
    ),
    '/// Exit code of the program that ends with this status.',
    switchFunction(
      'inline int exitCodeOf(StatusCode code)',
      'StatusCode',
      statuses.map(({ name, exit }) => [name, `static_cast<int>(ExitCode::${exitName(exit)})`]),
      'static_cast<int>(ExitCode::NotFlattenable)',
    ),
    '/// What the exit code means, for the help text.',
    switchFunction(
      'inline const char* exitCodeText(ExitCode code)',
      'ExitCode',
      exitCodes.map(({ name, text }) => [name, literal(text)]),
      literal(''),
    ),
    '}  // namespace abflat',
  ];
  return `${parts.join('\n')}\n`;
}

function optionLines(option) {
  const id = pascalCase(option.name);
  const type = CPP_TYPES[option.type];
  const lines = [`constexpr ${type} k${id} = ${option.default};`];
  for (const bound of BOUNDS) {
    if (bound in option)
      lines.push(`constexpr ${type} k${id}${pascalCase(bound)} = ${option[bound]};`);
  }
  lines.push(`constexpr const char* k${id}Help = ${literal(option.text)};`);
  if (type !== 'bool') {
    lines.push(`constexpr const char* k${id}Range = ${literal(rangeText(option))};`);
    lines.push(`/// Finite and within the bounds.`);
    lines.push(
      `constexpr bool isValid${id}(${type} value) {\n  return ${condition(option, type, id)};\n}`,
    );
  }
  return `${lines.join('\n')}\n`;
}

/** Comparisons that are false for NaN. */
function condition(option, type, id) {
  const operators = { above: '>', atLeast: '>=', below: '<', atMost: '<=' };
  const terms = BOUNDS.filter((bound) => bound in option).map(
    (bound) => `value ${operators[bound]} k${id}${pascalCase(bound)}`,
  );
  if (!('above' in option || 'atLeast' in option)) {
    terms.push(`value >= std::numeric_limits<${type}>::lowest()`);
  }
  if (!('below' in option || 'atMost' in option)) {
    terms.push(`value <= std::numeric_limits<${type}>::max()`);
  }
  return terms.join(' && ');
}

export function renderFlattenDefaults({ flattenOptions }) {
  const parts = [
    HEADER,
    '#include <limits>\n',
    '/// Defaults, bounds and help texts of FlattenOptions.',
    'namespace abflat::defaults {\n',
    ...flattenOptions.map(optionLines),
    '}  // namespace abflat::defaults',
  ];
  return `${parts.join('\n')}\n`;
}
