// The C++ side of the schema: headers that are excluded from clang-format.

import { BOUNDS, flagOf, fullText, pascalCase, rangeText, sentence, UNITS } from './schema.mjs';

export const HEADER = `// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once
`;

const CPP_TYPES = { number: 'double', integer: 'int', size: 'AtlasSize', boolean: 'bool' };

const cppType = (option) =>
  option.type === 'choice' ? pascalCase(option.name) : CPP_TYPES[option.type];

/** C++ reads JSON's escapes the same way. */
export const literal = (text) => JSON.stringify(text);

export function enumClass(name, comment, entries, type = 'int') {
  const lines = entries.map(([id, value, text]) => `  ${id} = ${value},  ///< ${text}`);
  return `/// ${comment}\nenum class ${name} : ${type} {\n${lines.join('\n')}\n};\n`;
}

/** Cases with the same value share one return. */
export function switchFunction(signature, type, cases, fallback) {
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

/** The enum of a choice and its names. */
function choiceParts({ name, text, choices }) {
  const id = pascalCase(name);
  return [
    enumClass(
      id,
      sentence(text),
      choices.map((choice, i) => [pascalCase(choice.name), i, choice.text]),
    ),
    switchFunction(
      `inline const char* nameOf(${id} code)`,
      id,
      choices.map((choice) => [pascalCase(choice.name), literal(choice.name)]),
      literal(''),
    ),
  ];
}

/** GCC up to 12 mistakes a name of a scoped enum for one of the enclosing namespace. */
const NO_SHADOW = '#pragma GCC diagnostic push\n#pragma GCC diagnostic ignored "-Wshadow"\n';

/**
 * Enums for reports and progress, one byte each, since there may be as many charts as triangles.
 */
export function renderNames({ enums }) {
  const parts = enums.flatMap(({ name, text, values, bits, explained }) => [
    enumClass(
      name,
      sentence(text),
      values.map((value, i) => [pascalCase(value.name), bits ? 1 << i : i, value.text]),
      'std::uint8_t',
    ),
    switchFunction(
      `inline const char* nameOf(${name} code)`,
      name,
      values.map((value) => [pascalCase(value.name), literal(value.name)]),
      literal(''),
    ),
    ...(explained ? explanations(name, values) : []),
  ]);
  const head = [HEADER, '#include <cstdint>\n', NO_SHADOW, 'namespace abflat {\n'];
  const tail = ['}  // namespace abflat\n', '#pragma GCC diagnostic pop'];
  return `${[...head, ...parts, ...tail].join('\n')}\n`;
}

/** What each value means, as text, and how many there are. */
function explanations(name, values) {
  return [
    switchFunction(
      `inline const char* textOf(${name} code)`,
      name,
      values.map((value) => [pascalCase(value.name), literal(value.text)]),
      literal(''),
    ),
    `constexpr int k${name}Count = ${values.length};\n`,
  ];
}

/** The arrays that JavaScript writes for `unwrap`. */
export function renderUnwrapArrays({ unwrapArrays }) {
  const parts = [
    HEADER,
    '#include "abflat/unwrap.h"\n',
    'namespace abflat::bindings {\n',
    enumClass(
      'UnwrapArray',
      'Arrays among the options of unwrap.',
      unwrapArrays.map(({ name, text }, i) => [pascalCase(name), i, text]),
    ),
    '/// What `take` returns for the array.',
    'template <class Take>',
    'auto takeArray(UnwrapOptions& options, UnwrapArray which, const Take& take) {',
    '  switch (which) {',
    ...unwrapArrays.map(
      ({ name, field }) =>
        `    case UnwrapArray::${pascalCase(name)}:\n      return take(options.${field});`,
    ),
    '  }',
    `  return take(options.${unwrapArrays[0].field});`,
    '}\n',
    '}  // namespace abflat::bindings',
  ];
  return `${parts.join('\n')}\n`;
}

/** The arrays that JavaScript reads, and then files. */
export function renderField({ resultArrays }) {
  const entries = resultArrays.map(({ name, text }, i) => [pascalCase(name), i, text]);
  const parts = [
    HEADER,
    'namespace abflat::bindings {\n',
    enumClass('Field', 'What JavaScript can read from a finished job.', entries),
    '/// The file of the first MeshFormat, as a Field; those of the others follow.',
    `constexpr int kFirstFile = ${resultArrays.length};\n`,
    '}  // namespace abflat::bindings',
  ];
  return `${parts.join('\n')}\n`;
}

function numberOf(option, value) {
  return Object.hasOwn(option.words ?? {}, value) ? option.words[value] : value;
}

function defaultOf(option) {
  if (option.type === 'choice') return `${cppType(option)}::${pascalCase(option.default)}`;
  return String(numberOf(option, option.default));
}

function wordConstants(option) {
  return Object.entries(option.words ?? {}).map(
    ([word, value]) =>
      `/// "${word}" as a value of the option ${option.name}.\nconstexpr ${cppType(option)} k${pascalCase(word)}${pascalCase(option.name)} = ${value};`,
  );
}

function infoRow(option) {
  const cells = [
    literal(option.name),
    literal(flagOf(option)),
    literal(String(option.default)),
    literal(rangeText(option, '2048x1024')),
    literal(option.default === true ? `do not ${fullText(option)}` : fullText(option)),
    String(option.type === 'boolean'),
    String(option.type === 'choice'),
  ];
  return `    {${cells.join(', ')}},`;
}

/**
 * The condition that a number must meet, and its converted value. Nothing is cast before it is
 * known to fit.
 */
function settingOf(option) {
  const type = cppType(option);
  const isWhole = 'value == std::trunc(value)';
  switch (option.type) {
    case 'boolean':
      return ['value == 0 || value == 1', 'value != 0'];
    case 'choice':
      return [
        `value >= 0 && value < ${option.choices.length} && ${isWhole}`,
        `static_cast<${type}>(static_cast<int>(value))`,
      ];
    case 'integer':
      return [`(${condition(option)}) && ${isWhole}`, 'static_cast<int>(value)'];
    default:
      return [condition(option), `static_cast<${type}>(value)`];
  }
}

/**
 * Sets an option from the number that JavaScript passes for it: choices by index, words by value.
 */
function setCase(option, index) {
  if (option.type === 'size') return setSizeCase(option, index);
  const [isFine, fitting] = settingOf(option);
  return `    case ${index}:\n      if (!(${isFine})) return false;\n      options.${option.name} = ${fitting};\n      return true;`;
}

function setSizeCase({ name, atLeast, atMost, words }, index) {
  const isWithin = `size.shorter() >= ${atLeast} && size.longer() <= ${atMost}`;
  const isWord = Object.values(words ?? {}).map((value) => `(isWord && value == ${value})`);
  const isFine = [`(${isWithin})`, ...isWord].join(' || ');
  return `    case ${index}: {\n      const AtlasSize size = atlasSize(value, isWord);\n      if (!(${isFine})) return false;\n      options.${name} = size;\n      return true;\n    }`;
}

/** The number of a word or choice as written on a command line. */
function wordCases(option, index) {
  const words =
    option.type === 'choice'
      ? option.choices.map(({ name }, i) => [name, i])
      : Object.entries(option.words ?? {});
  const lines = words.map(
    ([word, value]) =>
      `  if (index == ${index} && text == ${literal(word)}) return found = true, ${value};`,
  );
  if (option.type === 'size')
    lines.push(`  if (index == ${index}) return atlasSizeValue(text, found);`);
  return lines;
}

/** The value of a number with a unit letter, such as "3G", in the option's unit. */
function unitCases({ unit }, index) {
  return Object.entries(UNITS[unit] ?? {}).map(
    ([letter, size]) => `  if (index == ${index} && letter == '${letter}') return ${size};`,
  );
}

/** Comparisons that are false for NaN. */
function condition(option) {
  const operators = { above: '>', atLeast: '>=', below: '<', atMost: '<=' };
  const terms = BOUNDS.filter((bound) => bound in option).map(
    (bound) => `value ${operators[bound]} ${option[bound]}`,
  );
  if (!('above' in option || 'atLeast' in option)) {
    terms.push('value >= std::numeric_limits<double>::lowest()');
  }
  if (!('below' in option || 'atMost' in option)) {
    terms.push('value <= std::numeric_limits<double>::max()');
  }
  const words = Object.values(option.words ?? {}).map((value) => `(isWord && value == ${value})`);
  return words.length > 0 ? `(${terms.join(' && ')}) || ${words.join(' || ')}` : terms.join(' && ');
}

function visitLine(option) {
  const value =
    option.type === 'choice' ? `nameOf(options.${option.name})` : `options.${option.name}`;
  const words = Object.entries(option.words ?? {}).map(
    ([word, number]) =>
      `  if (options.${option.name} == ${number})\n    visit("${option.name}", ${literal(word)});\n  else\n  `,
  );
  return `${words.join('')}  visit("${option.name}", ${value});`;
}

/** Shared by the headers of all option sets. */
const OPTION_INFO = [
  '/// An option for people: names, default and range as on the command line.',
  'struct OptionInfo {\n  const char* name;\n  const char* flag;\n  const char* defaultText;\n  const char* range;\n  const char* help;\n  bool isSwitch;  ///< takes no value\n  bool isChoice;  ///< takes one of the words of its range\n};\n',
  '/// The options of a set, in the order of the numbers that setOption takes.',
  'struct OptionInfos {\n  const OptionInfo* first;\n  int count;\n\n  const OptionInfo& operator[](int index) const { return first[index]; }\n};\n',
];

/**
 * The functions are overloaded on the type of the values; if they do not use the values, the
 * parameter has no name.
 */
function optionFunctions(values, options) {
  return [
    `inline OptionInfos optionInfos(const ${values}&) {\n  static constexpr OptionInfo kInfos[] = {\n${options.map(infoRow).join('\n')}\n  };\n  return {kInfos, ${options.length}};\n}\n`,
    '/// Sets an option from a number: choices by their index, booleans as 0 or 1. False when out of range, with nothing set. Without `isWord`\n/// the numbers that stand for words are refused.',
    `inline bool setOption(${values}& options, int index, double value,\n                      [[maybe_unused]] bool isWord = true) {\n  switch (index) {\n${options.map(setCase).join('\n')}\n  }\n  return false;\n}\n`,
    '/// The number that stands for a word ("auto") or a choice of an option.',
    `inline double wordValue(const ${values}&, int index, std::string_view text, bool& found) {\n${options.flatMap(wordCases).join('\n')}\n  return found = false, 0;\n}\n`,
    '/// The size of a unit written behind a number ("3G") in the unit of the option; 0 when there is none of that name.',
    `inline double unitSize(const ${values}&, [[maybe_unused]] int index,\n                       [[maybe_unused]] char letter) {\n${options.flatMap(unitCases).join('\n')}\n  return 0;\n}\n`,
    '/// Calls visit(name, value) for every option; words and choices are passed as text.',
    `template <class Visit>\nvoid forEachOption(const ${values}& options, Visit&& visit) {\n${options.map(visitLine).join('\n')}\n}\n`,
  ];
}

/** The header of one set; `base` is the set whose header it builds on. */
export function renderOptions({ verb, text, options, shared }, base) {
  const values = `${pascalCase(verb)}OptionValues`;
  const own = options.filter((option) => !shared.includes(option.name));
  const fields = options.map(
    (option) =>
      `  /// ${fullText(option)}\n  ${cppType(option)} ${option.name} = ${defaultOf(option)};`,
  );
  const parts = [
    HEADER,
    '#include <cmath>\n#include <limits>\n#include <string_view>\n',
    ...(own.some(({ type }) => type === 'size') ? ['#include "abflat/atlas_size.h"'] : []),
    ...(base ? [`#include "abflat/generated/${base}_options.h"\n`] : []),
    'namespace abflat {\n',
    ...own.filter(({ type }) => type === 'choice').flatMap(choiceParts),
    ...own.flatMap(wordConstants),
    `\n/// ${text}`,
    `struct ${values} {\n${fields.join('\n')}\n};\n`,
    ...(base ? [] : OPTION_INFO),
    ...optionFunctions(values, options),
    '}  // namespace abflat',
  ];
  return `${parts.join('\n')}\n`;
}
