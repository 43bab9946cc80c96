// abflat batch: many meshes by one command, whatever happens to it.

import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { filesBelow, hasResults, inFolder, manifestOf, namesIn } from '../support/batches.mjs';
import { madePng } from '../support/made-png.mjs';
import { writeManyMeshes } from '../support/many-meshes.mjs';
import { hasTerminals, runAbflat, runOnTerminal } from '../support/run-abflat.mjs';
import { CUBE, grid, TRIANGLE } from '../support/small-meshes.mjs';
import { texturedCube } from '../support/textured.mjs';
import { texturedObj } from '../support/textured-obj.mjs';

test('files, folders, patterns and lists name meshes, each once', async (t) => {
  const { at, batch } = inFolder(t, {
    'one.obj': CUBE,
    'in/two.obj': grid(2),
    'in/deep/three.obj': grid(3),
    'in/deep/notes.txt': 'no mesh',
    'in/.hidden/four.obj': CUBE,
    'lists/all.txt': '# two meshes\n../one.obj\n../in/two.obj\n',
  });
  const runs = [
    [['one.obj'], ['one.obj']],
    [['in'], ['deep/three.obj', 'two.obj']],
    [['in/*.obj'], ['in/two.obj']],
    [['in/**/*.obj'], ['in/deep/three.obj', 'in/two.obj']],
    [['in/**/t[hx]ree.ob?'], ['in/deep/three.obj']],
    [
      ['--from', 'lists/all.txt'],
      ['in/two.obj', 'one.obj'],
    ],
    [
      ['in', 'in/../in/two.obj', './one.obj', 'one.obj'],
      ['deep/three.obj', 'in/two.obj', 'one.obj'],
    ],
  ];
  for (const [i, [args, names]] of runs.entries()) {
    const run = await batch(...args, '--out', `out${i}`);
    assert.equal(run.code, 0, run.stderr);
    assert.deepEqual(namesIn(at(`out${i}`)), names);
    for (const name of names) assert.match(readFileSync(at(`out${i}/${name}`), 'utf8'), /^vt /m);
  }
  const listed = await runAbflat(['batch', '-', '--out', 'out'], {
    cwd: at(),
    input: 'one.obj\nin/two.obj\n',
  });
  assert.equal(listed.code, 0, listed.stderr);
  assert.deepEqual(namesIn(at('out')), ['in/two.obj', 'one.obj']);
});

for (const [kind, list] of [
  ['CSV', 'input,padding,rectify,udim\n"a.obj",7,never,\nb.obj,,,false\n'],
  ['JSON Lines', '{"input": "a.obj", "padding": 7, "rectify": "never"}\n\n{"input": "b.obj"}\n'],
])
  test(`a list in ${kind} has options of single meshes`, async (t) => {
    const { at, batch } = inFolder(t, { 'a.obj': CUBE, 'b.obj': CUBE, list });
    const options = ['--padding', '3', '--resolution', '256'];
    const run = await batch('--from', 'list', '--out', 'out', ...options);
    assert.equal(run.code, 0, run.stderr);
    for (const [name, padding] of [
      ['a', 7],
      ['b', 3],
    ]) {
      const own = [
        ...options.slice(2),
        '--padding',
        padding,
        '--rectify',
        name === 'a' ? 'never' : 'auto',
      ];
      await runAbflat(['unwrap', `${name}.obj`, '-o', 'single.obj', ...own.map(String)], {
        cwd: at(),
      });
      assert.equal(
        readFileSync(at(`out/${name}.obj`), 'utf8'),
        readFileSync(at('single.obj'), 'utf8'),
      );
    }
  });

test('results are those of the command, in the format that is asked for', async (t) => {
  const { at, batch } = inFolder(t, {
    'in/a.obj': CUBE,
    'in/b.off': 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n',
  });
  assert.equal((await batch('in', '--out', 'own')).code, 0);
  assert.deepEqual(hasResults(at('own')), ['a.obj', 'b.glb']);
  assert.equal((await batch('in', '--out', 'ply', '--format', 'ply', '--no-pictures')).code, 0);
  assert.deepEqual(hasResults(at('ply')), ['a.ply', 'b.ply']);
  assert.equal(existsSync(at('ply/layouts')), false);
  await runAbflat(['unwrap', 'in/a.obj', '-o', 'a.ply'], { cwd: at() });
  assert.deepEqual(readFileSync(at('ply/a.ply')), readFileSync(at('a.ply')));
  assert.equal((await batch('own', '--run', 'pack', '--out', 'packed', '--padding', '4')).code, 0);
  assert.equal((await batch('in/a.obj', '--run', 'flatten', '--out', 'flat')).code, 1);
  assert.equal(manifestOf(at('flat'))[0].status, 'notFlattenable');
});

