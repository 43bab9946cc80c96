// Compares the tables of ARCHITECTURE.md, which say which room may use which from top to bottom,
// with includes and imports.

import { existsSync, readFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { filesBelow } from './stamp.mjs';

const DOCUMENT = 'ARCHITECTURE.md';
const PUBLIC = 'core/include';
const CODE = /\.(h|cpp|ts)$/;
const NAMES = {
  include: /^[ \t]*#[ \t]*include[ \t]+"([^"]+)"/gm,
  import:
    /(?:^|[\s;}])(?:import|export)\s[^'";]*?from\s+['"](\.[^'"]+)['"]|(?:^|[\s;=(])import\s*\(?\s*['"](\.[^'"]+)['"]/gm,
};

/**
 * The tables that begin with `| layers of FOLDER | ... |`, as `{ folder, rowOf, headerRow }`: the row of each room, and of each
 * public header that belongs to one.
 */
export function layersIn(text) {
  const tables = [];
  let rows;
  for (const line of text.split('\n')) {
    const cells = line.startsWith('|') && line.split('|').slice(1, -1);
    if (!cells) {
      rows = undefined;
      continue;
    }
    const head = /^\s*layers of `([^`]+)`/.exec(cells[0]);
    if (head) {
      rows = { folder: head[1], rowOf: new Map(), headerRow: new Map(), count: 0 };
      tables.push(rows);
    } else if (rows && !/^\s*-+\s*$/.test(cells[0])) {
      const names = cells.map((cell) => [...cell.matchAll(/`([^`]+)`/g)].map((match) => match[1]));
      for (const room of names[0]) rows.rowOf.set(room, rows.count);
      for (const header of names[1] ?? []) rows.headerRow.set(header, rows.count);
      rows.count += 1;
    }
  }
  return tables;
}

function namesIn(file, text) {
  const matches = text.matchAll(/\.(h|cpp)$/.test(file) ? NAMES.include : NAMES.import);
  return [...matches].map(([, first, second]) => first ?? second);
}

/**
 * The file that a name refers to, as a path below `root`; undefined if it is not one of the
 * project's.
 */
function fileOf(name, from, root, folder) {
  if (/\.(h|cpp)$/.test(from)) {
    const candidates = [join(dirname(from), name), join(folder, name), join(PUBLIC, name)];
    return candidates.find((path) => existsSync(join(root, path)));
  }
  const path = join(dirname(from), name).replace(/\.js$/, '');
  return [path, `${path}.ts`].find((each) => CODE.test(each) && existsSync(join(root, each)));
}

/** A room is a folder; files beside the rooms form a room of their own, `.`. */
function roomOf(file, folder) {
  const [first, ...rest] = relative(folder, file).split('/');
  return rest.length > 0 ? first : '.';
}

function rowOf(file, { folder, rowOf: rooms, headerRow }) {
  if (!file.startsWith(`${PUBLIC}/`)) return rooms.get(roomOf(file, folder));
  return headerRow.get(relative(`${PUBLIC}/abflat`, file)) ?? Number.POSITIVE_INFINITY;
}

/**
 * A cycle of files that use each other, from the first one back to it; undefined if there is none.
 */
function circleIn(uses) {
  const done = new Set();
  const path = [];
  const visit = (file) => {
    if (path.includes(file)) return [...path.slice(path.indexOf(file)), file];
    if (done.has(file)) return undefined;
    path.push(file);
    for (const next of uses.get(file) ?? []) {
      const circle = visit(next);
      if (circle) return circle;
    }
    path.pop();
    done.add(file);
    return undefined;
  };
  for (const file of uses.keys()) {
    const circle = visit(file);
    if (circle) return circle;
  }
  return undefined;
}

function faultsIn(table, root) {
  const { folder, rowOf: rooms } = table;
  const files = filesBelow([folder], root)
    .map((file) => relative(root, file))
    .filter((file) => CODE.test(file));
  const faults = [];
  const found = new Set(files.map((file) => roomOf(file, folder)));
  for (const room of found)
    if (!rooms.has(room)) faults.push(`${folder}/${room} is in no layer of ${DOCUMENT}`);
  for (const room of rooms.keys())
    if (!found.has(room))
      faults.push(`${DOCUMENT} has a layer for ${folder}/${room}, where nothing is`);
  const uses = new Map();
  for (const file of files) {
    const used = namesIn(file, readFileSync(join(root, file), 'utf8'))
      .map((name) => fileOf(name, file, root, folder))
      .filter((path) => path?.startsWith(`${folder}/`) || path?.startsWith(`${PUBLIC}/`));
    uses.set(file, used);
    for (const other of used) {
      const isSameRoom =
        other.startsWith(`${folder}/`) && roomOf(other, folder) === roomOf(file, folder);
      const own = rowOf(file, table);
      // A public header belongs to the room that implements it.
      const isOwnHeader = other.startsWith(`${PUBLIC}/`) && rowOf(other, table) === own;
      if (!isSameRoom && !isOwnHeader && !(rowOf(other, table) > own))
        faults.push(`${file} uses ${other}, which is not below it`);
    }
  }
  const circle = circleIn(uses);
  if (circle) faults.push(`these use each other: ${circle.join(' -> ')}`);
  return faults;
}

/** One sentence for each dependency that does not point down. */
export function layerFaults(root) {
  const tables = layersIn(readFileSync(join(root, DOCUMENT), 'utf8'));
  if (tables.length === 0) return [`${DOCUMENT} has no table of layers`];
  return tables.flatMap((table) => faultsIn(table, root));
}
