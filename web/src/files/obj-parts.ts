// Which triangles of an OBJ belong to which object and which material.

import type { NamedPart, NamedParts } from '../model/named-parts';
import { linesOf } from './obj-corners';

const NAMING = /^[ \t]*(?:o|g|usemtl)[ \t]/m;

/** Of each face, a number of `names`; the first one is no name. */
interface Named {
  names: string[];
  numbers: number[];
}

/** Groups are objects where there are no others. `faces`: as in DisplayMesh. */
export function objParts(text: string, triangles: number, faces?: Uint32Array): NamedParts {
  if (!NAMING.test(text)) return { objects: [], materials: [] };
  const kinds = { o: named(), g: named(), usemtl: named() };
  const current = { o: 0, g: 0, usemtl: 0 };
  for (const line of linesOf(text)) {
    const [keyword] = line.split(/\s/, 1);
    if (keyword === 'f')
      for (const kind of ['o', 'g', 'usemtl'] as const) kinds[kind].numbers.push(current[kind]);
    else if (keyword in kinds) {
      const kind = keyword as keyof typeof kinds;
      current[kind] = numberOf(line.slice(keyword.length).trim(), kinds[kind].names);
    }
  }
  const objects = kinds.o.names.length > 1 ? kinds.o : kinds.g;
  const partsOf = (each: Named) => partsIn(each, triangles, faces);
  return { objects: partsOf(objects), materials: partsOf(kinds.usemtl) };
}

const named = (): Named => ({ names: [''], numbers: [] });

function numberOf(name: string, names: string[]): number {
  const known = names.indexOf(name);
  return known < 0 ? names.push(name) - 1 : known;
}

/** Those with triangles. */
function partsIn({ names, numbers }: Named, triangles: number, faces?: Uint32Array): NamedPart[] {
  const parts = names.map((name, i): NamedPart => ({ name, isThere: i > 0, copies: 1, runs: [] }));
  let before = -1;
  for (let f = 0; f < triangles; ++f) {
    const number = numbers[faces ? faces[f] : f] ?? 0;
    const { runs } = parts[number];
    if (number === before) ++runs[runs.length - 1][1];
    else runs.push([f, 1]);
    before = number;
  }
  return parts.filter(({ runs }) => runs.length > 0);
}
