// How the page treats files that are dropped together, and results: modules that need no page.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadModule as load } from './modules.mjs';

const files = (...names) => names.map((name) => new File(['x'], name));

test('a mesh is found among its files in any order; of several all are offered', async () => {
  const { sourcesOf } = await load('opening/chosen-files');
  const names = (list) => sourcesOf(files(...list)).map(({ name }) => name);
  const parts = ['x.mtl', 'x.png', 'x.obj'];
  for (let turn = 0; turn < parts.length; turn++) {
    const [source, ...more] = sourcesOf(files(...parts));
    assert.deepEqual([source.name, more.length], ['x.obj', 0]);
    assert.deepEqual(source.others.map(({ name }) => name).sort(), ['x.mtl', 'x.png']);
    parts.push(parts.shift());
  }
  assert.deepEqual(names(['b.ply', 'a.STL', 'n.txt']), ['b.ply', 'a.STL']);
  assert.deepEqual(names(['b.ply', 's.gltf', 's.bin']), ['s.gltf', 'b.ply']);
  assert.deepEqual(names(['picture.png']), []);
  // Its content decides what it is.
  assert.deepEqual(names(['scan.data', 'scan.png']), ['scan.data']);
  const all = sourcesOf(files('a.obj', 'b.obj', 'c.obj'));
  for (const source of all) assert.deepEqual(source.together, all);
});

test('why nothing can be opened is a sentence with the name of the file', async () => {
  const { noMesh } = await load('opening/chosen-files');
  assert.match(noMesh(files('cat.png')), /^cat\.png is not a mesh\. Open an OBJ, .*\.$/);
  assert.match(noMesh(files('cat.png', 'dog.png')), /^None of these 2 files is a mesh\. .*\.$/);
});

const chart = (symmetricDirichlet, more = {}) => ({
  symmetricDirichlet,
  leeway: 1,
  valid: true,
  ...more,
});
const atlas = (maxStretch, seams, charts, valid = true) => ({
  mode: 'unwrap',
  settings: { maxStretch, seams },
  result: { report: { charts, valid } },
});

test('the badge of an atlas tells valid, stretched and not valid apart', async () => {
  const { verdictOf } = await load('details/verdict');
  const badge = (outcome) => verdictOf(outcome).badge;
  assert.equal(badge(atlas(1.04, 'auto', [chart(1.04), chart(1.01)])), 'Valid');
  const stretched = verdictOf(atlas(1.04, 'none', [chart(1.83), chart(1.2), chart(1)]));
  assert.deepEqual(stretched, {
    badge: 'Stretched',
    reason: 'Stretch up to 1.83 in 2 of 3 islands; limit 1.04',
    remedy: 'cut',
  });
  assert.equal(
    verdictOf(atlas(1.04, 'material', [chart(1.0402)])).reason,
    'Stretch 1.0402; limit 1.04',
  );
  // The front of a figure may stretch further.
  assert.equal(badge(atlas(1.02, 'auto', [chart(1.15, { leeway: 8 })])), 'Valid');
  assert.equal(badge(atlas(1.02, 'auto', [chart(1.17, { leeway: 8 })])), 'Stretched');
  // Automatic seams have already done what they can.
  assert.equal(verdictOf(atlas(1.04, 'auto,uv', [chart(2)])).remedy, null);
  // But not where charts were only packed again, or moved.
  const packed = atlas(1.04, 'auto', [chart(2)]);
  packed.settings.placed = {};
  assert.equal(verdictOf(packed).remedy, 'cut');
  packed.settings.seamEdges = new Uint32Array();
  assert.equal(verdictOf(packed).remedy, null);
  // Charts that the user keeps are not judged.
  assert.equal(badge(atlas(1.04, 'none', [chart(1.9, { solver: 'given' })])), 'Valid');
  assert.equal(badge(atlas(1.04, 'none', [chart(Number.NaN)])), 'Valid');
  const bad = atlas(
    1.04,
    'auto',
    [chart(3), chart(1, { valid: false, problem: 'it folds' })],
    false,
  );
  assert.deepEqual(verdictOf(bad), {
    badge: 'Not valid',
    reason: '1 island is not valid: it folds',
    remedy: null,
  });
  const outside = 'it extends beyond its tile';
  const over = 'it touches or overlaps the chart containing face 3 in the atlas';
  const wrong = (problem, more) => chart(1, { valid: false, problem, ...more });
  const moved = { solver: 'known', fixed: true };
  const both = [wrong(`${outside}, and ${over}`, moved), wrong(over, moved), wrong(over, moved)];
  assert.deepEqual(verdictOf(atlas(1.04, 'auto', both, false)), {
    badge: 'Not valid',
    reason: '1 island outside its tile, 3 islands overlap',
    remedy: 'pack',
  });
  // Packing helps neither those that stay, nor what folds.
  const locked = { solver: 'given', fixed: true };
  for (const charts of [[wrong(over, locked)], [wrong(over)], [...both, wrong('it folds', moved)]])
    assert.equal(verdictOf(atlas(1.04, 'auto', charts, false)).remedy, null);
});

