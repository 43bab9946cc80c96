// abflat batch --atlas: several files that share one atlas.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { filesBelow, hasResults, inFolder, manifestOf } from '../support/batches.mjs';
import { cutFaces, judgeFiles, readAtlas } from '../support/exact-atlas.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { densitiesOf } from '../support/scene-atlas.mjs';
import { CUBE, fan, grid, TETRAHEDRON } from '../support/small-meshes.mjs';
import { objText, torus } from '../support/surfaces.mjs';

const scaled = ({ positions, faces }, by) => ({
  positions: positions.map((p) => p.map((x) => x * by)),
  faces,
});

/** Two folders of props, and a mesh beside them. */
const PROPS = {
  'in/props/cube.obj': CUBE,
  'in/props/ring.obj': objText(scaled(torus(14, 8), 2.5)),
  'in/props/pyramid.off': TETRAHEDRON,
  'in/props/deep/wave.obj': grid(5),
  'in/props/deep/fan.obj': fan(7),
  'in/lone.obj': CUBE,
};

/** Triangles of files as scene-atlas.mjs takes them: each file is an object. */
const trianglesOf = (paths) =>
  paths.flatMap((path, object) =>
    cutFaces(readAtlas(path).faces).triangles.map((corners) => ({
      object,
      places: corners.map(({ place }) => place),
      uv: corners.map(({ uv }) => uv),
    })),
  );

const lineNamed = (folder, name) => manifestOf(folder).find((line) => line.name === name);

/** Checks that the files of a line do not overlap and have one texel density. */
function assertShared(at, line, resolution) {
  const paths = line.files.map(({ path }) => at(`out/${path}`));
  const { isValid, ...found } = judgeFiles(paths);
  assert.ok(isValid, JSON.stringify(found));
  const densities = [...densitiesOf(trianglesOf(paths), resolution).values()];
  for (const density of densities)
    assert.ok(Math.abs(density / densities[0] - 1) < 0.02, densities.join());
}

test('meshes of a folder share an atlas at one texel density', async (t) => {
  const { at, batch } = inFolder(t, PROPS);
  const args = ['in', '--out', 'out', '--atlas', 'folder', '--resolution', '512'];
  const run = await batch(...args);
  assert.equal(run.code, 0, run.stderr);
  assert.match(run.stdout, /^done +6 /m);
  assert.deepEqual(hasResults(at('out')), [
    ...['lone.obj', 'props/cube.obj', 'props/deep/fan.obj', 'props/deep/wave.obj'],
    ...['props/pyramid.glb', 'props/ring.obj'],
  ]);
  const lines = manifestOf(at('out'));
  assert.deepEqual(
    lines.map(({ name, isAtlas, inputs, layout }) => [name, isAtlas, inputs.length, layout]),
    [
      ['atlas', true, 1, 'layouts/atlas.svg'],
      ['props/atlas', true, 3, 'layouts/props/atlas.svg'],
      ['props/deep/atlas', true, 2, 'layouts/props/deep/atlas.svg'],
    ],
  );
  for (const line of lines) assertShared(at, line, 512);
  const props = lineNamed(at('out'), 'props/atlas');
  assert.deepEqual(
    props.files.map(({ path }) => path),
    ['props/cube.obj', 'props/pyramid.glb', 'props/ring.obj'],
  );
  assert.equal(props.summary.faces, 6 + 4 + torus(14, 8).faces.length);
  const page = readFileSync(at('out/report.html'), 'utf8');
  assert.match(page, /props\/atlas<span class="from"><a href="props\/cube\.obj">/);
  // Vertices and faces are those of the input.
  const verified = await runAbflat(
    ['verify', 'out/props/ring.obj', '--against', 'in/props/ring.obj', '--resolution', '512'],
    { cwd: at() },
  );
  assert.equal(verified.code, 0, verified.stdout);
});

