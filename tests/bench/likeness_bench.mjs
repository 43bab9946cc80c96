#!/usr/bin/env node
// Shows how layouts look to the people who use them; see USAGE.

import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { buildNative } from '../../scripts/build.mjs';
import { BUILD, NATIVE_PROGRAM } from '../../scripts/lib/paths.mjs';
import { Failure, runMain } from '../../scripts/lib/run.mjs';
import { montage, sheet, tile } from './support/likeness_pictures.mjs';
import {
  artistsLayout,
  givenMeshes,
  mediansOf,
  ownMeshes,
  unwrappedLayout,
} from './support/likeness_runs.mjs';
import { printTable } from './support/results.mjs';

const LOOKS = [
  ['seam', 'seam', 2],
  ['smooth', 'smooth', 2],
  ['flat', 'flat', 2],
  ['crease', 'crease', 2],
  ['exposed', 'exposed', 2],
  ['axis', 'axis', 2],
  ['upright', 'upright', 2],
  ['thin', 'thin', 2],
  ['small', 'small', 2],
  ['SD/4', 'sd', 4],
  ['stretched', 'stretched', 3],
  ['s', 'seconds', 2],
];
const COLUMNS = [
  ['mesh', 'mesh'],
  ['by', 'by'],
  ['faces', 'faces'],
  ['charts', 'charts'],
  ...LOOKS,
  ['valid', ({ valid }) => ({ true: 'yes', false: 'NO' })[valid]],
  ['unmet', ({ unmet }) => unmet && (unmet.join(' ') || 'none')],
];
const MEDIAN_COLUMNS = [
  ['medians', 'by'],
  ['meshes', 'meshes'],
  ['charts', 'charts', 1],
  ...LOOKS,
  ['valid', 'valid'],
  ['met', 'met'],
];

const USAGE = `npm run bench:likeness -- [MESH...] [--out FOLDER] [--up z] [options of abflat unwrap]

Measures and pictures of layouts, beside the layout that a mesh comes with. Without a mesh: ordinary
shapes, and the generated samples. ABFLAT_BIN names another program, and ABFLAT_BIN_BEFORE one to
compare it with. Writes FOLDER/index.html with a picture of each mesh from four sides, seams in red
and boundaries in blue, and of its layout; and FOLDER/montage.png with all of them.`;

const LEGEND = `
seam: outlines of charts, cuts on both sides; smooth, flat: cuts along edges that bend by less than 15 and 0.1 degrees; crease: share of
cuts along edges that bend by 30 degrees or more; exposed: cuts by the share of the sky they see (all these on the surface, over the root
of its area); axis: share of outlines that are level; upright: how far up is up, mean over charts; thin, small: shares of charts;
stretched: share of the surface stretched 1.25 times as much one way as another; unmet: see tests/support/ordinary-shapes.mjs`;

function argumentsOf(args) {
  const out = { meshes: [], folder: join(BUILD, 'likeness'), up: [0, 1, 0], options: [] };
  const rest = args.filter((arg) => arg !== '--');
  while (rest.length > 0) {
    const word = rest.shift();
    const isOwn = word === '--out' || word === '--up';
    if (isOwn && rest.length === 0) throw new Failure(`${word} needs a value.`);
    if (word === '--out') out.folder = rest.shift();
    else if (word === '--up') out.up = { y: [0, 1, 0], z: [0, 0, 1] }[rest.shift()];
    else if (word.startsWith('-') || out.options.length > 0) out.options.push(word);
    else out.meshes.push(word);
  }
  if (!out.up) throw new Failure('--up is y or z.');
  return out;
}

async function programs() {
  const { ABFLAT_BIN: program, ABFLAT_BIN_BEFORE: before } = process.env;
  if (!program) await buildNative();
  const now = { by: before ? 'after' : 'abflat', program: program ?? NATIVE_PROGRAM };
  return before ? [{ by: 'before', program: before }, now] : [now];
}

const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
const inPage = (canvas) => `data:image/png;base64,${canvas.png().toString('base64')}`;

