// Layouts whose charts can be selected and changed by hand: atlases, and the UVs of a file.

import type { UnwrapReport } from 'abflat';
import type { LayoutArrays, Packed, Unwrapped } from './model';

/** What is known of each chart. */
export type ChartFacts = Pick<
  UnwrapReport['charts'][number],
  'faces' | 'firstFace' | 'area' | 'symmetricDirichlet' | 'valid' | 'stackedOn' | 'mirrored'
>;

/** `lies`: on nothing else, a little on others or itself, or with most of its area. */
export interface IslandFacts extends ChartFacts {
  lies: 'apart' | 'overlapping' | 'stacked';
}

/** What selecting and moving charts needs of a report. */
export interface ChartList {
  charts: readonly ChartFacts[];
  atlas: { resolution: number };
}

/** The islands of a file as charts: no vertex belongs to more than one. */
export interface FileArrays extends LayoutArrays {
  unpacked: Float64Array;
  chartOfTriangle: Uint32Array;
}

/** The UVs of a file, as they are or packed, with islands where they are now. */
export interface FileLayout extends Pick<Packed, 'mode' | 'source' | 'mesh' | 'gltf'> {
  /** As abflat has judged it last. */
  packed: Packed;
  result: FileArrays & { report: Pick<ChartList, 'atlas'> & { charts: IslandFacts[] } };
  /** What was asked for since. */
  given?: Float64Array;
  settings: { faceDensities?: undefined; tiles?: undefined };
  stacks?: undefined;
}

export type Arrangeable = Unwrapped | FileLayout;

/** 2 per corner of each triangle, as abflat takes them in place of the UVs of a mesh. */
export function cornerUv({ uv, indices }: Pick<LayoutArrays, 'uv' | 'indices'>): Float64Array {
  const out = new Float64Array(2 * indices.length);
  indices.forEach((v, c) => {
    out[2 * c] = uv[2 * v];
    out[2 * c + 1] = uv[2 * v + 1];
  });
  return out;
}