test('images that are baked lie beside the mesh, and belong to its result', async (t) => {
  const { at, batch } = inFolder(t, {
    'in/deep/a.obj': texturedObj('a.mtl', [{ ...texturedCube(), material: 'paint' }]),
    'in/deep/a.mtl': 'newmtl paint\nmap_Kd paint.png\n',
    'in/deep/paint.png': madePng(16, 16, (x, y) => [16 * x, 16 * y, 90]),
  });
  const options = ['--bake', '--resolution', '64'];
  assert.equal((await batch('in', '--out', 'out', ...options)).code, 0);
  mkdirSync(at('single'));
  await runAbflat(['unwrap', 'in/deep/a.obj', '-o', 'single/a.obj', ...options], { cwd: at() });
  const expected = filesBelow(at('single'));
  assert.ok(expected.length > 2);
  assert.deepEqual(
    hasResults(at('out')),
    expected.map((name) => `deep/${name}`),
  );
  for (const name of expected)
    assert.deepEqual(readFileSync(at(`out/deep/${name}`)), readFileSync(at(`single/${name}`)));
  const [{ files }] = manifestOf(at('out'));
  assert.equal(files[0].path, 'deep/a.obj');
  assert.deepEqual(files.map(({ path }) => path).sort(), hasResults(at('out')));
  const again = ['in', '--out', 'out', '--resume', '--dry-run', ...options];
  assert.match((await batch(...again)).stdout, /^0 to do, 1 done/m);
  rmSync(at(`out/${files.at(-1).path}`));
  assert.match((await batch(...again)).stdout, /^1 to do, 0 done/m);
});

test('a glTF names its files from where it will lie', async (t) => {
  const { at, batch } = inFolder(t, { 'in/deep/a.obj': CUBE });
  await runAbflat(['unwrap', 'in/deep/a.obj', '-o', 'in/deep/a.gltf'], { cwd: at() });
  const gltf = JSON.parse(readFileSync(at('in/deep/a.gltf'), 'utf8'));
  gltf.images = [{ uri: 'a.png' }];
  gltf.textures = [{ source: 0 }];
  gltf.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0, texCoord: 0 } } }];
  gltf.meshes[0].primitives[0].material = 0;
  writeFileSync(at('in/deep/a.gltf'), JSON.stringify(gltf));
  rmSync(at('in/deep/a.obj'));
  const run = await batch('in', '--out', 'out');
  assert.equal(run.code, 0, run.stdout + run.stderr);
  const { images } = JSON.parse(readFileSync(at('out/deep/a.gltf'), 'utf8'));
  assert.equal(join('out/deep', images[0].uri), 'in/deep/a.png');
});

test('verify writes no meshes, and the manifest says what it has found', async (t) => {
  const { at, batch } = inFolder(t, { 'in/a.obj': CUBE, 'rules.json': '{ "padding": 500 }' });
  assert.equal((await batch('in', '--out', 'uv')).code, 0);
  const good = await batch('uv', '--run', 'verify', '--out', 'good');
  assert.equal(good.code, 0, good.stdout + good.stderr);
  const bad = await batch('uv', '--run', 'verify', '--out', 'bad', '--rules', 'rules.json');
  assert.equal(bad.code, 1);
  const files = ['layouts/a.obj.png', 'manifest.jsonl', 'report.html'];
  assert.deepEqual(filesBelow(at('bad')), files);
  const [{ status, summary }] = manifestOf(at('bad'));
  assert.equal(status, 'notValid');
  assert.ok(summary.findings.every(({ message }) => message.length > 10));
  assert.match(readFileSync(at('bad/report.html'), 'utf8'), /class="why">padding/);
});

