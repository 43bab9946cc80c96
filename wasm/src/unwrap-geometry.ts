// Unwraps three.js geometry.

import type { BufferGeometry } from 'three';
import { AbflatError } from './base/errors.js';
import type { WrittenFormat } from './base/generated.js';
import { neededFor } from './messages/needed-arrays.js';
import { checkAbflat, checkString, optionsOf } from './messages/validate.js';
import { type PresetOptions, withPreset } from './preset.js';
import { meshOf, withUv } from './three/geometry.js';
import type { AnyAbflat, UnwrapOptions, UnwrapResult } from './types/index.js';

/**
 * The options of `unwrap`, without `transfer`, as a geometry keeps its buffers, and without the
 * file formats.
 */
export interface UnwrapGeometryOptions
  extends PresetOptions,
    Omit<UnwrapOptions, 'transfer' | WrittenFormat> {
  /**
   * Name of the attribute for the new coordinates; `uv1` is for light maps and leaves `uv` as it is.
   * Default: `uv`, `readAttribute` with `fixedFaces`, and `uv1` with a preset.
   */
  attribute?: string;
  /**
   * Name of the attribute that `seams: 'uv'` and `fixedFaces` refer to. Default: `uv`, and
   * `attribute` with `fixedFaces`.
   */
  readAttribute?: string;
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
  const own = optionsOf(settings);
  const isKept = own.fixedFaces !== undefined;
  const usual = own.preset === undefined ? 'uv' : 'uv1';
  const {
    attribute = (isKept ? own.readAttribute : undefined) ?? usual,
    readAttribute = isKept ? attribute : 'uv',
    ...others
  } = own;
  checkString('attribute', attribute);
  checkString('readAttribute', readAttribute);
  const options = withPreset(others);
  const mesh = meshOf(geometry, readAttribute, 'unwrapGeometry');
  if (own.fixedFaces === 'uv' && !mesh.texcoords)
    throw new AbflatError(
      'NoTexcoords',
      `The geometry has no attribute ${readAttribute}, so there is no layout to keep. Name the one that has it as readAttribute.`,
    );
  const result = await abflat.unwrap(neededFor(options, mesh), options);
  return { geometry: withUv(geometry, result, attribute), result };
}
