// abflat verify: what is wrong with a layout, whichever program made it.

import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { CUBE } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const ARTIST = join(ROOT, '../shared/artist');
const artistMeshes = existsSync(ARTIST)
  ? readdirSync(ARTIST).filter((name) => name.endsWith('.obj'))
  : [];

/** Squares with texcoords of their own, as large as in uv: `[u, v, side]`. */
const squares = (all) => {
  const corners = [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ];
  const lines = all.flatMap(([u, v, side], i) => [
    ...corners.map(([x, y]) => `v ${x * side} ${y * side} ${i}`),
    ...corners.map(([x, y]) => `vt ${u + x * side} ${v + y * side}`),
    `f ${[1, 2, 3, 4].map((c) => `${4 * i + c}/${4 * i + c}`).join(' ')}`,
  ]);
  return `${lines.join('\n')}\n`;
};

const APART = squares([
  [0.1, 0.1, 0.3],
  [0.5, 0.1, 0.3],
]);
const OVERLAPPING = squares([
  [0.1, 0.1, 0.3],
  [0.2, 0.2, 0.3],
]);

async function verify(t, text, ...options) {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), text);
  const args = ['verify', 'in.obj', '--report', 'r.json', ...options];
  const { code, stdout, stderr } = await runAbflat(args, { cwd: at() });
  const report = existsSync(at('r.json')) ? JSON.parse(readFileSync(at('r.json'), 'utf8')) : null;
  return { code, stdout, stderr, report, at };
}

test('the exit code, the text and the report say whether a layout keeps to the rules', async (t) => {
  const good = await verify(t, APART);
  assert.equal(good.code, 0, good.stderr);
  assert.equal(good.report.valid, true);
  assert.deepEqual(good.report.findings, []);
  assert.match(good.stdout, /2 islands, in tile 1001 of 1024 texels[\s\S]*\n {2}valid/);
  const bad = await verify(t, OVERLAPPING);
  assert.equal(bad.code, 1, bad.stderr);
  assert.equal(bad.stderr, '');
  assert.match(
    bad.stdout,
    /overlapBetween: islands 0 and 1 overlap, at faces 0 and 1\. Pack the layout again\.\n/,
  );
  assert.match(bad.stdout, /not valid: 1 finding/);
  const [{ rule, faces, islands, value }] = bad.report.findings;
  assert.deepEqual([rule, faces, islands, value], ['overlapBetween', [0, 1], [0, 1], null]);
});

test('what unwrap and pack write is valid by their own padding', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), CUBE);
  const run = async (...args) => {
    const { code, stdout, stderr } = await runAbflat(args, { cwd: at() });
    assert.equal(code, 0, `${args.join(' ')}\n${stdout}${stderr}`);
  };
  await run('unwrap', 'in.obj', '-o', 'out.glb', '--padding', '6', '--resolution', '256');
  const limits = [
    '--resolution',
    '256',
    '--padding',
    '6',
    '--margin',
    '3',
    '--max-stretch',
    '1.02',
  ];
  await run('verify', 'out.glb', ...limits, '--min-utilization', '0.3', '--max-islands', '6');
  await run('pack', 'out.glb', '-o', 'packed.obj', '--padding', '9', '--resolution', '128x256');
  await run('verify', 'packed.obj', '--resolution', '128x256', '--padding', '9');
});

