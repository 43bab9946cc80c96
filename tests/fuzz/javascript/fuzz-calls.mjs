// Makes random calls of the npm package and keeps the seeds of those that break a property.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { inspect } from 'node:util';
import { makeCalls } from './calls.mjs';
import { check, descriptorsOf, knownBytes, start } from './properties.mjs';

/** One instance for many calls, so that anything a call leaves behind affects the next. */
export class Calls {
  #abflat;
  #bytes;

  static async start() {
    const calls = new Calls();
    await calls.#restart();
    return calls;
  }

  async #restart() {
    this.#abflat?.terminate();
    this.#abflat = await start();
    this.#bytes = await knownBytes(this.#abflat);
  }

  /** Returns { results }, their number, or { failure }, after which there is a new instance. */
  async run({ seed, without = [] }) {
    const calls = makeCalls(seed, without);
    const ended = await Promise.allSettled(
      calls.map((call) => check(this.#abflat, call, this.#bytes)),
    );
    const failed = ended.find(({ status }) => status === 'rejected');
    if (!failed) return { results: ended.filter(({ value }) => value).length };
    await this.#restart();
    return { failure: failed.reason };
  }

  /** The same failure with as few options as possible. */
  async shrink(seed) {
    const names = new Set(
      makeCalls(seed).flatMap(({ args }) => Object.keys(descriptorsOf(args[1]))),
    );
    const without = [];
    for (const name of names)
      if ((await this.run({ seed, without: [...without, name] })).failure) without.push(name);
    return { seed, without };
  }

  end() {
    this.#abflat.terminate();
  }
}

/** Describes the calls in as few lines as possible. */
export const describe = ({ seed, without }) =>
  makeCalls(seed, without)
    .map(({ method, args }) =>
      inspect([method, ...args], { depth: 2, maxArrayLength: 12, compact: true }),
    )
    .join('\n');

/** Runs seeds from `first` on for some seconds. Resolves to how many there were and the files of findings. */
export async function fuzzCalls({ seconds, first, folder }) {
  mkdirSync(folder, { recursive: true });
  const end = performance.now() + 1000 * seconds;
  const calls = await Calls.start();
  const out = { executions: 0, results: 0, found: [], output: '', next: first };
  while (performance.now() < end) {
    const seed = out.next++;
    const { results, failure } = await calls.run({ seed });
    ++out.executions;
    out.results += results ?? 0;
    if (!failure) continue;
    const finding = await calls.shrink(seed);
    out.output += `${seed}: ${failure.message}\n${describe(finding)}\n`;
    const name = `javascript-${seed}.json`;
    writeFileSync(join(folder, name), `${JSON.stringify(finding)}\n`);
    out.found.push(name);
  }
  calls.end();
  return out;
}
