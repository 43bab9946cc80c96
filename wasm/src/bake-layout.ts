// Bakes textures into a layout that is there already.

import { UNWRAP_DEFAULTS, type UnwrapOptionValues } from './base/generated.js';
import type { BakeDocumentOptions } from './gltf/bake/bake-document.js';
import type { BakedTexture } from './gltf/bake/put-look.js';
import { type Baking, bakingOf } from './gltf/baking.js';
import type { DocumentMesh } from './gltf/document-mesh.js';
import { checkSets } from './gltf/groups.js';
import { checkTriangles, setTexcoords } from './gltf/texcoords.js';
import { freeBakedTexcoord } from './gltf/texture-sets.js';
import { checkAbflat, checkFunction, checkSignal, knownOptions } from './messages/validate.js';
import type { AbortSignalLike, AnyAbflat, Layout } from './types/index.js';

export interface BakeLayoutOptions extends BakeDocumentOptions {
  /**
   * The coordinates become TEXCOORD_`texcoord`. Default: `auto`, 0 if no texture that stays samples
   * that set, otherwise the first unused set.
   */
  texcoord?: number | 'auto';
  /** Triangles that the layout has turned, as for `setTexcoords`. Default: none. */
  turnedFaces?: readonly number[];
  /** Between the charts, in texels of an image of the size `resolution`. Default: as `unwrap` has it. */
  padding?: number;
  resolution?: UnwrapOptionValues['resolution'];
  /** Called with the share that is done. */
  onProgress?: (fraction: number) => void;
  /** As for `unwrap`. */
  signal?: AbortSignalLike;
}

export interface BakedLayout {
  /** The set that holds the coordinates. */
  texcoord: number;
  baked: BakedTexture[];
  /** What to know about the new look, one sentence each. */
  notes: string[];
}

const KEYS = [
  ...['texcoord', 'turnedFaces', 'padding', 'resolution', 'onProgress', 'signal'],
  ...['bakeResolution', 'decode', 'encode'],
];

/**
 * Gives a document a layout that you have, as `setTexcoords` does, and its textures follow. If it
 * fails, the document stays as it was.
 */
export async function bakeLayout(
  abflat: AnyAbflat<'bake'>,
  { document, parts }: Pick<DocumentMesh, 'document' | 'parts'>,
  { uv, indices }: Pick<Layout<unknown>, 'uv' | 'indices'>,
  options: BakeLayoutOptions = {},
): Promise<BakedLayout> {
  const {
    texcoord = 'auto',
    turnedFaces = [],
    padding = UNWRAP_DEFAULTS.padding,
    resolution = UNWRAP_DEFAULTS.resolution,
    onProgress,
    signal,
    ...bake
  } = knownOptions(options, KEYS);
  checkAbflat(abflat, 'bake');
  checkSets(texcoord, 0);
  for (const [name, each] of Object.entries({
    decode: bake.decode,
    encode: bake.encode,
    onProgress,
  }))
    checkFunction(name, each);
  checkSignal(signal);
  checkTriangles(parts, indices);
  const baking = bakingOf(abflat, bake, false) as Baking;
  const report = { notes: [] as string[] };
  const atlas = { parts, result: { uv, indices, report }, turnedFaces, padding, resolution };
  const [put] = await baking.prepare(document, [atlas], { signal, onProgress });
  const set = texcoord === 'auto' ? freeBakedTexcoord(document) : texcoord;
  setTexcoords({ document, parts }, { uv, indices }, { texcoord: set, turnedFaces });
  return { texcoord: set, baked: put?.(set) ?? [], notes: report.notes };
}
