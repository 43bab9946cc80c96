// Every sample of docs/ runs, unless the line of its fence says why not: ```sh skip="reason".

import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { BUILD } from '../../scripts/lib/paths.mjs';
import { codeBlocks } from '../support/documents.mjs';
import { runSample } from './support/run-sample.mjs';
import { isRunnable, prepare, samples } from './support/samples.mjs';

const ALL = samples();
const LEFT_OUT = ALL.filter(({ skip }) => skip !== undefined);

/** Those of Python are one program in each document: later ones use what earlier ones have made. */
function whatRuns() {
  const programs = new Map();
  for (const sample of ALL.filter(({ skip }) => skip === undefined)) {
    const key = sample.language === 'python' ? sample.document : sample.name;
    const { code = '', count = 0, ...first } = programs.get(key) ?? sample;
    const joined = count > 0 ? `${code}\n${sample.code}` : sample.code;
    programs.set(key, { ...first, code: joined, count: count + 1 });
  }
  return [...programs.values()];
}

let folder;
before(() => {
  // Inside the repository, so that packages are found.
  mkdirSync(join(BUILD, 'tests'), { recursive: true });
  folder = mkdtempSync(join(BUILD, 'tests/samples-'));
  prepare(folder);
});
after(() => rmSync(folder, { recursive: true, force: true }));

test('samples are in languages that are tested', () => {
  for (const sample of ALL)
    assert.ok(isRunnable(sample), `${sample.name}: nothing runs ${sample.language}`);
});

test('a sample that is left out says why', (t) => {
  for (const { name, skip } of LEFT_OUT) assert.match(skip, /^\S.{9,}/, name);
  t.diagnostic(`${ALL.length - LEFT_OUT.length} samples run, ${LEFT_OUT.length} do not:`);
  for (const { name, skip } of LEFT_OUT) t.diagnostic(`${name}: ${skip}`);
  assert.ok(ALL.length - LEFT_OUT.length > 10);
});

for (const sample of whatRuns())
  test(`${sample.name} (${sample.language}${sample.count > 1 ? `, ${sample.count} samples` : ''})`, () =>
    runSample(sample, folder));

test('a sample that does not work is found', () => {
  const broken = {
    sh: 'abflat unwrap missing.obj -o a.obj\ntrue\n',
    js: "import { unwrapp } from 'abflat';\n",
    python: 'import abflat\nabflat.unwrapp\n',
    yaml: '      - run: npm ci\n      - run: abflat verify missing.obj\n',
    cpp: '#include "abflat/unwrap.h"\nint main() { return 1; }\n',
  };
  for (const [language, code] of Object.entries(broken))
    assert.throws(() => runSample({ language, code }, folder), /exit code/, language);
});

test('the reason is read from the fence, which keeps its language', () => {
  const [first, second] = codeBlocks('a\n```sh skip="needs b"\nb\n```\n```js\nc\n```\n');
  assert.deepEqual(first, { language: 'sh', skip: 'needs b', code: 'b\n', line: 2 });
  assert.deepEqual(second, { language: 'js', skip: undefined, code: 'c\n', line: 5 });
});