test('a broken mesh has a reason, and does not keep others from theirs', async (t) => {
  const { at, batch } = inFolder(t, {});
  const made = writeManyMeshes(at('in'), { count: 30, most: 60, broken: 0.25 });
  const run = await batch('in', '--out', 'out');
  assert.equal(run.code, 1);
  const lines = manifestOf(at('out'));
  assert.deepEqual(
    lines.map(({ name }) => name),
    made.map(({ name }) => name).sort(),
  );
  for (const { name, broken } of made) {
    const { status, message, files } = lines.find((line) => line.name === name);
    const expected = { undefined: 'done', 'no faces': 'notFlattenable' }[broken] ?? 'unreadable';
    assert.equal(status, expected, `${name}: ${message}`);
    assert.equal(message !== '', broken !== undefined);
    assert.equal(files.length, broken ? 0 : 1);
  }
  assert.match(run.stdout, /^done +22 /m);
  assert.match(run.stdout, /^unreadable +7 /m);
  assert.match(run.stdout, /^notFlattenable +1 /m);
});

test('a file of a list that is missing fails alone', async (t) => {
  const { at, batch } = inFolder(t, { 'a.obj': CUBE, list: 'a.obj\ngone.obj\n' });
  assert.equal((await batch('--from', 'list', '--out', 'out')).code, 1);
  assert.deepEqual(
    manifestOf(at('out')).map(({ name, status }) => [name, status]),
    [
      ['a.obj', 'done'],
      ['gone.obj', 'unreadable'],
    ],
  );
});

test('--resume skips what is done with the same content and options, and nothing else', async (t) => {
  const { at, batch } = inFolder(t, {
    'in/a.obj': CUBE,
    'in/b.obj': grid(2),
    'in/c.obj': 'broken',
  });
  const todo = async (...options) => {
    const run = await batch('in', '--out', 'out', '--resume', '--dry-run', ...options);
    assert.equal(run.code, 0, run.stderr);
    return [...run.stdout.matchAll(/^unwrap in\/(\S+)/gm)].map(([, name]) => name);
  };
  assert.deepEqual(await todo(), ['a.obj', 'b.obj', 'c.obj']);
  assert.equal(existsSync(at('out')), false);
  await batch('in', '--out', 'out');
  const before = readFileSync(at('out/manifest.jsonl'), 'utf8');
  assert.deepEqual(await todo(), []);
  assert.deepEqual(await todo('--threads', '2'), []);
  assert.deepEqual(await todo('--padding', '5'), ['a.obj', 'b.obj', 'c.obj']);
  assert.equal((await batch('in', '--out', 'out', '--resume')).code, 1);
  assert.equal(readFileSync(at('out/manifest.jsonl'), 'utf8'), before);

  rmSync(at('out/a.obj'));
  assert.deepEqual(await todo(), ['a.obj']);
  await batch('in', '--out', 'out', '--resume');
  writeFileSync(at('out/b.obj'), 'changed');
  writeFileSync(at('in/c.obj'), TRIANGLE);
  assert.deepEqual(await todo(), ['b.obj', 'c.obj']);
  assert.equal((await batch('in', '--out', 'out', '--resume')).code, 0);
  assert.match(readFileSync(at('out/b.obj'), 'utf8'), /^vt /m);

  // What has no result any more keeps none of an earlier one.
  writeFileSync(at('in/a.obj'), '');
  assert.equal((await batch('in', '--out', 'out', '--resume')).code, 1);
  assert.deepEqual(hasResults(at('out')), ['b.obj', 'c.obj']);
});

test('files that options name are part of the options', async (t) => {
  const { batch, at } = inFolder(t, { 'a.obj': CUBE, seams: '0 1\n' });
  const options = ['a.obj', '--out', 'out', '--seams', 'auto,file=seams', '--resume'];
  await batch(...options);
  assert.match((await batch(...options, '--dry-run')).stdout, /^0 to do, 1 done/m);
  writeFileSync(at('seams'), '0 1\n1 2\n');
  assert.match((await batch(...options, '--dry-run')).stdout, /^1 to do, 0 done/m);
});

