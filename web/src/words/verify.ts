// The tab that verifies the layout on screen.

import type { VerifyRule } from 'abflat';
import { count, counted, measure } from './format';

/** What is wrong, by rule, with what to do about it. */
const RULES: Record<VerifyRule, { name: string; help: string }> = {
  flipped: { name: 'Turned over', help: 'Unwrap again, or allow mirrored islands' },
  empty: { name: 'No area', help: 'Faces that have no area in UV show a single color' },
  overlap: { name: 'Overlaps itself', help: 'Cut the island there' },
  overlapBetween: { name: 'Overlap', help: 'Pack the layout again' },
  stacked: { name: 'Same place', help: 'Allow stacked islands if that is on purpose' },
  outside: { name: 'Outside', help: 'Allow it for textures that repeat, or pack again' },
  padding: { name: 'Too near', help: 'Pack again with this padding' },
  margin: { name: 'At the edge', help: 'Pack again with this margin' },
  thin: { name: 'Too narrow', help: 'Join it with a neighbor, or raise the resolution' },
  density: { name: 'Texel density', help: 'Pack again at one density' },
  densityRatio: { name: 'Uneven density', help: 'Pack again at one density' },
  stretch: { name: 'Stretched', help: 'Cut the island further' },
  utilization: { name: 'Space', help: 'Pack the layout again' },
  islands: { name: 'Many islands', help: 'Join islands' },
  unmapped: { name: 'No UVs', help: 'Unwrap the mesh' },
  geometry: { name: 'Other faces', help: 'Unwrap without changing faces' },
  order: { name: 'Other order', help: 'Unwrap without changing the order' },
  attributes: { name: 'Other data', help: 'Unwrap without changing normals and materials' },
};

/** What a finding is about: faces that are listed, islands by their numbers on the page. */
interface Found {
  rule: VerifyRule;
  faces: readonly number[];
  value: number | null;
  limit: number | null;
}

/** "Island 3", "Islands 3 and 7" or "12 islands". */
function islandsText(islands: readonly number[]): string {
  if (islands.length === 1) return `Island ${count(islands[0])}`;
  if (islands.length === 2) return `Islands ${count(islands[0])} and ${count(islands[1])}`;
  return counted(islands.length, 'island');
}

/** Longer lists of faces are cut off. */
const MOST_FACES = 100;

const facesText = ({ length }: readonly number[]) =>
  length < MOST_FACES ? counted(length, 'face') : `${count(MOST_FACES)} faces or more`;

const asked = (value: number | null, limit: number | null, unit: string) =>
  `${measure(value ?? 0)}${unit}, asked for ${measure(limit ?? 0)}${unit}`;

function detail({ rule, faces, value, limit }: Found, islands: readonly number[]): string {
  switch (rule) {
    case 'flipped':
    case 'empty':
    case 'outside':
      return islands.length > 0
        ? `${facesText(faces)} of ${islandsText(islands).replace(/^I/, 'i')}`
        : facesText(faces);
    case 'unmapped':
    case 'geometry':
    case 'order':
    case 'attributes':
      return facesText(faces);
    case 'padding':
    case 'margin':
    case 'thin':
      return `${islandsText(islands)}: ${asked(value, limit, '\u202fpx')}`;
    case 'density':
      return `${facesText(faces)}: ${asked(value, limit, ' texels per unit')}`;
    case 'stretch':
      return `${islandsText(islands)}: ${asked(value, limit, '')}`;
    case 'densityRatio':
    case 'utilization':
    case 'islands':
      return asked(value, limit, '');
    default:
      return islandsText(islands);
  }
}

export const FINDING = {
  name: ({ rule }: Found) => RULES[rule].name,
  help: ({ rule }: Found) => RULES[rule].help,
  detail,
};

export const VERIFY = {
  about: 'Is the layout on screen ready for its texture? Choose what it has to keep to.',
  start: 'Verify',
  save: 'Save report',
  aboutSave: 'All that was measured and found, as JSON',
  noLayout: 'There is no layout yet.',
  stale: 'The layout has changed since.',
  progress: (fraction: number) => `${Math.round(100 * fraction)}\u202f%`,
  valid: (islands: number) => `Valid: ${counted(islands, 'island')}, nothing found`,
  found: (n: number) => `Not valid: ${counted(n, 'finding')}`,
  list: 'Findings',
  more: (n: number) => `${count(n)} more are in the report`,
  saved: (name: string) => `Saved ${name}`,
  fileName: (mesh: string) => `${mesh.replace(/\.[^.]*$/, '')}-verify.json`,
};

/** The rules that can be set. */
export const VERIFY_RULES = {
  resolution: { name: 'Texture', title: 'Side of the texture, which distances are measured in' },
  padding: { name: 'Padding', title: 'Least distance between two islands in texels' },
  maxStretch: {
    name: 'Max. stretch',
    title: 'Largest stretch of an island; 1 keeps all lengths. Empty: any',
    any: 'any',
  },
  allowStacked: {
    name: 'Stacked',
    title: 'Islands may lie on each other if they cover the same place',
  },
  allowMirrored: { name: 'Mirrored', title: 'Whole islands may be mirrored' },
  allowOutsideTiles: {
    name: 'Outside',
    title: 'Islands may leave their tile, as with textures that repeat',
  },
  allow: 'Allow',
};
