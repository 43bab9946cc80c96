// Bakes textures into a layout that a document already has in one of its sets.

import type { Document, Transform } from '@gltf-transform/core';
import { AbflatError } from './base/errors.js';
import { BAKE_DEFAULTS } from './base/generated-bake.js';
import type { BakeDocumentOptions } from './gltf/bake/bake-document.js';
import type { BakedTexture } from './gltf/bake/put-look.js';
import { type Baking, bakingOf } from './gltf/baking.js';
import { documentMesh, membersOf } from './gltf/document-mesh.js';
import {
  checkAbflat,
  checkFunction,
  checkSignal,
  knownOptions,
  shown,
} from './messages/validate.js';
import type { AbortSignalLike, AnyAbflat } from './types/index.js';

export interface BakeSetOptions extends BakeDocumentOptions {
  /** The new layout is TEXCOORD_`texcoord`. Primitives without it stay as they are. Default: 1. */
  texcoord?: number;
  /** Texels around charts that take the colour of the nearest texel within. Default: 2. */
  padding?: number;
  /** Called with the share that is done. */
  onProgress?: (fraction: number) => void;
  /** As for `unwrap`. */
  signal?: AbortSignalLike;
  /** Called with the new images, and with what to know about them, one sentence each. */
  onBaked?: (baked: BakedTexture[], notes: string[]) => void;
}

const KEYS = [
  ...['texcoord', 'padding', 'onProgress', 'signal', 'onBaked'],
  ...['bakeResolution', 'decode', 'encode'],
];

/**
 * A transform that has the textures of a document follow another of its layouts: `await
 * document.transform(bake(abflat, { texcoord: 1 }))`. If it fails, the document stays as it was.
 */
export function bake(abflat: AnyAbflat<'bake'>, options: BakeSetOptions = {}): Transform {
  const {
    texcoord = 1,
    padding = BAKE_DEFAULTS.padding,
    onProgress,
    signal,
    onBaked,
    ...images
  } = knownOptions(options, KEYS);
  checkAbflat(abflat, 'bake');
  if (!Number.isInteger(texcoord) || texcoord < 0)
    throw new AbflatError(
      'InvalidOption',
      `texcoord must be a whole number from 0, not ${shown(texcoord)}.`,
    );
  for (const [name, each] of Object.entries({ onProgress, onBaked })) checkFunction(name, each);
  checkSignal(signal);
  const baking = bakingOf(abflat, images, false) as Baking;
  const transform = async (document: Document): Promise<void> => {
    const members = membersOf(document).filter(({ primitive }) =>
      primitive.getAttribute(`TEXCOORD_${texcoord}`),
    );
    const { parts, indices, texcoords: uv } = documentMesh(document, members, texcoord);
    if (!uv || indices.length === 0)
      throw new AbflatError(
        'NoTexcoords',
        `No triangle has TEXCOORD_${texcoord}. Name the set of the new layout with texcoord, or use unwrap with bake.`,
      );
    const report = { notes: [] as string[] };
    const atlas = { parts, result: { uv, indices, report }, padding, resolution: undefined };
    const [put] = await baking.prepare(document, [atlas], { signal, onProgress });
    const baked = put?.(texcoord) ?? [];
    onBaked?.(baked, report.notes);
  };
  return Object.defineProperty(transform, 'name', { value: 'bake' });
}
