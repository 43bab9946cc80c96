import {
  type KnownLayout,
  PACK_DEFAULTS,
  type PackOptionValues,
  type UnwrapResult,
  type VertexBound,
} from 'abflat';
import type { Bound } from '../words/format';
import type { FaceDensities } from './face-densities';
import type { MoreOptions } from './more-options';

/** What a run can take over of an atlas. */
export type KnownAtlas = KnownLayout & Pick<UnwrapResult, 'uv' | 'seams'>;

/** An atlas whose charts are to be used as they are. */
export interface Placed extends KnownAtlas {
  /** They are packed anew; otherwise they stay where they are. */
  repacks?: true;
  /** They are packed anew if they do not fit where they are. */
  mayRepack?: true;
}

/** Charts to keep where they are. */
export interface Kept {
  layout: KnownAtlas;
  charts: Uint32Array;
}

/** A disk in one piece, any mesh in charts, or the UVs of the file. */
export type Mode = 'flatten' | 'unwrap' | 'pack';

/** What the user can ask of a layout. */
export interface FlattenSettings {
  mode: 'flatten';
  t: Bound;
  balance: number;
  delaunay: boolean;
  /** For vertices of the boundary, in place of t. */
  bounds?: VertexBound[];
}

/** What is marked in an atlas, which is no reason to lay out again. */
export interface Marks {
  /** Charts kept where they already are. */
  kept?: Kept;
  /** Corners of the atlas's triangles whose vertices are pinned. */
  pins?: Uint32Array;
}

/** Texels along a side of an atlas that are offered. */
export const RESOLUTIONS = [256, 512, 1024, 2048, 4096, 8192];

/** What the user can ask of an atlas. */
export interface UnwrapSettings extends MoreOptions, Marks {
  mode: 'unwrap';
  maxStretch: number;
  balance: number;
  /** Texels along a side. */
  resolution: number;
  /** Texels between charts. */
  padding: number;
  /** As the command line takes it. */
  seams: string;
  /** Edges to cut in addition, two vertices each. */
  seamEdges?: Uint32Array;
  /** Charts that were scaled keep their size when they are packed anew. */
  faceDensities?: FaceDensities;
  /** The layout with charts where the user has moved them, or that is packed again. */
  placed?: Placed;
}

/** Where islands of a file are packed: in one tile, in those that they are in, or in one for each part. */
export const TILES = ['one', 'file', 'object', 'material'] as const;
export type Tiles = (typeof TILES)[number];

/** How the islands of a file are packed. */
export interface PackChoices
  extends Pick<PackOptionValues, 'padding' | 'margin' | 'rotate' | 'islandSizes'> {
  tiles: Tiles;
}

/** What the user can ask of the UVs of a file. */
export interface PackSettings extends Partial<PackChoices> {
  mode: 'pack';
  /** They are shown as they are. */
  keepPlaces: boolean;
  /** Texels along a side. */
  resolution: number;
  /** In place of the UVs of the file, 2 per corner of its triangles: they were changed by hand. */
  uv?: Float64Array;
}

export type Settings = FlattenSettings | UnwrapSettings | PackSettings;

export function usualPackChoices(): PackChoices {
  const { padding, margin, rotate, islandSizes } = PACK_DEFAULTS;
  return { padding, margin, rotate, islandSizes, tiles: 'one' };
}

/** How islands are packed does not matter while they stay where they are. */
export const packSettings = (
  keepPlaces: boolean,
  resolution: number,
  choices: PackChoices,
  uv?: Float64Array,
): PackSettings => ({
  ...{ mode: 'pack', keepPlaces, resolution },
  ...(!keepPlaces && choices),
  ...(uv && { uv }),
});

/** Whether the UVs are those of the file. */
export const isAsInFile = (settings: PackSettings): boolean =>
  settings.keepPlaces && settings.uv === undefined;

/** Whether the layout itself depends on what was done by hand to this mesh, which no other mesh takes over. */
export function isMadeByHand(settings: Settings): boolean {
  if (settings.mode === 'flatten') return settings.bounds !== undefined;
  if (settings.mode === 'pack') return settings.uv !== undefined;
  const { seamEdges, placed, faceDensities } = settings;
  const isMoved = placed !== undefined && !placed.repacks;
  return isMoved || Boolean(seamEdges ?? faceDensities);
}

/** Whether anything is marked by hand, which shows in no file. */
const isMarked = (settings: Settings): boolean =>
  settings.mode === 'unwrap' &&
  ((settings.kept?.charts.length ?? 0) > 0 || (settings.pins?.length ?? 0) > 0);

/** Whether there is anything that another mesh would not take over. */
export const isByHand = (settings: Settings): boolean =>
  isMadeByHand(settings) || isMarked(settings);

export const sameSettings = (a: Settings, b: Settings): boolean => differsOnlyIn([], a, b);

/** Whether two atlases differ in nothing but their seams, so that the charts that both have can stay. */
export const sameButSeams = (a: UnwrapSettings, b: UnwrapSettings): boolean =>
  differsOnlyIn(['seams', 'seamEdges', 'placed'], a, b);

function differsOnlyIn(names: string[], a: Settings, b: Settings): boolean {
  const [x, y] = [a, b].map((settings) => {
    // An option that is not there is one that is undefined.
    const values = new Map(Object.entries(settings).filter(([, value]) => value !== undefined));
    for (const name of ['kept', 'pins', ...names]) values.delete(name);
    return values;
  });
  return x.size === y.size && [...x].every(([name, value]) => y.get(name) === value);
}
