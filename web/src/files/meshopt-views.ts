// What a document says about buffers that meshopt has compressed.

import type { JSONDocument } from '@gltf-transform/core';
import { GLTF } from '../words/gltf';

export const OLDER = 'EXT_meshopt_compression';
export const NEWER = 'KHR_meshopt_compression';

interface Extended {
  extensions?: Record<string, unknown>;
}

interface CompressedView {
  count: number;
  byteStride: number;
  mode: string;
}

/**
 * The extension has the same properties under both names, but glTF-Transform only knows the older
 * one.
 */
export function withOlderName({ json, resources }: JSONDocument): JSONDocument {
  const names = (list?: string[]) => list?.map((name) => (name === NEWER ? OLDER : name));
  return {
    json: {
      ...json,
      extensionsUsed: names(json.extensionsUsed),
      extensionsRequired: names(json.extensionsRequired),
      bufferViews: json.bufferViews?.map(renamed),
      buffers: json.buffers?.map(renamed),
    },
    resources,
  };
}

function renamed<T extends Extended>(item: T): T {
  if (!item.extensions?.[NEWER]) return item;
  const { [NEWER]: own, ...others } = item.extensions;
  return { ...item, extensions: { ...others, [OLDER]: own } };
}

/**
 * The decoder relies on the extension's rules: with other strides it would read at random, or
 * forever.
 */
export function checkMeshopt({ json }: JSONDocument): void {
  (json.bufferViews as Extended[] | undefined)?.forEach(({ extensions }, i) => {
    const view = extensions?.[OLDER] as CompressedView | undefined;
    if (view && !isDecodable(view)) throw new Error(GLTF.senselessView(i));
  });
}

function isDecodable({ count, byteStride, mode }: CompressedView): boolean {
  if (!Number.isInteger(count) || count < 0) return false;
  if (mode === 'ATTRIBUTES') return byteStride > 0 && byteStride <= 256 && byteStride % 4 === 0;
  const isIndex = byteStride === 2 || byteStride === 4;
  return isIndex && (mode === 'INDICES' || (mode === 'TRIANGLES' && count % 3 === 0));
}
