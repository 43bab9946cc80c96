// The reproduce command: the paper's tables, convergence and figures.

import assert from 'node:assert/strict';
import { copyFileSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { parseCsv } from '../support/csv.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { sharedMesh, withoutShared } from '../support/shared.mjs';
import { fan, grid, TETRAHEDRON } from '../support/small-meshes.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { parseXml } from '../support/xml.mjs';

const TOO_SLOW = isInstrumented && 'takes a minute with sanitizers';
const SAMPLES = ['alpha-band', 'three-balls', 'head'];

/** A folder "meshes" with the given files. */
function prepared(t, files = { 'bumps.obj': grid(6), 'closed.off': TETRAHEDRON }) {
  const at = tempFolder(t);
  mkdirSync(at('meshes'));
  for (const [name, text] of Object.entries(files)) writeFileSync(at(`meshes/${name}`), text);
  return at;
}

const reproduce = (at, ...args) => runAbflat(['reproduce', ...args], { cwd: at() });
const rowsOf = (path) => parseCsv(readFileSync(path, 'utf8'));
const rowOf = (rows, mesh) => rows.find((row) => row.mesh === mesh);

describe('tables', () => {
  test('values are those of sweep; a bad mesh is a row that says why', async (t) => {
    const at = prepared(t, {
      'bumps.obj': grid(6),
      'broken.obj': 'v 0 0 0\nf 1 2 3\n',
      'closed.off': TETRAHEDRON,
      'readme.txt': 'no mesh',
    });
    const run = await reproduce(at, '--meshes', 'meshes', '--out', 'out', '--only', 'tables');
    assert.equal(run.code, 0, run.stderr);
    assert.deepEqual(readdirSync(at('out')).sort(), [
      'index.html',
      'table1.csv',
      'table2.csv',
      'tables.md',
    ]);
    const table1 = rowsOf(at('out/table1.csv'));
    const names = table1.map(({ mesh }) => mesh);
    assert.deepEqual(names, [...SAMPLES, 'broken', 'bumps', 'closed']);
    assert.match(rowOf(table1, 'broken').remark, /broken\.obj:2/);
    assert.match(rowOf(table1, 'closed').remark, /closed surface/);
    assert.equal(rowOf(table1, 'closed').valid, 'no');

    await runAbflat(['sweep', 'meshes/bumps.obj', '--csv', 'sweep.csv'], { cwd: at() });
    const keys = ['t', 'angular distortion', 'length distortion', 'crossings', 'flipped'];
    const pick = (row) => keys.map((key) => row[key]);
    const swept = rowsOf(at('sweep.csv'));
    const table2 = rowsOf(at('out/table2.csv')).filter(({ mesh }) => mesh === 'bumps');
    assert.deepEqual(table2.map(pick), swept.map(pick));
    const atOne = swept.find((row) => row.t === '1');
    assert.deepEqual(pick({ ...rowOf(table1, 'bumps'), t: '1' }), pick(atOne));

    const page = readFileSync(at('out/index.html'), 'utf8');
    const text = readFileSync(at('out/tables.md'), 'utf8');
    for (const name of names) {
      assert.ok(page.includes(`<td>${name}</td>`));
      assert.ok(text.includes(`| ${name} |`));
    }
    assert.doesNotMatch(page, /<script/);
  });

  test('the numbers of the paper stand beside ours, with what keeps them apart', async (t) => {
    const at = prepared(t, { 'Nefertiti.obj': grid(3) });
    await reproduce(at, '--meshes', 'meshes', '--out', 'out', '--only', 'tables', '--quiet');
    const table1 = rowsOf(at('out/table1.csv'));
    const balls = rowOf(table1, 'three-balls');
    assert.deepEqual([balls['paper model'], balls['paper angular']], ['3 balls', '0.115']);
    assert.match(balls.remark, /look-alike/);
    assert.match(rowOf(table1, 'Nefertiti').remark, /not the same mesh: the paper's has 562/);
    assert.equal(rowOf(table1, 'head')['paper model'], '');
    const table2 = rowsOf(at('out/table2.csv')).filter(({ mesh }) => mesh === 'Nefertiti');
    assert.deepEqual(
      table2.map((row) => [row['paper angular'], row['paper length']].join(' ')),
      ['0.0016 0.013', '0.0021 0.017', '0.0025 0.018', '0.0029 0.019'],
    );
  });

  /** Table 2 of the paper to the digits that an exact solution has. */
  const EXACT = {
    nefertiti: ['0.00170 0.0132', '0.00216 0.0175', '0.00252 0.0181', '0.00298 0.0192'],
    body: ['0.01135 1.6502', '0.01139 1.6675', '0.01144 1.6776', '0.01147 1.6918'],
  };
  test('table 2 on the meshes of the paper', { skip: withoutShared }, async (t) => {
    const at = prepared(t, {});
    for (const mesh of Object.keys(EXACT))
      copyFileSync(sharedMesh(`${mesh}.off`), at(`meshes/${mesh}.off`));
    await reproduce(at, '--meshes', 'meshes', '--out', 'out', '--only', 'tables');
    const rows = rowsOf(at('out/table2.csv'));
    for (const [mesh, wanted] of Object.entries(EXACT)) {
      const mine = rows.filter((row) => row.mesh === mesh);
      const pairs = mine.map((row) =>
        [
          Number(row['angular distortion']).toFixed(5),
          Number(row['length distortion']).toFixed(4),
        ].join(' '),
      );
      assert.deepEqual(pairs, wanted);
      assert.ok(mine.every((row) => row.valid === 'yes' && row.remark === ''));
    }
    // Divided as in the paper, the lengths of its "Body" match to the last digit.
    for (const row of rows.filter(({ mesh }) => mesh === 'body'))
      assert.ok(Math.abs(row['length per 1.5 F'] - row['paper length']) <= 0.001);
  });
});

describe('pictures', () => {
  test('every file is well-formed, small, and shown on the page', { skip: TOO_SLOW }, async (t) => {
    const at = prepared(t, {
      'bumps.obj': grid(8),
      'a <b> & "c".obj': fan(9),
      'bumps.off': TETRAHEDRON,
    });
    const run = await reproduce(at, '--meshes', 'meshes', '--out', 'deep/out');
    assert.equal(run.code, 0, run.stderr);
    assert.match(run.stderr, /^\[1\/6\] alpha-band: 1920 faces$/m);
    const files = readdirSync(at('deep/out'));
    const stems = [...SAMPLES, 'bumps', 'a--b-----c-'];
    const wanted = stems.flatMap((stem) =>
      ['convergence', 'figure-2', 'figure-4', 'figure-6', 'figure-8'].map(
        (kind) => `${kind}-${stem}.svg`,
      ),
    );
    for (const file of wanted) assert.ok(files.includes(file), file);
    const page = readFileSync(at('deep/out/index.html'), 'utf8');
    for (const file of files.filter((name) => name.endsWith('.svg'))) {
      const bytes = readFileSync(at(`deep/out/${file}`));
      const [svg] = parseXml(bytes);
      assert.equal(svg.name, 'svg');
      assert.equal(svg.attributes.viewBox, `0 0 ${svg.attributes.width} ${svg.attributes.height}`);
      assert.ok(bytes.length < 1e6, file);
      assert.ok(page.includes(`src="${file}"`), file);
    }
    for (const [, file] of page.matchAll(/(?:src|href)="([^"#]+)"/g))
      assert.ok(files.includes(file), file);
    assert.ok(page.includes('a &lt;b&gt; &amp; &quot;c&quot;'));
  });

  test('crossings are marked where there are some', async (t) => {
    const at = tempFolder(t);
    await reproduce(at, '--out', 'out', '--only', 'figures');
    const marks = (file) =>
      parseXml(readFileSync(at(`out/${file}`))).filter(({ name }) => name === 'circle').length;
    assert.equal(marks('figure-2-alpha-band.svg'), 4);
    assert.equal(marks('figure-2-head.svg'), 0);
  });
});

describe('convergence', { skip: TOO_SLOW }, () => {
  test('every method ends at the same objective, plain ones after more iterations', async (t) => {
    const at = prepared(t, { 'bumps.obj': grid(6) });
    const total = {};
    for (const [folder, args] of Object.entries({ with: [], without: ['--no-precondition'] })) {
      const more = ['--only', 'convergence', ...args];
      const run = await reproduce(at, '--meshes', 'meshes', '--out', folder, ...more);
      assert.equal(run.code, 0, run.stderr);
      const rows = rowsOf(at(`${folder}/convergence.csv`)).filter(({ mesh }) => mesh === 'bumps');
      const last = new Map(rows.map((row) => [`${row['linear solver']}`, row]));
      assert.deepEqual([...last.keys()], ['schur', 'minres', 'symmlq', 'gmres', 'bicgstab']);
      for (const row of last.values()) {
        assert.equal(row.remark, '');
        const wanted = Number(last.get('schur').objective);
        assert.ok(Math.abs(row.objective - wanted) <= 1e-6 * wanted);
        assert.ok(row.constraint <= 1e-10);
      }
      const iterations = rows.map((row) => Number(row['linear iterations']));
      total[folder] = iterations.reduce((sum, n) => sum + n);
    }
    assert.ok(total.without > 2 * total.with, JSON.stringify(total));
  });

  test('meshes that are too large for iterative solvers are rows that say so', async (t) => {
    const at = prepared(t, { 'large.obj': grid(51) });
    const args = ['--meshes', 'meshes', '--out', 'out', '--only', 'convergence'];
    await reproduce(at, ...args);
    const rows = rowsOf(at('out/convergence.csv')).filter(({ mesh }) => mesh === 'large');
    const left = rows.filter(({ remark }) => /left out: 5202 faces/.test(remark));
    assert.deepEqual(
      left.map((row) => row['linear solver']),
      ['minres', 'symmlq', 'gmres', 'bicgstab'],
    );
    assert.ok(rows.some((row) => row['linear solver'] === 'schur' && row.step === '1'));
  });
});

describe('folders', () => {
  test('existing files of ours are replaced, others left alone', async (t) => {
    const at = prepared(t);
    mkdirSync(at('out'));
    for (const name of ['table1.csv', 'mine.txt']) writeFileSync(at(`out/${name}`), 'old');
    await reproduce(at, '--out', 'out', '--only', 'tables');
    assert.equal(readFileSync(at('out/mine.txt'), 'utf8'), 'old');
    assert.equal(rowsOf(at('out/table1.csv')).length, SAMPLES.length);
  });

  test('what cannot be read or written is one sentence', async (t) => {
    const at = prepared(t, {});
    writeFileSync(at('file'), '');
    for (const [args, code, sentence] of [
      [
        ['--meshes', 'meshes', '--out', 'out'],
        3,
        /meshes: it contains no \.obj, \.ply, \.stl or \.off file/,
      ],
      [['--meshes', 'missing', '--out', 'out'], 3, /missing: there is no such folder/],
      [['--meshes', 'file', '--out', 'out'], 3, /file: it is not a folder/],
      [['--out', 'file'], 5, /cannot create the folder file/],
      [['--out', 'file/deep'], 5, /cannot create the folder file\/deep/],
      [['--out', '/proc/abflat'], 5, /cannot create the folder \/proc\/abflat/],
      [[], 2, /--out is required/],
      [['--out', 'out', '--only', 'poems'], 2, /tables,convergence,figures/],
    ]) {
      const run = await reproduce(at, ...args);
      assert.equal(run.code, code, run.stderr);
      assert.match(run.stderr, sentence);
      assert.match(run.stderr, /^abflat: [^\n]+\n/);
    }
    assert.deepEqual(readdirSync(at()).sort(), ['file', 'meshes']);
  });

  test('--quiet says nothing', async (t) => {
    const at = tempFolder(t);
    const run = await reproduce(at, '--out', 'out', '--only', 'tables', '--quiet');
    assert.deepEqual([run.code, run.stdout, run.stderr], [0, '', '']);
  });
});
