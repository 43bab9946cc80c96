// The flatten command: results, reports, pipes and messages.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { before, test } from 'node:test';
import { hasTerminals, runAbflat, runOnTerminal } from '../support/run-abflat.mjs';
import { DEFAULT_OPTIONS } from '../support/schema.mjs';
import { grid, TETRAHEDRON } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

/** Makes a terminal start the line again. */
const CLEAR_LINE = '\r\x1b[K';

let alphaBand;

before(async () => {
  alphaBand = (await runAbflat(['sample', 'alpha-band', '-o', '-'])).stdout;
});

function prepared(t) {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(8));
  writeFileSync(at('closed.off'), TETRAHEDRON);
  writeFileSync(at('alpha.obj'), alphaBand);
  return at;
}

const flatten = (at, args, options) => runAbflat(['flatten', ...args], { cwd: at(), ...options });
const lines = (text, word) => text.split('\n').filter((line) => line.startsWith(`${word} `));

test('a valid result: exit code 0, silence, the same mesh with texcoords', async (t) => {
  const at = prepared(t);
  const run = await flatten(at, ['in.obj', '-o', 'out.obj']);
  assert.deepEqual([run.code, run.stdout, run.stderr], [0, '', '']);
  const input = readFileSync(at('in.obj'), 'utf8');
  const result = readFileSync(at('out.obj'), 'utf8');
  assert.deepEqual(lines(result, 'v'), lines(input, 'v'));
  assert.equal(lines(result, 'vt').length, lines(input, 'v').length);
  const withoutTexcoords = lines(result, 'f').map((line) => line.replaceAll(/\/\d+/g, ''));
  assert.deepEqual(withoutTexcoords, lines(input, 'f'));
});

test('a result that is not valid is written: exit code 1 and why', async (t) => {
  const at = prepared(t);
  const args = ['alpha.obj', '-o', 'out.obj', '--t', '2', '--report', 'r.json'];
  for (const more of [[], ['--quiet']]) {
    const run = await flatten(at, [...args, ...more]);
    assert.equal(run.code, 1);
    assert.match(run.stderr, /^abflat: alpha\.obj: .*not valid: the boundary crosses itself.*\n$/);
    const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    assert.equal(report.valid, false);
    assert.ok(report.charts[0].boundaryCrossings > 0);
    assert.match(readFileSync(at('out.obj'), 'utf8'), /^vt /m);
  }
  const convex = await flatten(at, ['alpha.obj', '-o', 'out.obj', '--t', '1']);
  assert.deepEqual([convex.code, convex.stderr], [0, '']);
});

test('the report has its keys in their order', async (t) => {
  const at = prepared(t);
  await flatten(at, ['in.obj', '-o', 'out.obj', '--t', '1.5', '--report', 'r.json']);
  const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  assert.deepEqual(Object.keys(report), [
    'version',
    'input',
    'options',
    'threads',
    'charts',
    'valid',
    'timings',
  ]);
  const counts = { vertices: 81, faces: 128, triangles: 128, components: 1, boundaryLoops: 1 };
  assert.deepEqual(report.input, { path: 'in.obj', ...counts, boundaryEdges: 32, genus: 0 });
  assert.deepEqual(report.options, { ...DEFAULT_OPTIONS, t: 1.5 });
  assert.equal(report.charts.length, 1);
  const chart = report.charts[0];
  const keys =
    'faces boundaryVertices t bounds solver linearSolver formulation iterations history constraintResidual converged ' +
    'angularDistortion lengthDistortion quasiConformal stretch symmetricDirichlet areaDistortion ' +
    'degenerateTriangles flippedTriangles boundaryCrossings maxBoundaryAngle delaunay refined pins straight fallbacks problem valid';
  assert.deepEqual(Object.keys(chart), keys.split(' '));
  assert.ok(chart.history.length > 0);
  for (const step of chart.history)
    assert.deepEqual(Object.keys(step), [
      'objective',
      'constraint',
      'gradient',
      'active',
      'activeEdges',
      'step',
      'reweighted',
      'linearIterations',
    ]);
  assert.deepEqual(Object.keys(chart.quasiConformal), ['mean', 'max', 'sheared']);
  assert.deepEqual(Object.keys(chart.stretch), ['l2', 'linf']);
  assert.deepEqual(Object.keys(chart.areaDistortion), ['min', 'max']);
});

