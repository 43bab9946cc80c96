// Names changes of settings, as the history shows them.

import { MORE } from '../model/more-names';
import { MORE_LABELS } from '../model/more-options';
import type { Settings, Tiles } from '../model/settings';
import type { Bound } from '../words/format';
import { CHANGES } from '../words/run';
import { PACKING } from '../words/selection';
import { layingOut } from './words';

export interface Change {
  /** "Max stretch 1.05" */
  text: string;
  /** Set if changes of this kind come in quick succession, as from a slider; they count as one. */
  stream?: string;
}

type Values = Record<string, unknown>;

/** The words for each setting that has changed; those that go with a slider or a field are streams. */
const NAMES: Record<string, (value: never) => Change> = {
  keepPlaces: (keeps: boolean) => ({ text: keeps ? CHANGES.fileUvs : CHANGES.packIslands }),
  margin: (texels: number | 'auto') => ({ text: CHANGES.margin(texels), stream: 'margin' }),
  tiles: (tiles: Tiles = 'one') => ({ text: CHANGES.tiles(PACKING.tiles[tiles]) }),
  islandSizes: (sizes: string) => ({ text: CHANGES.sizes(sizes) }),
  t: (t: Bound) => ({ text: CHANGES.t(t), stream: 't' }),
  balance: (balance: number) => ({ text: CHANGES.balance(balance), stream: 'balance' }),
  delaunay: (isOn: boolean) => ({ text: CHANGES.delaunay(isOn) }),
  bounds: (bounds: unknown[] | undefined) => ({
    text: bounds ? CHANGES.bounds(bounds.length) : CHANGES.noBounds,
  }),
  maxStretch: (most: number) => ({ text: CHANGES.maxStretch(most), stream: 'maxStretch' }),
  resolution: (texels: number) => ({ text: CHANGES.resolution(texels) }),
  padding: (texels: number) => ({ text: CHANGES.padding(texels), stream: 'padding' }),
  seams: (seams: string) => ({
    text: CHANGES.seams(seams),
    stream: seamStream(seams),
  }),
  seamEdges: (edges: Uint32Array | undefined) => ({
    text: edges ? CHANGES.seamEdges(edges.length / 2) : CHANGES.noSeamEdges,
  }),
  fixedFaces: (kept: string | undefined) => ({
    text: kept ? CHANGES.keepUvs : CHANGES.keepNoUvs,
  }),
};

/** What was changed from one to the other; the first difference in the order of the page. */
export function changeBetween(before: Settings, after: Settings): Change {
  if (before.mode !== after.mode) return { text: layingOut(after).verb };
  const [from, to]: Values[] = [{ ...before }, { ...after }];
  for (const [name, words] of Object.entries(NAMES))
    if (from[name] !== to[name]) return words(to[name] as never);
  for (const name of MORE) if (from[name] !== to[name]) return more(name, to[name]);
  return { text: CHANGES.packedAgain };
}

function more(name: (typeof MORE)[number], value: unknown): Change {
  const label = MORE_LABELS[name];
  if (typeof value === 'boolean') return { text: CHANGES.switched(label, value) };
  return { text: CHANGES.set(label, value), stream: typeof value === 'number' ? name : undefined };
}

/** An angle is typed digit by digit. */
const seamStream = (seams: string) => (seams.includes('sharp=') ? 'sharp' : undefined);