test('files that a mesh names are part of it', async (t) => {
  const obj = `mtllib the look.mtl\n${CUBE}`;
  const { batch, at } = inFolder(t, { 'in/a.obj': obj, 'in/the look.mtl': 'newmtl a\n' });
  await runAbflat(['unwrap', 'in/a.obj', '-o', 'in/b.gltf'], { cwd: at() });
  const gltf = JSON.parse(readFileSync(at('in/b.gltf'), 'utf8'));
  const [, data] = gltf.buffers[0].uri.split(',');
  writeFileSync(at('in/b 1.bin'), Buffer.from(data, 'base64'));
  gltf.buffers[0].uri = 'b%201.bin';
  writeFileSync(at('in/b.gltf'), JSON.stringify(gltf));
  const options = ['in', '--out', 'out', '--resume'];
  assert.equal((await batch(...options)).code, 0);
  assert.match((await batch(...options, '--dry-run')).stdout, /^0 to do, 2 done/m);
  writeFileSync(at('in/b 1.bin'), Buffer.concat([Buffer.from(data, 'base64'), Buffer.alloc(4)]));
  assert.match((await batch(...options, '--dry-run')).stdout, /b\.gltf\n1 to do, 1 done/m);
  writeFileSync(at('in/the look.mtl'), 'newmtl b\n');
  assert.match((await batch(...options, '--dry-run')).stdout, /^2 to do, 0 done/m);
});

test('a folder with results is not written to by accident', async (t) => {
  const { at, batch } = inFolder(t, { 'a.obj': CUBE, 'mine/a.obj': 'mine' });
  await batch('a.obj', '--out', 'out');
  const again = await batch('a.obj', '--out', 'out');
  assert.equal(again.code, 2);
  assert.match(again.stderr, /earlier run\. Add --resume/);
  const mine = await batch('a.obj', '--out', 'mine', '--resume');
  assert.equal(mine.code, 2);
  assert.match(mine.stderr, /mine\/a\.obj is there already/);
  assert.equal(readFileSync(at('mine/a.obj'), 'utf8'), 'mine');
  assert.deepEqual(filesBelow(at('mine')), ['a.obj']);
});

/** Arguments that are refused before anything is written, and what is said. */
const REFUSED = [
  [['nothing.obj'], 3, /there is no file nothing\.obj/],
  [['*.glb'], 3, /no file is like \*\.glb/],
  [['empty'], 3, /no mesh in the folder empty/],
  [['--from', 'empty.txt'], 3, /the list names no mesh/],
  [['--from', 'gone.txt'], 3, /gone\.txt/],
  [['--from', 'odd.csv'], 3, /odd\.csv:3: there are 1 cells, but 2 columns/],
  [['--from', 'word.csv'], 2, /word\.csv:2: there is no option "colour"/],
  [['--from', 'wrong.csv'], 2, /a\.obj: --padding: 'much' is not a number/],
  [
    ['a.obj', 'b.stl', '--format', 'glb', 'b.off'],
    2,
    /b\.off and b\.stl would both be out\/b\.glb/,
  ],
  [['in', 'also'], 2, /also\/a\.obj and in\/a\.obj would both be out\/a\.obj\. Rename one/],
  [['.', '--out', '.'], 2, /lies where the results go/],
  [['a.obj', '--padding', '-1'], 2, /--padding: must be a number/],
  [['a.obj', '--report', 'r.json'], 2, /--report: batch names the files of each mesh itself/],
  [['a.obj', '-o', 'x.obj'], 2, /--output: batch names/],
  [['a.obj', '--what'], 2, /no option '--what'/],
  [['a.obj', '--run', 'inspect'], 2, /--run/],
  [['a.obj', '--run', 'flatten', '--stack', 'none'], 2, /no option '--stack'/],
  [['a.obj', '--format', 'off'], 2, /'off' cannot be written\. Use obj, ply, glb or gltf/],
  [['a.obj', '--shard', '4/4'], 2, /--shard: '4\/4' is not a part/],
  [['a.obj', '--jobs', '0'], 2, /--jobs: must be a whole number/],
  [['a.obj', '--time-limit', '0'], 2, /--time-limit: must be a number above 0/],
  [['a.obj', '--memory-limit', 'much'], 2, /--memory-limit: must be a number of MB/],
  [['a.obj', '--seams', 'file=-'], 2, /cannot all read standard input/],
  [['a.obj', '--merge'], 2, /--merge: takes nothing but --out/],
  [['-', '--from', '-'], 2, /standard input can be read only once/],
  [[], 2, /no mesh is named/],
];

