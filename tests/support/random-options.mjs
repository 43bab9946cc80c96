// Random values for all options of the schema and the command line.

import { writeFileSync } from 'node:fs';
import { SCHEMA } from './schema.mjs';

const flagOf = (name) => name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);

/** Within the bounds, mostly near typical values; sizes stay small enough for many runs. */
function randomValue(random, option) {
  const { name, type, words } = option;
  if (type === 'choice') return random.pick(option.choices).name;
  if (words && random.chance(0.3)) return Object.keys(words)[0];
  if (name === 'resolution')
    return random.pick([16, 17, 64, 256, 1000, 2048, '300x64', '128x1024']);
  if (name === 'padding') return random.pick([0, 1, 2, 5, 16, 256]);
  if (name === 'threads') return random.below(4);
  const low = option.above ?? option.atLeast ?? 0;
  const value = low + random.pick([1e-9, 1e-3, 0.04, 0.3, 1, 1.7, 20, 1e6]);
  return Math.min(value, option.atMost ?? value);
}

function schemaArguments(random, option) {
  const flag = flagOf(option.name);
  if (option.type === 'boolean') return [option.default ? `--no-${flag}` : `--${flag}`];
  return [`--${flag}`, `${randomValue(random, option)}`];
}

const lines = (count, line) => `${Array.from({ length: count }, line).join('\n')}\n`;

/**
 * Options that only the program has, as [name, make(random, surface, file)]; `file(name, text)`
 * writes a file.
 */
const COMMON = {
  pins: (random, surface, file) => {
    const vertex = () => random.below(surface.positions.length);
    const line = () => `${vertex()} ${random.next()} ${random.next()}`;
    return ['--pins', file('pins.txt', lines(random.below(4), line))];
  },
  threads: (random) => ['--threads', `${1 + random.below(3)}`],
};

const ONLY = {
  flatten: {
    ...COMMON,
    bounds: (random, surface, file) => {
      const line = () => `${random.below(surface.positions.length)} ${random.between(0.1, 2.2)}`;
      return ['--bounds', file('bounds.txt', lines(random.below(5), line))];
    },
    straight: (random, surface, file) => {
      const vertex = () => random.below(surface.positions.length);
      const line = () => `${vertex()} ${vertex()}`;
      return ['--straight', file('straight.txt', lines(random.below(4), line))];
    },
  },
  unwrap: {
    ...COMMON,
    seams: (random, surface, file) => {
      const edge = () => {
        const face = random.pick(surface.faces);
        const k = random.below(face.length);
        return `${face[k]} ${face[(k + 1) % face.length]}`;
      };
      const parts = ['auto', 'none', 'hard', 'uv', 'material', `sharp=${random.between(1, 180)}`];
      const list = random.pick([...parts, `auto,${random.pick(parts.slice(2))}`, 'file']);
      if (list !== 'file') return ['--seams', list];
      return ['--seams', `file=${file('seams.txt', lines(random.below(6), edge))}`];
    },
    keep: (random, surface, file) => {
      const face = () => `${random.below(surface.faces.length)}`;
      const list = random.pick(['uv', 'material=m1', 'file']);
      if (list !== 'file') return ['--keep', list];
      return ['--keep', `file=${file('keep.txt', lines(random.below(4), face))}`];
    },
    layout: (random) => ['--layout', random.pick(['l.svg', 'l.png'])],
    heatMap: () => ['--heat-map', 'h.png'],
    writeSeams: () => ['--write-seams', 'w.txt'],
  },
};

const flattenOption = new Map(SCHEMA.flattenOptions.map((option) => [option.name, option]));

/** The options of a command as the schema has them. */
const optionsOf = (command) =>
  command === 'flatten'
    ? SCHEMA.flattenOptions
    : SCHEMA.unwrapOptions.map((o) => (typeof o === 'string' ? flattenOption.get(o) : o));

/** Every value of every option of a command that has only a few values, as arguments. */
export function everyChoice(command) {
  return optionsOf(command).flatMap((option) => {
    if (option.type === 'boolean') return [schemaArguments(undefined, option)];
    const flag = `--${flagOf(option.name)}`;
    return (option.choices ?? []).map(({ name }) => [flag, name]);
  });
}

/** Arguments for a command, each option with some probability. `at(name)` is a file's path. */
export function randomArguments(random, command, surface, at) {
  const file = (name, text) => {
    writeFileSync(at(name), text);
    return name;
  };
  const out = [];
  for (const option of optionsOf(command))
    if (option.name !== 'threads' && random.chance(0.25))
      out.push(...schemaArguments(random, option));
  for (const make of Object.values(ONLY[command]))
    if (random.chance(0.15)) out.push(...make(random, surface, file));
  return out;
}
