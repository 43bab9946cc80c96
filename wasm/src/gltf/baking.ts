// The option `bake` of transforms. What bakes is loaded when it is first used.

import type { Document } from '@gltf-transform/core';
import { AbflatError } from '../base/errors.js';
import { ownFields } from '../messages/fields.js';
import { checkFunction, knownOptions, tagOf } from '../messages/validate.js';
import type { AbortSignalLike, AnyAbflat, Progress } from '../types/index.js';
import type { BakeDocumentOptions, LaidAtlas, PutLook } from './bake/bake-document.js';

/** What bakes an atlas that is laid but not yet in the document, and then puts its look there. */
export interface Baking {
  prepare(
    document: Document,
    atlases: readonly LaidAtlas[],
    call: { signal?: AbortSignalLike; onProgress?: (fraction: number) => void },
  ): Promise<PutLook[]>;
}

const KEYS = ['bakeResolution', 'decode', 'encode'];

const invalid = (message: string) => new AbflatError('InvalidOption', message);

/** Undefined if `bake` is not wanted. */
export function bakingOf(
  abflat: Partial<AnyAbflat<'bake'>>,
  bake: unknown,
  udim: unknown,
): Baking | undefined {
  if (bake === undefined || bake === false) return undefined;
  if (bake !== true && tagOf(bake) !== 'Object')
    throw invalid(`bake must be true, false or an object with ${KEYS.join(', ')}.`);
  if (typeof abflat.bake !== 'function') throw invalid('bake needs an abflat that can bake.');
  if (udim === true) throw invalid('bake makes images of one tile, so it does not go with udim.');
  const options = knownOptions<BakeDocumentOptions>(
    bake === true ? ownFields({}) : (bake as BakeDocumentOptions),
    KEYS,
    'bake',
  );
  checkFunction('bake.decode', options.decode);
  checkFunction('bake.encode', options.encode);
  const able = abflat as AnyAbflat<'bake'>;
  return {
    prepare: async (document, atlases, call) => {
      const { bakeDocument } = await import('./bake/bake-document.js');
      return bakeDocument(able, document, atlases, ownFields({ ...options, ...call }));
    },
  };
}

/** Layouts are the larger part of the work. */
const LAYOUT_SHARE = 0.7;

type Listener<P> = ((progress: P) => void) | undefined;

/** Tells the progress of layouts that will be baked. */
export function firstPart<P extends { fraction: number }>(onProgress: Listener<P>): Listener<P> {
  return (
    onProgress &&
    ((progress) => onProgress({ ...progress, fraction: LAYOUT_SHARE * progress.fraction }))
  );
}

/** Tells the progress of baking as that of the last stage of layouts. */
export function lastPart(onProgress: Listener<Progress & { stage: 'write' }>): Listener<number> {
  return (
    onProgress &&
    ((share) =>
      onProgress({
        stage: 'write',
        newtonStep: 0,
        constraintResidual: 0,
        fraction: LAYOUT_SHARE + (1 - LAYOUT_SHARE) * share,
      }))
  );
}
