// Settings as text in the address of the page, and what is kept of a visit, without a page.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { randomNumbers } from '../support/disks.mjs';
import { loadModule } from './modules.mjs';

const { settingsOf, textOf, usualSettings } = await loadModule('visit/settings-text');
const { fitting } = await loadModule('visit/settings-link');
const { visitOf, settingsAskedFor } = await loadModule('visit/visit-record');
const { STRETCHES } = await loadModule('controls/atlas-control');
const { RESOLUTIONS } = await loadModule('model/settings');

const SEAMS = [
  'auto',
  'none',
  'hard',
  'uv',
  'material',
  'sharp=60',
  'auto,hard,uv,material,sharp=0.125',
];

function randomSettings(next) {
  const pick = (values) => values[Math.floor(next() * values.length)];
  const t = () => pick(['auto', 1, 1.25, 0.9 + next()]);
  const balance = () => Number((Math.floor(next() * 21) * 0.05).toFixed(2));
  const isOn = () => next() < 0.5;
  const resolution = pick(RESOLUTIONS);
  if (next() < 0.3) return { mode: 'flatten', t: t(), balance: balance(), delaunay: isOn() };
  if (next() < 0.1) return { mode: 'pack', keepPlaces: true, resolution };
  if (next() < 0.3)
    return {
      ...{ mode: 'pack', keepPlaces: false, resolution, padding: Math.floor(next() * 257) },
      margin: pick(['auto', 0, 256]),
      rotate: pick(['auto', 'free', 'quarter', 'none']),
      islandSizes: pick(['keep', 'even']),
      tiles: pick(['one', 'file', 'object', 'material']),
    };
  return {
    mode: 'unwrap',
    maxStretch: pick(STRETCHES),
    balance: balance(),
    resolution,
    padding: Math.floor(next() * 257),
    fillHoles: pick(['auto', 'never', 'always']),
    symmetricSeams: pick(['auto', 'never', 'always']),
    t: t(),
    texelDensity: pick(['auto', 1e-9 + next(), 1e6 * next() + 1]),
    up: pick(['auto', 'y', 'z']),
    rotate: pick(['auto', 'free', 'quarter', 'none']),
    rectify: pick(['auto', 'never', 'always']),
    packingCuts: pick(['auto', 'never']),
    stack: pick(['none', 'identical', 'mirrored']),
    straightSeams: isOn(),
    udim: isOn(),
    seams: pick(SEAMS),
    ...(isOn() && { fixedFaces: 'uv' }),
  };
}

test('settings come back from their text', () => {
  const next = randomNumbers(7);
  for (let i = 0; i < 500; i++) {
    const settings = randomSettings(next);
    assert.deepEqual(settingsOf(textOf(settings)), { settings, ignored: [] });
  }
});

test('the text has what differs from the defaults, in the words of the command line', () => {
  assert.equal(textOf(usualSettings('unwrap')), '');
  assert.equal(textOf(usualSettings('flatten')), 'flatten');
  const some = { maxStretch: 1.05, rotate: 'none', udim: true, seams: 'auto,sharp=60' };
  const text = 'unwrap&max-stretch=1.05&rotate=none&udim&seams=auto,sharp=60';
  assert.equal(textOf({ ...usualSettings('unwrap'), ...some }), text);
  const edited = { ...usualSettings('unwrap'), seams: 'none', seamEdges: Uint32Array.of(0, 1) };
  assert.equal(textOf(edited), '', 'edited seams are of one mesh');
  assert.equal(settingsOf('max-stretch=1.05').settings.maxStretch, 1.05);
  assert.equal(settingsOf('seams=auto%2Csharp%3D30').settings.seams, 'auto,sharp=30');
});

test('what means nothing is ignored, one by one', () => {
  for (const word of [
    ...['foo', 'foo=1', '=', '%', 'flat', 'max-stretch', 'max-stretch=', 'max-stretch=0.5'],
    ...['max-stretch=1.07', 'resolution=1000', 'padding=-1', 'padding=2.5', 'padding=auto'],
    ...['balance=0.33', 'balance=2', 't=0', 't=NaN', 't=Infinity', 'no-t=1', 'udim=1', 'delaunay'],
    ...['seams=sharp', 'seams=sharp=0', 'seams=sharp=181', 'seams=uv,auto', 'seams=', 'keep=all'],
    ...['rotate', 'rotate=false', 'no-rotate', 'up=x'],
    ...['fill-holes=maybe', 'maxStretch=1.05', 'threads=4', 'constructor=1', 'toString'],
  ]) {
    const { settings, ignored } = settingsOf(`unwrap&${word}&padding=5`);
    assert.deepEqual(settings, { ...usualSettings('unwrap'), padding: 5 }, word);
    assert.deepEqual(ignored, [word]);
  }
  assert.deepEqual(settingsOf('flatten&t=3&t=0.5&udim').ignored, ['t=3', 't=0.5', 'udim']);
});

test('a mesh without UVs, materials or normals is not cut along them', () => {
  const NOTHING = { texcoords: 0, materials: 1, normals: 0, smoothingGroups: 0 };
  const cut = (seams, has, more) =>
    fitting({ ...usualSettings('unwrap'), seams, ...more }, { ...NOTHING, ...has });
  assert.equal(cut('auto,uv').seams, 'auto');
  assert.equal(cut('uv').seams, 'auto');
  assert.equal(cut('none').seams, 'none');
  assert.equal(cut('uv,material', { materials: 2 }).seams, 'material');
  assert.equal(cut('uv', { texcoords: 3 }).seams, 'uv');
  assert.equal(cut('hard').seams, 'auto');
  assert.equal(cut('auto,hard', { normals: 3 }).seams, 'auto,hard');
  assert.equal(cut('hard,sharp=60', { smoothingGroups: 1 }).seams, 'hard,sharp=60');
  assert.equal(cut('auto', {}, { fixedFaces: 'uv' }).fixedFaces, undefined);
  assert.equal(cut('auto', { texcoords: 3 }, { fixedFaces: 'uv' }).fixedFaces, 'uv');
});

test('a mesh without UVs is unwrapped where a link asks for those of the file', () => {
  const asked = settingsOf('pack&keep-places').settings;
  assert.equal(asked.mode, 'pack');
  const NOTHING = { texcoords: 0, materials: 1, normals: 0, smoothingGroups: 0 };
  assert.deepEqual(fitting(asked, NOTHING), usualSettings('unwrap'));
  assert.equal(fitting(asked, { ...NOTHING, texcoords: 3 }), asked);
  assert.equal(fitting(asked, NOTHING, true), asked, 'joined vertices have lost them');
});

test('a record that is none is refused', () => {
  const sample = { kind: 'sample', name: 'head' };
  for (const [mesh, asked] of [
    [sample, undefined],
    [sample, {}],
    [undefined, { text: '' }],
    [{ kind: 'file', name: 'a.obj', file: 'a', others: [] }, { text: '' }],
  ])
    assert.throws(() => visitOf(mesh, asked));
  assert.deepEqual(visitOf(sample, { text: '' }).source, sample);
  const atlas = {};
  const settings = settingsAskedFor({ text: 'padding=5', atlas, locked: Uint32Array.of(1) });
  assert.equal(settings.padding, 5);
  assert.equal(settings.placed, atlas);
  assert.equal(settings.kept.layout, atlas);
});
