import type { Bound } from './format';

/** A disk in one piece, or any mesh in charts. */
export type Mode = 'flatten' | 'unwrap';

/** What the user can ask of a layout. */
export interface FlattenSettings {
  mode: 'flatten';
  t: Bound;
  delaunay: boolean;
}

/** What the user can ask of an atlas. */
export interface UnwrapSettings {
  mode: 'unwrap';
  maxStretch: number;
  /** Texels along a side. */
  resolution: number;
  /** Texels between charts. */
  padding: number;
  /** As the command line takes it. */
  seams: string;
  /** Cut as well, two vertices each. */
  seamEdges?: Uint32Array;
}

export type Settings = FlattenSettings | UnwrapSettings;

export function sameSettings(a: Settings, b: Settings): boolean {
  if (a.mode === 'flatten') return b.mode === 'flatten' && a.t === b.t && a.delaunay === b.delaunay;
  return (
    b.mode === 'unwrap' &&
    a.maxStretch === b.maxStretch &&
    a.resolution === b.resolution &&
    a.padding === b.padding &&
    a.seams === b.seams &&
    a.seamEdges === b.seamEdges
  );
}
