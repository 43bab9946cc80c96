// Unwraps three.js geometry.

import type { BufferGeometry } from 'three';
import type { WrittenFormat } from './base/generated.js';
import { meshOf, withUv } from './geometry.js';
import { neededFor } from './messages/needed-arrays.js';
import { checkAbflat, checkString, optionsOf } from './messages/validate.js';
import type { AnyAbflat, UnwrapOptions, UnwrapResult } from './types/index.js';

/**
 * The options of `unwrap`, without `transfer`, as a geometry keeps its buffers, and without the
 * file formats.
 */
export interface UnwrapGeometryOptions extends Omit<UnwrapOptions, 'transfer' | WrittenFormat> {
  /** Name of the attribute for the new coordinates. Default: `uv`; `uv1` leaves `uv` as it is, for light maps. */
  attribute?: string;
}

/**
 * A new geometry with the new coordinates. It has all attributes, morph targets and groups of
 * `geometry`, which may or may not have an index, and repeats a vertex for every coordinate that it
 * has. Tangents are copied like the rest and belong to the old coordinates.
 */
export async function unwrapGeometry(
  abflat: AnyAbflat<'unwrap'>,
  geometry: BufferGeometry,
  settings: UnwrapGeometryOptions = {},
): Promise<{ geometry: BufferGeometry; result: UnwrapResult }> {
  checkAbflat(abflat, 'unwrap');
  const { attribute = 'uv', ...options } = optionsOf(settings);
  checkString('attribute', attribute);
  const mesh = meshOf(geometry, 'uv', 'unwrapGeometry');
  const result = await abflat.unwrap(neededFor(options, mesh), options);
  return { geometry: withUv(geometry, result, attribute), result };
}
