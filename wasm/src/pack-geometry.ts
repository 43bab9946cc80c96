// Packs the layout of three.js geometry.

import type { BufferGeometry } from 'three';
import { AbflatError } from './base/errors.js';
import type { WrittenFormat } from './base/generated.js';
import { checkAbflat, checkString, optionsOf } from './messages/validate.js';
import { meshOf, withUv } from './three/geometry.js';
import type { AnyAbflat, PackOptions, PackResult } from './types/index.js';

/**
 * The options of `pack`, without `transfer`, as a geometry keeps its buffers, and without the file
 * formats.
 */
export interface PackGeometryOptions extends Omit<PackOptions, 'transfer' | WrittenFormat> {
  /** Name of the attribute with the layout. Default: `uv`. */
  readAttribute?: string;
  /** Name of the attribute for the new coordinates. Default: `readAttribute`. */
  attribute?: string;
}

/**
 * A new geometry with the new coordinates. It has all attributes, morph targets and groups of
 * `geometry`, and its vertices in their order; where islands that have moved apart shared a vertex,
 * a copy follows. Tangents are copied like the rest and belong to the old coordinates.
 */
export async function packGeometry(
  abflat: AnyAbflat<'pack'>,
  geometry: BufferGeometry,
  settings: PackGeometryOptions = {},
): Promise<{ geometry: BufferGeometry; result: PackResult }> {
  checkAbflat(abflat, 'pack');
  const { readAttribute = 'uv', attribute = readAttribute, ...options } = optionsOf(settings);
  checkString('readAttribute', readAttribute);
  checkString('attribute', attribute);
  const { positions, indices, texcoords } = meshOf(geometry, readAttribute, 'packGeometry');
  if (!texcoords)
    throw new AbflatError(
      'NoTexcoords',
      `The geometry has no attribute ${readAttribute}, so there is no layout to pack. Make one with unwrapGeometry.`,
    );
  const result = await abflat.pack({ positions, indices, texcoords }, options);
  return { geometry: withUv(geometry, result, attribute), result };
}
