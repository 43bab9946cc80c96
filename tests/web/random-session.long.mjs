// Sessions of random actions: the page logs no error, still answers, and what it calls valid is.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { judgeFile } from '../support/exact-atlas.mjs';
import { CUBE_OF_PARTS, grid } from '../support/small-meshes.mjs';
import { objText, sphere, together, torus } from '../support/surfaces.mjs';
import { dropFiles, exportMesh, openPage, settled, textOf } from './page.mjs';

const SESSIONS = 4;
const ACTIONS = 500;
/** In milliseconds: what cannot be clicked by then is behind something else. */
const SOON = 2000;

const MESHES = {
  'cube.obj': CUBE_OF_PARTS,
  'torus.obj': objText(torus(24, 12)),
  'waves.obj': grid(10),
  'parts.obj': objText(
    together([
      [torus(16, 8), [0, 0, 0]],
      [sphere(6), [3, 0, 0]],
      [sphere(6), [-3, 0, 0]],
    ]),
  ),
};
const VIEWS = ['#layout-canvas', '#mesh-canvas'];
const MODIFIERS = ['Shift', 'Control', 'Alt'];
const KEYS = [
  ...'abceghilprsxz/.013579',
  ...['Enter', 'Escape', 'Alt+h', 'Control+z', 'Control+Shift+z', 'ArrowLeft', 'ArrowUp'],
];
/** What people press; nothing that opens a window of the system or leaves the page. */
const CONTROLS = [
  'button:visible:enabled:not(#open, [id*="file"], [id*="folder"])',
  '[role=tab]:visible',
  'select:visible:enabled',
  'input:is([type=range], [type=checkbox]):visible:enabled',
].join();

/** Numbers from 0 to 1 that are the same each time. */
function random(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function actions(page, next) {
  const pick = (list) => list[Math.floor(next() * list.length)];
  const open = async () => {
    const name = pick(Object.keys(MESHES));
    await dropFiles(page, { [name]: MESHES[name] });
    await settled(page);
  };
  const point = async () => {
    const { x, y, width, height } = await page.locator(pick(VIEWS)).boundingBox();
    const somewhere = () => [x + next() * width, y + next() * height];
    const key = next() < 0.5 ? null : pick(MODIFIERS);
    if (key) await page.keyboard.down(key);
    await page.mouse.move(...somewhere());
    await page.mouse.down();
    if (next() < 0.4) await page.mouse.move(...somewhere(), { steps: 4 });
    await page.mouse.up();
    if (key) await page.keyboard.up(key);
  };
  const press = async () => {
    await page.focus(pick(VIEWS));
    await page.keyboard.press(pick(KEYS));
  };
  const use = async () => {
    const controls = page.locator(CONTROLS);
    // This one, even if others come or go meanwhile.
    const nth = Math.floor(next() * (await controls.count()));
    const control = await controls.nth(nth).elementHandle({ timeout: SOON });
    const values = await control.evaluate((element) =>
      [...(element.options ?? [])].filter(({ disabled }) => !disabled).map(({ value }) => value),
    );
    // An image is chosen in a window of the system.
    const value = pick(values.filter((each) => each !== 'image'));
    if (value === undefined) await control.click({ timeout: SOON });
    else await control.selectOption(value, { timeout: SOON });
  };
  return () => {
    const share = next();
    if (share < 0.03) return open();
    if (share < 0.27) return point();
    return share < 0.5 ? press() : use();
  };
}

/** Whether an exported layout was judged. */
async function assertExport(page) {
  // Whatever is open over the page, and what is being moved.
  for (let i = 0; i < 3; ++i) await page.keyboard.press('Escape');
  await settled(page);
  if (!(await page.isEnabled('#export'))) return false;
  const badge = await textOf(page, '#badge');
  const said = [await textOf(page, '#verdict'), await page.textContent('#more-state')].join();
  const format = await textOf(page, '#export');
  // Where charts share texels or have tiles, the judge would have to know that.
  if (/stack|UDIM/i.test(said) || !/OBJ$/.test(format)) return false;
  if (!/^(Valid|Uneven|Stretched)$/.test(badge)) return false;
  const { isValid, ...found } = judgeFile((await exportMesh(page)).path);
  assert.ok(isValid, JSON.stringify(found));
  return true;
}

for (let seed = 1; seed <= SESSIONS; ++seed)
  test(`${ACTIONS} random actions, seed ${seed}`, async (t) => {
    const page = await openPage(t, { own: true, open: ['parts.obj', MESHES['parts.obj']] });
    page.on('dialog', (dialog) => dialog.accept());
    const act = actions(page, random(seed));
    let judged = 0;
    for (let i = 1; i <= ACTIONS; ++i) {
      await act().catch((error) => {
        if (error.name !== 'TimeoutError' && !/not attached/.test(error.message)) throw error;
      });
      if (i % 10 === 0 && (await assertExport(page))) judged += 1;
    }
    t.diagnostic(`${judged} layouts judged`);
    assert.ok(judged > 0);
  });