test('timings are filled and their sum is not more than the total', async (t) => {
  const at = prepared(t);
  await flatten(at, ['in.obj', '-o', 'out.obj', '--balance', '0.2', '--report', 'r.json']);
  const { total, ...parts } = JSON.parse(readFileSync(at('r.json'), 'utf8')).timings;
  assert.deepEqual(Object.keys(parts), [
    'read',
    'connectivity',
    'solve',
    'layout',
    'refine',
    'check',
    'write',
  ]);
  for (const [name, seconds] of Object.entries(parts)) assert.ok(seconds > 0, name);
  assert.ok(Object.values(parts).reduce((sum, seconds) => sum + seconds) <= total);
});

test('a balance trades angles for lengths, and the bound stays', async (t) => {
  const at = prepared(t);
  const chartAt = async (...args) => {
    const run = await flatten(at, ['in.obj', '-o', 'out.obj', '--report', 'r.json', ...args]);
    assert.equal(run.code, 0, run.stderr);
    return JSON.parse(readFileSync(at('r.json'), 'utf8')).charts[0];
  };
  for (const bound of ['2', '1']) {
    const plain = await chartAt('--t', bound);
    assert.equal(plain.refined, null);
    const refined = await chartAt('--t', bound, '--balance', '1');
    assert.ok(refined.valid && refined.refined.energy < refined.refined.energyBefore);
    assert.ok(refined.symmetricDirichlet < plain.symmetricDirichlet);
    assert.ok(refined.quasiConformal.mean > plain.quasiConformal.mean);
    if (bound === '1') assert.ok(refined.maxBoundaryAngle <= Math.PI + 1e-6);
  }
  const both = await flatten(at, ['in.obj', '-o', 'o2.obj', '--balance', '0.5', '--delaunay']);
  assert.equal(both.code, 2);
  assert.match(both.stderr, /delaunay is a condition on angles/);
});

test('the largest boundary angle keeps to the bound', async (t) => {
  const at = prepared(t);
  for (const bound of [0.995, 1, 1.05]) {
    const args = ['alpha.obj', '-o', '/dev/null', '--t', String(bound), '--report', 'r.json'];
    await flatten(at, args);
    const [chart] = JSON.parse(readFileSync(at('r.json'), 'utf8')).charts;
    assert.ok(chart.converged);
    assert.ok(chart.maxBoundaryAngle <= bound * Math.PI + 1e-8);
  }
});

test('without a result the report says why and what the input is', async (t) => {
  const at = prepared(t);
  const run = await flatten(at, ['closed.off', '-o', 'out.obj', '--report', 'r.json']);
  assert.equal(run.code, 4);
  const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  assert.equal(report.valid, false);
  assert.deepEqual(report.charts, []);
  assert.deepEqual([report.input.faces, report.input.boundaryLoops], [4, 0]);
  assert.equal(report.error.code, 'ClosedSurface');
  assert.equal(run.stderr, `abflat: ${report.error.message}.\n`);

  writeFileSync(at('broken.obj'), 'v 1 2\n');
  const broken = await flatten(at, ['broken.obj', '-o', 'out.obj', '--report', 'r.json']);
  assert.equal(broken.code, 3);
  const { error, input } = JSON.parse(readFileSync(at('r.json'), 'utf8'));
  assert.equal(error.code, 'ParseError');
  assert.match(error.message, /broken\.obj:1: /);
  assert.deepEqual([input.path, input.faces], ['broken.obj', null]);
});

test('two runs give the same bytes and, apart from timings, the same report', async (t) => {
  const at = prepared(t);
  const results = [];
  for (const name of ['one', 'two']) {
    await flatten(at, ['in.obj', '-o', `${name}.obj`, '--report', `${name}.json`]);
    const { timings, ...report } = JSON.parse(readFileSync(at(`${name}.json`), 'utf8'));
    assert.ok(timings.total > 0);
    results.push({ report, bytes: readFileSync(at(`${name}.obj`), 'utf8') });
  }
  assert.deepEqual(results[0], results[1]);
});

test('any number of threads gives the same bytes', async (t) => {
  const at = prepared(t);
  await runAbflat(['sample', 'head', '--detail', '4', '-o', at('large.obj')]);
  const bytes = [];
  for (const threads of ['1', '2', '3']) {
    const run = await flatten(at, [
      'large.obj',
      '-o',
      'o.obj',
      '--report',
      'r.json',
      '--threads',
      threads,
    ]);
    assert.deepEqual([run.code, run.stderr], [0, '']);
    const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    assert.deepEqual([report.options.threads, report.threads], [Number(threads), Number(threads)]);
    bytes.push(readFileSync(at('o.obj')));
  }
  assert.ok(bytes.every((other) => other.equals(bytes[0])));
});