test('what is done is done once, and again when a mesh changes', async (t) => {
  const { at, batch } = inFolder(t, PROPS);
  const args = ['in', '--out', 'out', '--atlas', 'folder', '--resume'];
  assert.equal((await batch(...args)).code, 0);
  const dry = async () => (await batch(...args, '--dry-run')).stdout;
  assert.match(await dry(), /^0 to do, 3 done already/m);
  const before = manifestOf(at('out'));
  writeFileSync(at('in/props/cube.obj'), CUBE.replace('v 1 1 1', 'v 1 1 2'));
  const plan = await dry();
  assert.match(
    plan,
    /^unwrap into the atlas props\/atlas:\n {2}in\/props\/cube\.obj -> out\/props\/cube\.obj\n/,
  );
  assert.match(plan, /^1 to do, 2 done already/m);
  assert.equal((await batch(...args)).code, 0);
  for (const [i, line] of manifestOf(at('out')).entries())
    (line.name === 'props/atlas' ? assert.notDeepEqual : assert.deepEqual)(line, before[i]);
  rmSync(at('out/props/ring.obj'));
  assert.match(await dry(), /^1 to do, 2 done already/m);
  rmSync(at('in/props/ring.obj'));
  assert.equal((await batch(...args)).code, 0);
  assert.equal(lineNamed(at('out'), 'props/atlas').inputs.length, 2);
});

test('an atlas is complete or has a reason', async (t) => {
  const { at, batch } = inFolder(t, {
    ...PROPS,
    'in/props/deep/torn.obj': 'v 0 0 0\nv 1 0 0\nf 1 2 3\n',
  });
  const args = ['in', '--out', 'out', '--atlas', 'folder', '--resume'];
  const run = await batch(...args);
  assert.equal(run.code, 1, run.stderr);
  const line = lineNamed(at('out'), 'props/deep/atlas');
  assert.equal(line.status, 'unreadable');
  assert.match(line.message, /^in\/props\/deep\/torn\.obj:3: /);
  assert.deepEqual(line.files, []);
  assert.equal(existsSync(at('out/props/deep')), false);
  assert.equal(lineNamed(at('out'), 'props/atlas').status, 'done');
  // An empty mesh has no place in an atlas.
  writeFileSync(at('in/props/deep/torn.obj'), 'v 0 0 0\n');
  await batch(...args);
  const empty = lineNamed(at('out'), 'props/deep/atlas');
  assert.equal(empty.status, 'notFlattenable');
  assert.match(empty.message, /^in\/props\/deep\/torn\.obj: the mesh has no faces/);
  rmSync(at('in/props/deep/torn.obj'));
  assert.equal((await batch(...args)).code, 0);
  // What an atlas has left does not outlive it.
  writeFileSync(at('in/props/deep/wave.obj'), 'v 0 0 0\nf 1 1 9\n');
  assert.equal((await batch('in', '--out', 'out', '--resume')).code, 1);
  assert.equal(existsSync(at('out/props/deep/wave.obj')), false);
  assert.equal(existsSync(at('out/props/deep/fan.obj')), true);
});

test('a list names atlases, and a mesh may move to another', async (t) => {
  const { at, batch } = inFolder(t, {
    'a.obj': CUBE,
    'b.obj': grid(3),
    'c.obj': fan(6),
    'd.obj': CUBE,
    'list.csv': 'input,atlas,padding\na.obj,set/one,4\nb.obj,set/one,4\nc.obj,two,\nd.obj,,\n',
  });
  const args = ['--from', 'list.csv', '--out', 'out', '--resume'];
  assert.equal((await batch(...args)).code, 0);
  assert.deepEqual(
    manifestOf(at('out')).map(({ name, inputs }) => [name, ...inputs]),
    [
      ['d.obj', 'd.obj'],
      ['set/one', 'a.obj', 'b.obj'],
      ['two', 'c.obj'],
    ],
  );
  assertShared(at, lineNamed(at('out'), 'set/one'), 1024);
  writeFileSync(at('list.csv'), 'input,atlas\na.obj,set/one\nb.obj,two\nc.obj,two\nd.obj,\n');
  assert.equal((await batch(...args)).code, 0);
  assert.deepEqual(hasResults(at('out')), ['a.obj', 'b.obj', 'c.obj', 'd.obj']);
  for (const name of ['set/one', 'two']) assertShared(at, lineNamed(at('out'), name), 1024);
  assert.match((await batch(...args, '--dry-run')).stdout, /^0 to do, 3 done already/m);
});

test('parts of a run with atlases make the same manifest as the whole', async (t) => {
  const { at, batch } = inFolder(t, PROPS);
  const atlas = ['--atlas', 'folder'];
  assert.equal((await batch('in', '--out', 'whole', ...atlas)).code, 0);
  for (const part of ['0/2', '1/2']) await batch('in', '--out', 'parts', ...atlas, '--shard', part);
  const merged = await batch('--merge', '--out', 'parts');
  assert.equal(merged.code, 0, merged.stderr);
  const lasted = (folder) => manifestOf(at(folder)).map(({ seconds, peakMemory, ...line }) => line);
  assert.deepEqual(lasted('parts'), lasted('whole'));
});

