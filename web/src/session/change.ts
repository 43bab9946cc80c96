// Names changes of settings, as the history shows them.

import { bound, counted } from '../base/format';
import { MORE, MORE_LABELS } from '../model/more-options';
import type { Settings } from '../model/settings';

export interface Change {
  /** "Max stretch 1.05" */
  text: string;
  /** Set if changes of this kind come in quick succession, as from a slider; they count as one. */
  stream?: string;
}

type Values = Record<string, unknown>;

/** The words for each setting that has changed; those that go with a slider or a field are streams. */
const NAMES: Record<string, (value: never) => Change> = {
  t: (t: number | 'auto') => ({ text: `Boundary t ${bound(t)}`, stream: 't' }),
  balance: (balance: number) => ({ text: `Balance ${balance}`, stream: 'balance' }),
  delaunay: (isOn: boolean) => ({ text: isOn ? 'Delaunay' : 'Delaunay off' }),
  bounds: (bounds: unknown[] | undefined) => ({
    text: bounds ? `Bounds of ${counted(bounds.length, 'vertex', 'vertices')}` : 'No own bounds',
  }),
  maxStretch: (most: number) => ({ text: `Max stretch ${most}`, stream: 'maxStretch' }),
  resolution: (texels: number) => ({ text: `Resolution ${texels}\u202fpx` }),
  padding: (texels: number) => ({ text: `Padding ${texels}`, stream: 'padding' }),
  seams: (seams: string) => ({
    text: `Seams: ${seams.replaceAll(',', ', ')}`,
    stream: seamStream(seams),
  }),
  seamEdges: (edges: Uint32Array | undefined) => ({
    text: edges ? `Seams of ${counted(edges.length / 2, 'edge')}` : 'Seams as chosen',
  }),
  fixedFaces: (kept: string | undefined) => ({
    text: kept ? 'UVs of the file kept' : 'UVs of the file not kept',
  }),
};

/** What was changed from one to the other; the first difference in the order of the page. */
export function changeBetween(before: Settings, after: Settings): Change {
  if (before.mode !== after.mode) return { text: after.mode === 'flatten' ? 'Flatten' : 'Unwrap' };
  const [from, to]: Values[] = [{ ...before }, { ...after }];
  for (const [name, words] of Object.entries(NAMES))
    if (from[name] !== to[name]) return words(to[name] as never);
  for (const name of MORE) if (from[name] !== to[name]) return more(name, to[name]);
  return { text: 'Packed again' };
}

function more(name: (typeof MORE)[number], value: unknown): Change {
  const label = MORE_LABELS[name];
  if (typeof value === 'boolean') return { text: value ? label : `${label} off` };
  return { text: `${label} ${value}`, stream: typeof value === 'number' ? name : undefined };
}

/** An angle is typed digit by digit. */
const seamStream = (seams: string) => (seams.includes('sharp=') ? 'sharp' : undefined);