function pageOf(sections, options) {
  const figures = sections.map(
    ({ rows, picture }) => `<h2>${escaped(rows[0].mesh)}</h2>
${rows.map((row) => `<p><b>${row.by}</b> ${escaped(captionOf(row))}</p>`).join('\n')}
<img src="${picture}" alt="${rows.map(({ by }) => by).join(', ')}">`,
  );
  return `<!doctype html>
<meta charset="utf-8">
<title>Layouts</title>
<style>body { font: 14px sans-serif; margin: 1em } p { margin: 0 } img { max-width: 100% }</style>
<h1>abflat unwrap ${escaped(options.join(' '))}</h1>
${figures.join('\n')}
`;
}

const captionOf = (row) =>
  [['charts', 'charts', 0], ...LOOKS]
    .filter(([, key]) => row[key] !== undefined)
    .map(([title, key, digits]) => `${title} ${row[key].toFixed(digits)}`)
    .concat(row.valid === false ? ['NOT VALID'] : [])
    .concat(row.unmet?.length > 0 ? [`unmet: ${row.unmet.join(' ')}`] : [])
    .join(', ');

/** By whom, in the order of the first rows. Only artists' layouts may be missing for some meshes. */
function medianRows(rows) {
  return [...new Set(rows.map(({ by }) => by))].map((by) => {
    const own = rows.filter((row) => row.by === by);
    const judged = own.filter(({ valid }) => valid !== undefined);
    const expected = own.filter(({ unmet }) => unmet);
    const share = (part, whole) =>
      whole.length > 0 ? `${part.length}/${whole.length}` : undefined;
    return {
      by,
      meshes: own.length,
      ...mediansOf(own),
      valid: share(
        judged.filter(({ valid }) => valid),
        judged,
      ),
      met: share(
        expected.filter(({ unmet }) => unmet.length === 0),
        expected,
      ),
    };
  });
}

async function layoutsOf(mesh, runs, up) {
  const artist = artistsLayout(mesh, up);
  const out = artist ? [artist] : [];
  for (const each of runs) out.push(await unwrappedLayout(mesh, each));
  return out;
}

await runMain(async () => {
  if (process.argv.includes('--help')) {
    console.log(USAGE);
    return;
  }
  const { meshes, folder, up, options } = argumentsOf(process.argv.slice(2));
  const found = await programs();
  mkdirSync(folder, { recursive: true });
  const scratch = mkdtempSync(join(tmpdir(), 'abflat-likeness-'));
  const [sections, tiles] = [[], []];
  try {
    const runs = found.map((each) => ({ ...each, folder: scratch, options, up }));
    const all =
      meshes.length > 0 ? givenMeshes(meshes) : await ownMeshes(found.at(-1).program, scratch);
    for (const mesh of all) {
      const layouts = await layoutsOf(mesh, runs, up);
      const rows = layouts.map(({ row }) => row);
      for (const { row, charted } of layouts)
        tiles.push(tile(charted, layouts.length > 1 ? `${row.by} ${mesh.name}` : mesh.name, up));
      const picture = sheet(
        layouts.map(({ charted }) => charted),
        up,
      );
      sections.push({ rows, picture: inPage(picture) });
    }
  } finally {
    rmSync(scratch, { recursive: true });
  }
  const rows = sections.flatMap((section) => section.rows);
  printTable(COLUMNS, rows);
  console.log('');
  printTable(MEDIAN_COLUMNS, medianRows(rows));
  console.log(LEGEND);
  const [page, overview] = ['index.html', 'montage.png'].map((name) => join(folder, name));
  writeFileSync(page, pageOf(sections, options));
  writeFileSync(overview, montage(tiles).png());
  console.log(`\n${page}\n${overview}`);
  const invalid = rows
    .filter(({ valid }) => valid === false)
    .map(({ mesh, by }) => `${mesh} (${by})`);
  if (invalid.length > 0) throw new Failure(`not valid: ${invalid.join(', ')}`);
});
