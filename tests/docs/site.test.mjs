// The site of the documents: it is built, it has all pages, and its links lead somewhere.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { pageGroups } from '../../scripts/docs/pages.mjs';
import { buildSite } from '../../scripts/docs/site.mjs';
import { entryPoints } from '../../scripts/docs/typescript.mjs';
import { BUILD, ROOT } from '../../scripts/lib/paths.mjs';
import { which } from '../../scripts/lib/run.mjs';

const BASE = '/some/place/';

let folder;
let site;
let printed;
before(() => {
  mkdirSync(join(BUILD, 'tests'), { recursive: true });
  folder = mkdtempSync(join(BUILD, 'tests/docs-'));
  site = join(folder, 'site');
  const args = ['scripts/docs.mjs', '--out', site, '--base', BASE];
  const { status, stdout, stderr } = spawnSync(process.execPath, args, {
    cwd: ROOT,
    encoding: 'utf8',
  });
  printed = `${stdout}${stderr}`;
  assert.equal(status, 0, printed);
});
after(() => rmSync(folder, { recursive: true, force: true }));

const pathOf = (place) => join(site, place.replace(/\.md$/, '.html'));
const read = (path) => readFileSync(path, 'utf8');

/** The text of a page as people see it. */
const textOf = (html) =>
  html
    .replace(/<[^>]*>/g, '')
    .replaceAll('&lt;', '<')
    .replaceAll('&gt;', '>')
    .replaceAll('&amp;', '&');

/** Pages that VitePress has made. Those of Doxygen are not checked. */
const pages = () =>
  readdirSync(site, { recursive: true })
    .filter((name) => name.endsWith('.html') && !name.startsWith('cpp/') && name !== '404.html')
    .map((name) => join(site, name));

/** Where an address of a page leads to in the folder of the site; undefined if to elsewhere. */
function fileOf(page, address) {
  if (/^[a-z]+:/.test(address)) return undefined;
  const [path] = address.split(/[?#]/);
  if (path === '') return page;
  const full = path.startsWith('/')
    ? join(site, relative(BASE, path))
    : resolve(dirname(page), path);
  return path.endsWith('/') ? join(full, 'index.html') : full;
}

test('every document is a page, with its heading', () => {
  const all = pageGroups().flatMap((group) => group.pages);
  assert.ok(all.length > 20);
  for (const { file, place } of all) {
    const heading = read(join(ROOT, file))
      .match(/^# (.*)$/m)[1]
      .replaceAll('`', '');
    assert.ok(textOf(read(pathOf(place))).includes(heading), `${file}: ${heading}`);
  }
});

test('addresses of pages and pictures lead to files, anchors to headings', () => {
  const anchors = new Map();
  const anchorsIn = (file) => {
    if (!anchors.has(file))
      anchors.set(file, new Set([...read(file).matchAll(/ id="([^"]+)"/g)].map(([, id]) => id)));
    return anchors.get(file);
  };
  let checked = 0;
  for (const page of pages())
    for (const [, address] of read(page).matchAll(/ (?:href|src)="([^"]+)"/g)) {
      const file = fileOf(page, address);
      if (file === undefined) continue;
      const where = `${relative(site, page)}: ${address}`;
      assert.ok(existsSync(file), where);
      const anchor = address.split('#')[1];
      if (anchor) assert.ok(anchorsIn(file).has(decodeURIComponent(anchor)), where);
      ++checked;
    }
  assert.ok(checked > 1000);
});

test('every entry point of the npm package has a reference, with what its options do', () => {
  const points = entryPoints();
  assert.ok(points.length >= 3);
  for (const [name] of points) assert.ok(existsSync(pathOf(`reference/${name}.md`)), name);
  const text = textOf(read(pathOf('reference/abflat.md')));
  assert.ok(text.includes('largest stretch of a chart'));
  assert.ok(textOf(read(pathOf('reference/abflat/three.md'))).includes('unwrapGeometry()'));
});

test('all that the Python package exports has a reference', {
  skip: !which('python3') && 'there is no Python',
}, () => {
  const text = textOf(read(pathOf('reference/python.md')));
  const source = read(join(ROOT, 'native/python/abflat/__init__.py'));
  const names = [...source.match(/__all__ = \[(.*?)\]/s)[1].matchAll(/"(\w+)"/g)];
  for (const [, name] of names.filter(([, each]) => !each.startsWith('__')))
    assert.ok(text.includes(name), name);
  assert.ok(text.includes('get_mesh_vertex_assignment'));
});

test('public headers have a reference, or the build says why not', () => {
  if (which('doxygen') === undefined) {
    assert.match(printed, /Doxygen is not installed/);
    return;
  }
  assert.ok(read(join(site, 'cpp/unwrap_8h.html')).includes('Cuts any mesh into charts'));
  assert.ok(read(join(site, 'index.html')).includes('cpp/index.html'));
});

test('what is no site is not replaced', async () => {
  const kept = join(folder, 'kept');
  mkdirSync(kept);
  writeFileSync(join(kept, 'thesis.txt'), 'x');
  await assert.rejects(buildSite({ out: kept }), /kept has other files than a site/);
  assert.deepEqual(readdirSync(kept), ['thesis.txt']);
  await assert.rejects(
    buildSite({ out: join(folder, 'new'), base: 'abflat' }),
    /--base is "abflat"/,
  );
});

test('the start page names every door', () => {
  const text = read(join(site, 'index.html'));
  for (const door of ['page', 'command-line', 'javascript', 'python', 'cpp'])
    assert.match(text, new RegExp(`<td><a href="[^"]*${door}\\.html`), door);
});
