// Where seams come from: angles, what the mesh has, and files.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { drum, glbBytes, objWithGroups } from '../support/drums.mjs';
import { CUBE, CUBE_OF_PARTS } from '../support/small-meshes.mjs';
import { dropAndWait, openPage, pathOf, settled, textOf } from './page.mjs';
import { charts, edited, openGrid, SMALL } from './seam-page.mjs';

test('sources of seams: what the file has is offered, and they combine', async (t) => {
  const page = await openPage(t, { ...SMALL, open: ['cube.obj', CUBE] });
  assert.ok(await page.isHidden('#seams-hard'));
  assert.ok(await page.isHidden('#seams-uv'));
  assert.ok(await page.isHidden('#seams-material'));
  await page.click('#seams-sharp');
  await settled(page);
  assert.equal(await charts(page), 6);
  await page.fill('#sharp-degrees', '95');
  await settled(page);
  const blunt = await charts(page);
  assert.ok(blunt < 6);
  await page.fill('#sharp-degrees', '-3');
  assert.equal(await page.getAttribute('#sharp-degrees', 'aria-invalid'), 'true');
  await page.locator('#sharp-degrees').blur();
  assert.equal(await page.inputValue('#sharp-degrees'), '95');

  await dropAndWait(page, 'parts.obj', CUBE_OF_PARTS);
  assert.equal(await textOf(page, '#alert'), '');
  assert.ok(await page.isVisible('#seams-uv'));
  assert.ok(await page.isVisible('#seams-material'));
  await page.click('#seams-auto');
  await page.click('#seams-uv');
  await settled(page);
  assert.equal(await charts(page), 2);
  await page.click('#seams-material');
  await settled(page);
  assert.equal(await charts(page), 3);
});

test('seams on hard edges, from the groups of an OBJ and the normals of a glTF', async (t) => {
  const page = await openPage(t, { ...SMALL, open: ['drum.obj', objWithGroups(drum(12, 2))] });
  const ask = async () => {
    await page.click('#seams-hard');
    await page.click('#seams-auto');
    await settled(page);
    assert.equal(await page.getAttribute('#seams-hard', 'aria-pressed'), 'true');
    assert.equal(await charts(page), 3);
  };
  await ask();
  await dropAndWait(page, 'drum.glb', glbBytes(drum(12, 2)));
  assert.equal(await page.getAttribute('#seams-hard', 'aria-pressed'), 'false', 'another mesh');
  await ask();
  // Without the lid above it is a disk once its vertices are joined.
  const { faces, parts, ...rest } = drum(12, 2);
  const isKept = (_, i) => parts[i] < 2;
  const cup = { ...rest, faces: faces.filter(isKept), parts: parts.filter(isKept) };
  await dropAndWait(page, 'cup.glb', glbBytes(cup));
  await page.click('#seams-hard');
  await page.click('#seams-auto');
  await settled(page);
  assert.equal(await charts(page), 2);
  await dropAndWait(page, 'cube.obj', CUBE);
  assert.ok(await page.isHidden('#seams-hard'));
});

test('seams are opened from a file and saved to one', async (t) => {
  const page = await openGrid(t, 4);
  await page.click('#details-toggle');
  const open = (text) =>
    page.setInputFiles('#seams-file', {
      name: 'mine.txt',
      mimeType: 'text/plain',
      buffer: Buffer.from(text),
    });
  const text = '10 11\n11 12\n12 13\n13 14\n';
  await open(text);
  await page.waitForFunction(() => document.querySelector('#seams-state').textContent !== '');
  await settled(page);
  assert.equal(await edited(page), 4);
  assert.equal(await charts(page), 2);
  const [saved] = await Promise.all([page.waitForEvent('download'), page.click('#seams-save')]);
  assert.equal(saved.suggestedFilename(), 'grid-seams.txt');
  assert.equal(await textOf(page, '#run-text'), 'Saved grid-seams.txt');
  assert.equal(readFileSync(await pathOf(saved), 'utf8'), text);
  await open('10 11\n0 13\n');
  await page.waitForFunction(() => document.querySelector('#alert').textContent !== '');
  assert.match(await textOf(page, '#alert'), /mine\.txt:2: 0-13 is not an edge of any face\./);
  assert.equal(await edited(page), 4, 'the seams stay');
});