test('beside islands that keep the uv of the file, others of another texel density are uneven', async () => {
  const { verdictOf } = await load('details/verdict');
  const given = { solver: 'given', fixed: true };
  /** `densities`: of two charts with uv of the file, then of a new one; all have the same area. */
  const badge = (densities, fixedFaces = 'uv') => {
    const outcome = atlas(1.04, 'auto', [chart(1, given), chart(1, given), chart(1)]);
    outcome.settings.fixedFaces = fixedFaces;
    outcome.result.report.atlas = { resolution: 100 };
    const all = { solid: Float64Array.of(1, 1, 1), asked: Float64Array.of(1, 1, 1) };
    const flat = Float64Array.from(densities, (each) => (each / 100) ** 2);
    const { badge, reason, remedy } = verdictOf(outcome, { ...all, flat });
    assert.equal(remedy, null);
    return `${badge}: ${reason}`;
  };
  assert.equal(badge([20, 20, 60]), 'Uneven: Texel density 20.0 to 60.0: kept UVs keep theirs');
  assert.equal(badge([20, 20, 10]), 'Uneven: Texel density 10.0 to 20.0: kept UVs keep theirs');
  assert.match(badge([20, 20, 21]), /^Valid/);
  assert.match(badge([20, 80, 60]), /^Valid/, 'those of the file are as they are');
  assert.match(badge([20, 20, 60], null), /^Valid/, 'locked islands are meant to differ');
});

test('the badge of a mesh in one piece turns with its lengths', async () => {
  const { verdictOf } = await load('details/verdict');
  const disk = (lengthDistortion, valid = true) =>
    verdictOf({
      mode: 'flatten',
      result: {
        report: { valid, charts: [{ lengthDistortion, problem: 'the boundary crosses itself' }] },
      },
    });
  assert.equal(disk(0.2).badge, 'Valid');
  assert.deepEqual([disk(4.81).badge, disk(4.81).remedy], ['Stretched', 'unwrap']);
  assert.match(disk(4.81).reason, /^Lengths change by 219\s% on average/);
  assert.deepEqual(disk(4.81, false).reason, 'The boundary crosses itself');
});

test('a number that was not used is said with its range and what is used instead', async () => {
  const { refusal } = await load('controls/number-field');
  assert.equal(
    refusal('t', '7', 'from 0.9 to 2', 'auto'),
    '7 was ignored: t must be from 0.9 to 2. It is still auto.',
  );
  assert.equal(
    refusal('Padding', '', 'a whole number from 0 to 256', '2'),
    'Padding must be a whole number from 0 to 256. It is still 2.',
  );
});

test('faces are those of the file: polygons beside their triangles', async () => {
  const { facesText } = await load('session/words');
  const mesh = { indices: new Uint32Array(3 * 968) };
  assert.equal(facesText(mesh, { faces: 500 }), '500 polygons, 968 triangles');
  assert.equal(facesText(mesh, { faces: 968 }), '968 triangles');
});

test('where islands are too large, the page says what to do on it', async () => {
  const { failure } = await load('session/words');
  const said = (text) => failure({ name: 'a.obj' }, { mode: 'unwrap' }, text);
  assert.equal(
    said(
      'at 900 texels per unit chart 874 does not fit a tile of 1024 texels. Lower the density to 55.7, or raise the resolution to 16833',
    ),
    'a.obj was not unwrapped: at 900 texels per unit, one island does not fit a tile of 1,024\u202fpx. Set Texel density, under More, to auto or to at most 55.7.',
    'no such resolution is offered',
  );
  assert.equal(
    said(
      'at 90 texels per unit the charts do not fit one tile of 1024 texels. Lower the density to 55.7, raise the resolution to 1683, or allow several tiles',
    ),
    'a.obj was not unwrapped: at 90 texels per unit, the islands do not fit one tile of 1,024\u202fpx. Set Texel density, under More, to auto or to at most 55.7, choose a resolution of 2,048\u202fpx, or switch on UDIM tiles.',
  );
  assert.equal(said('ran out of memory'), 'a.obj was not unwrapped: ran out of memory.');
});

test('cutting further adds automatic seams to those chosen, and can be taken back', async () => {
  const { SeamModel } = await load('seams/seam-model');
  const { seamOptions } = await load('seams/seam-choice');
  const model = new SeamModel(() => {
    throw new Error('No edge is needed.');
  });
  model.setSources({ auto: false, uv: false, material: true, sharp: null });
  model.cutFurther();
  assert.deepEqual(seamOptions(model.choice), { seams: 'auto,material' });
  const edges = Uint32Array.of(1, 2);
  model.setEdges(edges);
  assert.deepEqual(seamOptions(model.choice), { seams: 'none', seamEdges: edges });
  const before = model.choice;
  model.cutFurther();
  assert.deepEqual(seamOptions(model.choice), { seams: 'auto', seamEdges: edges });
  model.restore(before);
  assert.deepEqual(seamOptions(model.choice), { seams: 'none', seamEdges: edges });
  // Where seams are automatic already, those on screen are kept.
  model.setSources({ auto: true, uv: false, material: false, sharp: null });
  model.show(edges);
  model.cutFurther();
  assert.deepEqual(seamOptions(model.choice), { seams: 'auto', seamEdges: edges });
});