test('a small mesh takes one thread, and threads are a whole number up to 256', async (t) => {
  const at = prepared(t);
  await flatten(at, ['in.obj', '-o', 'o.obj', '--report', 'r.json', '--threads', '256']);
  assert.equal(JSON.parse(readFileSync(at('r.json'), 'utf8')).threads, 1);
  for (const wrong of ['-1', '257', '1.5', 'many']) {
    const run = await flatten(at, ['in.obj', '-o', 'o.obj', `--threads=${wrong}`]);
    assert.equal(run.code, 2);
    assert.match(run.stderr, /--threads/);
  }
});

test('standard input and standard output give the same bytes as files', async (t) => {
  const at = prepared(t);
  await flatten(at, ['in.obj', '-o', 'out.obj']);
  const wanted = readFileSync(at('out.obj'));
  const piped = await flatten(at, ['-', '-o', '-'], { input: readFileSync(at('in.obj')) });
  assert.deepEqual([piped.code, piped.stderr], [0, '']);
  assert.ok(piped.bytes.equals(wanted));
  const report = await flatten(at, ['in.obj', '-o', 'out2.obj', '--report', '-']);
  assert.equal(JSON.parse(report.stdout).valid, true);
  assert.ok(readFileSync(at('out2.obj')).equals(wanted));
});

test('the format of standard input is found out', async (t) => {
  const at = prepared(t);
  const off = 'OFF\n# comment\n4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n';
  const run = await flatten(at, ['-', '-o', '-'], { input: off });
  assert.equal(run.code, 0, run.stderr);
  assert.equal(lines(run.stdout, 'vt').length, 4);
  for (const [input, sentence] of [
    ['', /standard input: the file is empty/],
    ['hello', /standard input is not supported\. Use OBJ, PLY, STL, OFF, glTF or GLB/],
    ['v 0 0\n', /standard input:1: /],
  ]) {
    const bad = await flatten(at, ['-', '-o', '-'], { input });
    assert.equal(bad.code, 3);
    assert.match(bad.stderr, sentence);
    assert.equal(bad.stdout, '');
  }
});

const terminalless = hasTerminals() ? false : 'there is no util-linux "script" to make a terminal';

test('on a terminal there is progress, cleared at the end, and a summary', {
  skip: terminalless,
}, (t) => {
  const at = prepared(t);
  const { code, seen } = runOnTerminal(['flatten', 'in.obj', '-o', 'out.obj'], { cwd: at() });
  assert.equal(code, 0);
  const [progress, summary] = seen.split(`${CLEAR_LINE}in.obj`);
  for (const stage of ['read', 'connectivity', 'Newton step 1', 'layout', 'check', 'write'])
    assert.ok(progress.includes(stage), stage);
  assert.equal(progress.includes('\n'), false, 'one line, written over');
  assert.match(summary, /^ -> out\.obj\r\n/);
  assert.match(summary, /128 faces, 81 vertices/);
  assert.match(summary, /t = 2, \d+ Newton steps/);
  assert.match(summary, /valid, \S+ s/);
});

test('on a terminal --quiet is silent, and an error clears the progress', {
  skip: terminalless,
}, (t) => {
  const at = prepared(t);
  const quiet = runOnTerminal(['flatten', 'in.obj', '-o', 'out.obj', '--quiet'], { cwd: at() });
  assert.deepEqual([quiet.code, quiet.seen], [0, '']);
  const failed = runOnTerminal(['flatten', 'closed.off', '-o', 'out.obj'], { cwd: at() });
  assert.equal(failed.code, 4);
  const sentence = failed.seen.split(CLEAR_LINE).at(-1);
  assert.match(sentence, /^abflat: closed\.off: closed surface[^\r\n]*\r\n$/);
});

test('with little memory there is the same layout, and the report says what was missing', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), grid(70));
  const run = async (memory) => {
    const args = ['in.obj', '-o', 'out.obj', '--t', '2', '--report', 'r.json', '--memory', memory];
    assert.deepEqual(await flatten(at, args).then(({ code }) => code), 0);
    const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    const uv = lines(readFileSync(at('out.obj'), 'utf8'), 'vt');
    return { report, uv: uv.map((line) => line.split(' ').slice(1).map(Number)) };
  };
  const little = await run('1M');
  assert.match(
    little.report.charts[0].fallbacks[0],
    /needs \d.* MB, but only 1 MB are allowed.*multigrid/,
  );
  assert.equal(little.report.options.memory, 1);
  const enough = await run('1G');
  assert.deepEqual(enough.report.charts[0].fallbacks, []);
  assert.equal(enough.report.options.memory, 1024);
  enough.uv.forEach(([u, v], i) => {
    assert.ok(Math.hypot(u - little.uv[i][0], v - little.uv[i][1]) < 1e-6);
  });
});