for (const [args, code, sentence] of REFUSED)
  test(`"abflat batch ${args.join(' ')}" is refused`, async (t) => {
    const { at, batch } = inFolder(t, {
      'a.obj': CUBE,
      'in/a.obj': CUBE,
      'also/a.obj': CUBE,
      'b.stl': 'solid\nendsolid\n',
      'b.off': 'OFF\n',
      'empty/notes.txt': '',
      'empty.txt': '# nothing\n',
      'odd.csv': 'input,padding\na.obj,1\na.obj\n',
      'word.csv': 'input,colour\na.obj,red\n',
      'wrong.csv': 'input,padding\na.obj,much\n',
    });
    const before = filesBelow(at());
    const out = args.includes('--out') ? [] : ['--out', 'out'];
    const run = await batch(...args, ...out);
    assert.equal(run.code, code, run.stderr);
    assert.match(run.stderr, sentence);
    assert.match(run.stderr, /^abflat: [^\n]+\n(Run 'abflat batch --help' for usage\.\n)?$/);
    assert.deepEqual(filesBelow(at()), before);
  });

test('names are only text in the report, and links lead to the files', async (t) => {
  const name = '<img src=x onerror=alert(1)>&"\'#?%41.obj';
  const { at, batch } = inFolder(t, { [`in/${name}`]: CUBE, 'in/bad<b>.obj': 'v <i> 0 0\n' });
  assert.equal((await batch('in', '--out', 'out')).code, 1);
  const page = readFileSync(at('out/report.html'), 'utf8');
  assert.doesNotMatch(page, /<img src=x|<b>|<i>/);
  const links = [...page.matchAll(/(?:href|src)="([^"]*)"/g)].map(([, link]) => link);
  assert.ok(links.length > 5);
  for (const link of links) assert.ok(existsSync(at(join('out', decodeURIComponent(link)))), link);
});

test('options that begin with a dash and meshes with odd names pass to the command', async (t) => {
  const names = ['a b  c.obj', 'it\'s "q".obj', '-x.obj', '*.obj', '日本 🙂.obj'];
  const { at, batch } = inFolder(t, Object.fromEntries(names.map((name) => [name, CUBE])));
  const run = await batch('.', '--out', 'out', '--padding=1', '--rotate', 'none');
  assert.equal(run.code, 0, run.stdout + run.stderr);
  assert.deepEqual(hasResults(at('out')), names.sort());
});

test('progress is shown on a terminal only, and can be turned off', async (t) => {
  const { at, batch } = inFolder(t, { 'in/a.obj': CUBE, 'in/b.obj': grid(2) });
  const plain = await batch('in', '--out', 'plain');
  assert.equal(plain.stderr, '');
  const quiet = await batch('in', '--out', 'quiet', '--quiet');
  assert.equal(quiet.stderr + quiet.stdout, '');
  if (!hasTerminals()) return t.diagnostic('there is no script of util-linux to make a terminal');
  const { code, seen } = runOnTerminal(['batch', 'in', '--out', 'seen', '-j', '1'], { cwd: at() });
  assert.equal(code, 0, seen);
  assert.match(seen, /1 of 2 done, 1 running, [\d.]+ per second, \d+ s left/);
  assert.match(seen.slice(seen.lastIndexOf('\r\x1b[K') + 4), /^status +meshes/);
});

test('a name that no manifest can hold is refused', async (t) => {
  const { at, batch } = inFolder(t, { 'in/a.obj': CUBE });
  try {
    writeFileSync(
      Buffer.concat([Buffer.from(at('in/')), Buffer.from([0xff]), Buffer.from('.obj')]),
      CUBE,
    );
  } catch {
    return t.skip('this file system takes no such name');
  }
  const run = await batch('in', '--out', 'out');
  assert.equal(run.code, 2);
  assert.match(run.stderr, /not UTF-8, so no manifest can hold it\. Rename it/);
});

test('links in the folder of meshes are followed to files, once', async (t) => {
  const { at, batch } = inFolder(t, { 'in/a.obj': CUBE });
  symlinkSync('a.obj', at('in/b.obj'));
  symlinkSync('.', at('in/loop'));
  assert.equal((await batch('in', '--out', 'out')).code, 0);
  assert.deepEqual(namesIn(at('out')), ['a.obj']);
});