test('rules come from a file, and the command line counts instead', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), APART);
  const rules = (text) => writeFileSync(at('rules.json'), text);
  const run = (...more) =>
    runAbflat(['verify', 'in.obj', '--rules', 'rules.json', ...more], { cwd: at() });
  rules('{ "$schema": "x", "resolution": [200, 100], "padding": 21 } // 20 are there\n');
  const bad = await run();
  assert.equal(bad.code, 1);
  assert.match(bad.stdout, /padding: islands 0 and 1 are 20 texels apart.*; 21 are asked for/);
  assert.equal((await run('--padding', '19')).code, 0);
  rules('{ "padding": 9, "mipLevels": 1, "resolution": 200, "maxTexelDensity": "none" }');
  assert.equal((await run()).code, 0);
  for (const [text, message] of [
    ['{ "pading": 9 }', /rules\.json: there is no rule "pading"/],
    ['{ "padding": "wide" }', /rules\.json: "padding" must be a number at least 0.*not wide/],
    ['{ "padding": -1 }', /"padding" must be/],
    ['{ "allowStacked": 3 }', /"allowStacked" must be true or false, not 3/],
    ['[]', /rules\.json is no JSON object/],
    ['{', /rules\.json is no JSON object/],
  ]) {
    rules(text);
    const { code, stderr } = await run();
    assert.ok([2, 3].includes(code), `${text}: ${code}`);
    assert.match(stderr, message);
    assert.equal(stderr.trim().split('\n').length, 1);
  }
});

test('JUnit has a test for each rule, SARIF a result for each finding', async (t) => {
  const { code, at, report } = await verify(
    t,
    OVERLAPPING,
    '--junit',
    'j.xml',
    '--sarif',
    's.json',
  );
  assert.equal(code, 1);
  const xml = readFileSync(at('j.xml'), 'utf8');
  const count = (pattern) => xml.match(pattern)?.length ?? 0;
  const tests = count(/<testcase /g);
  assert.ok(xml.includes(`tests="${tests}" failures="1"`), xml);
  assert.equal(count(/<failure /g), 1);
  assert.match(
    xml,
    /<testcase classname="in.obj" name="overlapBetween">\s*<failure message="islands/,
  );
  const sarif = JSON.parse(readFileSync(at('s.json'), 'utf8'));
  assert.equal(sarif.version, '2.1.0');
  const [{ tool, results }] = sarif.runs;
  assert.equal(tool.driver.rules.length, tests);
  assert.equal(results.length, report.findings.length);
  assert.equal(results[0].ruleId, 'overlapBetween');
  assert.equal(results[0].locations[0].physicalLocation.artifactLocation.uri, 'in.obj');
});

test('a report on standard output is alone there; nothing replaces what is read', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), APART);
  writeFileSync(at('rules.json'), '{}');
  const run = (...args) => runAbflat(['verify', 'in.obj', ...args], { cwd: at() });
  const { stdout } = await run('--report', '-');
  assert.equal(JSON.parse(stdout).islands, 2);
  for (const args of [
    ['--report', 'in.obj'],
    ['--junit', 'rules.json', '--rules', 'rules.json'],
    ['--junit', 'same', '--sarif', 'same'],
  ])
    assert.equal((await run(...args)).code, 2, args.join(' '));
  assert.equal(readFileSync(at('in.obj'), 'utf8'), APART);
  assert.equal((await run('--quiet')).stdout, '');
  assert.equal((await runAbflat(['verify', 'none.obj'], { cwd: at() })).code, 3);
  writeFileSync(at('bare.obj'), 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
  const bare = await runAbflat(['verify', 'bare.obj'], { cwd: at() });
  assert.equal(bare.code, 4);
  assert.match(bare.stderr, /bare\.obj: no face has texcoords/);
});

for (const name of artistMeshes)
  test(`${name}: as pack judges it`, async (t) => {
    const at = tempFolder(t);
    const file = join(ARTIST, name);
    const packed = await runAbflat(
      ['pack', file, '-o', 'out.obj', '--keep-places', '--report', 'p.json'],
      { cwd: at() },
    );
    assert.ok([0, 1].includes(packed.code), packed.stderr);
    const found = await runAbflat(['verify', file, '--report', 'v.json'], { cwd: at() });
    assert.ok([0, 1].includes(found.code), found.stderr);
    const read = (path) => JSON.parse(readFileSync(at(path), 'utf8'));
    const [pack, own] = [read('p.json'), read('v.json')];
    for (const key of ['islands', 'mirrored', 'unmapped']) assert.equal(own[key], pack[key], key);
    const { outside: _, ...faces } = own.faces;
    const { outside: __, ...expected } = pack.faces;
    assert.deepEqual(faces, expected);
  });
