// Builds the site: documents and references in one folder, from which VitePress makes pages.

import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  renameSync,
  rmSync,
} from 'node:fs';
import { join, relative } from 'node:path';
import { build } from 'vitepress';
import { licensesOf } from '../lib/licenses.mjs';
import { BUILD, ROOT } from '../lib/paths.mjs';
import { Failure } from '../lib/run.mjs';
import { writeCppReference } from './cpp.mjs';
import { pageGroups } from './pages.mjs';
import { writePythonReference } from './python.mjs';
import { REPOSITORY, stagePages, write } from './stage.mjs';
import { writeTypeScriptReference } from './typescript.mjs';

/** What VitePress puts into a site. */
const CONTENTS = [
  'vitepress',
  'vue',
  '@vue/devtools-api',
  '@vueuse/core',
  '@vueuse/integrations',
  'focus-trap',
  'mark.js',
  'minisearch',
  'tabbable',
];

const HERE = join(ROOT, 'scripts/docs');

const HEADERS = `${REPOSITORY}/tree/main/core/include/abflat`;

/**
 * Writes the references into the folder of the pages. Returns those that are there, for the
 * sidebar, and a sentence for each that is not.
 */
async function writeReferences(folder) {
  const references = (await writeTypeScriptReference(join(folder, 'reference'))).map((title) => ({
    place: `reference/${title}.md`,
    title,
  }));
  const missing = [];
  const withoutPython = writePythonReference(join(folder, 'reference/python.md'));
  if (withoutPython) missing.push(withoutPython);
  else references.push({ place: 'reference/python.md', title: 'Python' });
  const cpp = join(folder, 'public/cpp');
  mkdirSync(cpp, { recursive: true });
  const withoutCpp = writeCppReference(cpp);
  if (withoutCpp) missing.push(withoutCpp);
  references.push({ title: 'C++ headers', address: withoutCpp ? HEADERS : '/cpp/index.html' });
  return { references, missing };
}

/** VitePress reads its configuration from a file. */
function writeConfig(folder, values) {
  const config = relative(join(folder, '.vitepress'), join(HERE, 'config.mjs'));
  write(
    join(folder, '.vitepress/config.mjs'),
    `import { siteConfig } from '${config}';\n\nexport default siteConfig(${JSON.stringify(values)});\n`,
  );
  cpSync(join(HERE, 'theme'), join(folder, '.vitepress/theme'), { recursive: true });
  cpSync(join(ROOT, 'web/public/icon.svg'), join(folder, 'public/icon.svg'));
  const entries = CONTENTS.map((name) => `node_modules/${name}`);
  write(join(folder, 'public/THIRD_PARTY_LICENSES.txt'), licensesOf(entries));
}

/** Runs VitePress on a folder of pages; the result replaces `out` once it is complete. */
async function buildPages(folder, out) {
  const fresh = `${out}.tmp`;
  rmSync(fresh, { recursive: true, force: true });
  try {
    await build(folder, { outDir: fresh });
  } catch (error) {
    throw new Failure(`VitePress could not build the site: ${error.message}`);
  }
  rmSync(out, { recursive: true, force: true });
  renameSync(fresh, out);
}

/** What would be replaced has to be an earlier site, not what somebody keeps there. */
function checkOut(out) {
  const names = existsSync(out) ? readdirSync(out) : [];
  if (names.length > 0 && !names.includes('hashmap.json'))
    throw new Failure(`${out} has other files than a site: name another folder with --out.`);
}

/**
 * Builds the site into `out`. `base` is the path below which it will be served. Returns a sentence
 * for each reference that is left out.
 */
export async function buildSite({ out, base = '/' }) {
  if (!/^\/(.*\/)?$/.test(base))
    throw new Failure(`--base is "${base}"; it must begin and end with a slash, as in /abflat/.`);
  checkOut(out);
  // Inside the repository, where VitePress finds its packages.
  mkdirSync(BUILD, { recursive: true });
  const folder = mkdtempSync(join(BUILD, 'docs-pages-'));
  try {
    const groups = pageGroups();
    stagePages(groups, folder);
    const { references, missing } = await writeReferences(folder);
    writeConfig(folder, { groups, references, base, repository: REPOSITORY });
    await buildPages(folder, out);
    return missing;
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