test('faces are turned alike, and sets chosen, in each file of an atlas', async (t) => {
  const turned = CUBE.replace('f 1 2 6 5', 'f 5 6 2 1');
  const { at, batch } = inFolder(t, { 'in/a.obj': CUBE, 'in/b.obj': turned });
  const glb = ['--format', 'glb', '--texcoord', '1'];
  assert.equal((await batch('in', '--out', 'out', '--atlas', 'folder', '--orient')).code, 0);
  const facesOf = (name) => readFileSync(at(name), 'utf8').match(/^f .*$/gm);
  const withoutTexcoords = (line) => line.replaceAll(/\/\d+/g, '');
  const round = (line) => withoutTexcoords(line).slice(2).split(' ');
  const isSame = (a, b) => b.some((_, k) => [...b.slice(k), ...b.slice(0, k)].join() === a.join());
  for (const [i, face] of facesOf('out/b.obj').entries())
    assert.ok(isSame(round(face), round(facesOf('out/a.obj')[i])), face);
  assertShared(at, lineNamed(at('out'), 'atlas'), 1024);
  assert.equal((await batch('in', '--out', 'glb', '--atlas', 'folder', ...glb)).code, 0);
  assert.deepEqual(hasResults(at('glb')), ['a.glb', 'b.glb']);
});

test('texcoords are such as every file of an atlas can hold', async (t) => {
  const { at, batch } = inFolder(t, PROPS);
  await runAbflat(['unwrap', 'in/props/ring.obj', '-o', 'in/props/ring.ply'], { cwd: at() });
  rmSync(at('in/props/ring.obj'));
  rmSync(at('in/props/pyramid.off'));
  assert.equal((await batch('in/props', '--out', 'out', '--atlas', 'folder')).code, 0);
  assert.deepEqual(hasResults(at('out')), [
    'cube.obj',
    'deep/fan.obj',
    'deep/wave.obj',
    'ring.ply',
  ]);
  assertShared(at, lineNamed(at('out'), 'atlas'), 1024);
  const uvOf = (path) => readAtlas(at(path)).faces.flatMap((face) => face.flatMap(({ uv }) => uv));
  assert.ok(uvOf('out/cube.obj').every((x) => Math.fround(x) === x));
  assert.ok(uvOf('out/deep/wave.obj').some((x) => Math.fround(x) !== x));
});

for (const [args, list, code, sentence] of [
  [['--atlas', 'all'], null, 2, /--atlas: 'all' is neither file nor folder/],
  [['--atlas', 'folder', '--run', 'pack'], null, 2, /only unwrap lays several meshes in one atlas/],
  [['--atlas', 'folder', '--bake'], null, 2, /--bake: meshes that share an atlas are not baked/],
  [['--atlas', 'folder', '--keep', 'uv'], null, 2, /--keep: meshes that share an atlas are unwrap/],
  [['--atlas', 'folder', '--pins', 'list'], '', 2, /--pins: pins are about one mesh/],
  [['--atlas', 'folder', '--seams', 'file=list'], '', 2, /--seams: a file of seams is about one/],
  [
    ['--from', 'list'],
    'input,atlas,padding\nin/a.obj,x,1\nin/b.obj,x,2\n',
    2,
    /share an atlas, but/,
  ],
  [['--from', 'list'], 'input,atlas\nin/a.obj,x\nin/a.obj,y\n', 2, /is named for two atlases/],
  [['--from', 'list'], 'input,atlas\nin/a.obj,..\n', 3, /list:2: "\.\." is no name for an atlas/],
  [
    ['--from', 'list'],
    'input,atlas\nin/a.obj,in/b.obj\nin/b.obj,\n',
    2,
    /are both named in\/b\.obj/,
  ],
])
  test(`"abflat batch ${args.join(' ')}" with ${JSON.stringify(list)} is refused`, async (t) => {
    const files = { 'in/a.obj': CUBE, 'in/b.obj': CUBE };
    const { at, batch } = inFolder(t, list === null ? files : { ...files, list });
    const before = filesBelow(at());
    const inputs = args[0] === '--from' ? [] : ['in'];
    const run = await batch(...inputs, ...args, '--out', 'out');
    assert.equal(run.code, code, run.stderr);
    assert.match(run.stderr, sentence);
    assert.deepEqual(filesBelow(at()), before);
  });
