// Archives with a mesh and all that belongs to it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { strToU8, zipSync } from 'fflate';
import { BLUE, oneColor, RED } from '../support/painted.mjs';
import { CUBE } from '../support/small-meshes.mjs';
import { loadModule } from './modules.mjs';
import { dropAndWait, dropFiles, openPage, settled, textOf } from './page.mjs';

const TEXTURED = CUBE.replace(/^f/m, 'mtllib looks/cube.mtl\nusemtl wood\nf');
const MTL = 'newmtl wood\nmap_Kd ../images/wood/color.png\n';

const refused = async (page, zip) => {
  await dropFiles(page, { 'a.zip': zip });
  await page.waitForFunction(() => document.querySelector('#alert').textContent !== '');
  await settled(page);
  const alert = await page.locator('#alert .alert-text').innerText();
  await page.click('#alert .alert-close');
  return alert;
};

/** Changes the directory of an archive; `at`: bytes behind the beginning of its first entry. */
function withEntry(zip, at, change) {
  const changed = Buffer.from(zip);
  change(changed, changed.indexOf(Buffer.from('PK\x01\x02', 'latin1')) + at);
  return changed;
}

test('a mesh opens with its materials from the folders of an archive', async (t) => {
  const page = await openPage(t);
  const zip = zipSync({
    'scene/cube.obj': strToU8(TEXTURED),
    'scene/looks/cube.mtl': strToU8(MTL),
    'scene/images/stone/color.png': oneColor(BLUE),
    'scene/images/wood/color.png': oneColor(RED),
    '__MACOSX/scene/._cube.obj': strToU8('what a system keeps beside a file'),
    'scene/.hidden.obj': strToU8(CUBE),
    'more.zip': strToU8('not opened'),
  });
  await dropFiles(page, { 'all.ZIP': zip });
  await page.waitForFunction(() => document.querySelector('#source').textContent === 'cube.obj');
  await settled(page);
  assert.equal(await textOf(page, '#alert'), '');
  assert.equal(await textOf(page, '#notice'), '', 'nothing is missing');
  assert.equal(await textOf(page, '#badge'), 'Valid');
  await page.locator('#shading option[value="materials"]').waitFor({ state: 'attached' });
});

test('archives that cannot be opened are refused in a sentence, and the mesh stays', async (t) => {
  const page = await openPage(t, { settles: false });
  await dropAndWait(page, 'cube.obj', CUBE);
  const zip = zipSync({ 'b.obj': strToU8(CUBE) });
  const setFlag = (bytes, at) => bytes.writeUInt16LE(bytes.readUInt16LE(at) | 1, at);
  assert.match(await refused(page, withEntry(zip, 8, setFlag)), /^a\.zip has a password\./);
  const setSize = (bytes, at) => bytes.writeUInt32LE(0x7fffffff, at);
  assert.match(
    await refused(page, withEntry(zip, 24, setSize)),
    /^a\.zip unpacks to more than 1 GB\./,
  );
  assert.match(
    await refused(page, strToU8('PK no archive')),
    /^a\.zip cannot be read as a ZIP file\./,
  );
  assert.match(await refused(page, zipSync({ '.x': strToU8('') })), /^a\.zip contains no files\./);
  assert.match(
    await refused(page, zipSync({ 'a.md': strToU8('#') })),
    /is not a mesh|cannot be read|not supported/,
  );
  const many = Object.fromEntries(
    Array.from({ length: 1001 }, (_, i) => [`${i}.txt`, strToU8('')]),
  );
  assert.match(await refused(page, zipSync(many)), /^a\.zip contains more than 1000 files\./);
  assert.equal(await textOf(page, '#source'), 'cube.obj');
});

test('of files with one name, the one in the folder that is meant is taken', async () => {
  const { fileNamed } = await loadModule('files/missing-files');
  const { sourcesOf } = await loadModule('opening/chosen-files');
  const files = ['a/x.png', 'b/maps/x.png', 'c/maps/x.png', 'b/m.obj', 'c/n.obj'].map((name) => ({
    name,
  }));
  assert.equal(fileNamed('maps/x.png', files), files[1]);
  assert.equal(fileNamed('c\\MAPS\\X.png', files), files[2]);
  assert.equal(fileNamed('../a/x.png', files), files[0]);
  assert.equal(fileNamed('y.png', files), undefined);
  const [m, n] = sourcesOf(files);
  assert.deepEqual([m.name, n.name], ['m.obj', 'n.obj']);
  assert.equal(fileNamed('maps/x.png', m.others), files[1]);
  assert.equal(fileNamed('maps/x.png', n.others), files[2]);
});
