// Options in random combinations, on surfaces of every kind: the documented exit code, a sentence
// or a valid result, and never a crash, a hang or all of the memory. ABFLAT_FUZZ_RUNS=2000
// ABFLAT_FUZZ_SEED=1 makes more of them.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { complaints } from '../support/atlas.mjs';
import { everyChoice, randomArguments } from '../support/random-options.mjs';
import { Random, randomSurface, SURFACE_KINDS, surfaceText } from '../support/random-surfaces.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { SCHEMA } from '../support/schema.mjs';
import { judgeStacks } from '../support/stacks.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const RUNS = Number(process.env.ABFLAT_FUZZ_RUNS ?? (isInstrumented ? 20 : 60));
const FIRST = Number(process.env.ABFLAT_FUZZ_SEED ?? 0);

const limited = (limits) => ['bash', '-c', `ulimit ${limits}; exec "$@"`, 'limited'];
/**
 * A runaway process ends at 4 GB or after two minutes of CPU time; an instrumented program reserves
 * more memory and is slow.
 */
const LEAST = limited('-v 4000000 -t 120');
const canBeLimited = (await runAbflat(['--version'], { wrapper: LEAST })).code === 0;
const LIMITED = canBeLimited ? LEAST : limited('-t 600');

const CODES = new Map(SCHEMA.exitCodes.map(({ name, code }) => [name, code]));
const WRITTEN = [CODES.get('Valid'), CODES.get('NotValid')];

const isTriangles = ({ faces }) => faces.every((f) => new Set(f).size === 3 && f.length === 3);

/** What is wrong with how a run ended; empty if nothing is. */
function checkEnd({ code, signal, stderr }, at, output) {
  if (signal !== null || ![...CODES.values()].includes(code))
    return `ended with ${signal ?? code}: ${stderr.slice(0, 300)}`;
  if (stderr.includes('not enough memory')) return 'all of the memory was taken';
  if (WRITTEN.includes(code)) {
    if (!existsSync(at(output))) return 'no output';
    const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    return report.valid === (code === 0) || code === 1 ? '' : `exit ${code}, valid ${report.valid}`;
  }
  if (existsSync(at(output))) return `exit ${code}, but there is an output`;
  // For contradictory options, the message points to the help.
  const oneSentence = /^abflat: [^\n]+\n(Run 'abflat \w+ --help' for usage\.\n)?$/;
  return oneSentence.test(stderr) ? '' : `exit ${code} says ${stderr.slice(0, 300)}`;
}

/** What is wrong with the result. */
function checkResult(surface, at, report) {
  if (!report.valid || !isTriangles(surface)) return [];
  if (report.atlas?.stacked.charts > 0) return checkStacked(at);
  const isKept = new Set(report.repair?.collapsedFaces);
  const text = readFileSync(at('out.obj'), 'utf8');
  return complaints(text, report.atlas?.tiles).filter((sentence) => {
    const face = /^face (\d+) is turned over or has no area$/.exec(sentence);
    return !(face && (isKept.has(Number(face[1])) || report.repair.degenerateTriangles > 0));
  });
}

function checkStacked(at) {
  const { isValid, problems } = judgeStacks(at('out.obj'), { tiles: [10, 1000] });
  return isValid ? [] : [JSON.stringify(problems)];
}

async function check(t, seed, command, kind, own) {
  const random = new Random(seed);
  const at = tempFolder(t);
  const surface = randomSurface(random, kind);
  writeFileSync(at('in.obj'), surfaceText(surface));
  const output = own ? 'out.obj' : random.pick(['out.obj', 'out.obj', 'out.ply', 'out.glb']);
  const options = own ?? randomArguments(random, command, surface, at);
  const args = [command, 'in.obj', '-o', output, '--report', 'r.json', '-q', ...options];
  const end = await runAbflat(args, { cwd: at(), wrapper: LIMITED });
  const run = `abflat ${args.join(' ')}`;
  assert.equal(checkEnd(end, at, output), '', run);
  if (command !== 'unwrap' || output !== 'out.obj' || end.code !== 0) return;
  const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  assert.deepEqual(checkResult(surface, at, report), [], run);
}

for (const own of everyChoice('unwrap'))
  test(`${own.join(' ')} on surfaces of every kind`, async (t) => {
    for (const kind of SURFACE_KINDS)
      for (let seed = FIRST; seed < FIRST + (isInstrumented ? 1 : 2); seed++)
        await check(t, seed, 'unwrap', kind, own);
  });

for (let seed = FIRST; seed < FIRST + RUNS; seed++)
  test(`random surface and options ${seed}`, (t) =>
    check(t, seed, seed % 3 === 0 ? 'flatten' : 'unwrap'));
