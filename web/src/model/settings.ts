import type { UnwrapResult } from 'abflat';
import type { Bound } from '../base/format';
import type { MoreOptions } from './more-options';

/** Charts to keep where they are. */
export interface Kept {
  layout: UnwrapResult;
  charts: Uint32Array;
}

/** A disk in one piece, or any mesh in charts. */
export type Mode = 'flatten' | 'unwrap';

/** What the user can ask of a layout. */
export interface FlattenSettings {
  mode: 'flatten';
  t: Bound;
  balance: number;
  delaunay: boolean;
}

/** What the user can ask of an atlas. */
export interface UnwrapSettings extends MoreOptions {
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
  /** Charts kept where they already are, which is no reason to lay out again. */
  kept?: Kept;
}

export type Settings = FlattenSettings | UnwrapSettings;

export function sameSettings(a: Settings, b: Settings): boolean {
  const [x, y] = [a, b].map((settings) => {
    const values = new Map<string, unknown>(Object.entries(settings));
    values.delete('kept');
    return values;
  });
  return x.size === y.size && [...x].every(([name, value]) => y.get(name) === value);
}
