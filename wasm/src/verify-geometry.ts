// Verifies the layout of three.js geometry.

import type { BufferGeometry } from 'three';
import { AbflatError } from './base/errors.js';
import { checkAbflat, checkString, optionsOf } from './messages/validate.js';
import { meshOf } from './three/geometry.js';
import type { AnyAbflat, VerifyOptions, VerifyResult } from './types/index.js';

/** The options of `verify`, without `transfer`, as a geometry keeps its buffers. */
export interface VerifyGeometryOptions extends Omit<VerifyOptions, 'transfer'> {
  /** Name of the attribute with the layout. Default: `uv`. */
  attribute?: string;
}

/** Judges the layout that a geometry has. Faces are its triangles, in their order. */
export async function verifyGeometry(
  abflat: AnyAbflat<'verify'>,
  geometry: BufferGeometry,
  settings: VerifyGeometryOptions = {},
): Promise<VerifyResult> {
  checkAbflat(abflat, 'verify');
  const { attribute = 'uv', ...options } = optionsOf(settings);
  checkString('attribute', attribute);
  const { positions, indices, texcoords } = meshOf(geometry, attribute, 'verifyGeometry');
  if (!texcoords)
    throw new AbflatError(
      'NoTexcoords',
      `The geometry has no attribute ${attribute}, so there is no layout to verify. Make one with unwrapGeometry.`,
    );
  return abflat.verify({ positions, indices, texcoords }, options);
}
