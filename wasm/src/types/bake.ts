// `bake`: the textures of a mesh in its new layout.

import type { BakeStage } from '../base/generated.js';
import type { BakeOptionValues } from '../base/generated-bake.js';
import type { AbortSignalLike, Layout, Progress } from './layout.js';
import type { MeshArrays } from './mesh.js';

/** Pixels of 8 bits in rows from the top: red, green, blue and alpha. An ImageData is one. */
export interface BakeImage {
  /** Colours are not multiplied by alpha. */
  data: Uint8ClampedArray | Uint8Array;
  width: number;
  height: number;
}

/** How a texture goes on beyond its edges. */
export type BakeWrap = 'repeat' | 'mirror' | 'clamp';

/** What the triangles of a material show in the old layout. */
export interface BakeSource {
  /** Without one the texture is white, or a flat normal map. */
  image?: BakeImage;
  /** Default: `repeat`. */
  wrapU?: BakeWrap;
  /** Default: `repeat`. */
  wrapV?: BakeWrap;
  /**
   * Texcoords, with v from the top, are scaled, then turned, then moved, as KHR_texture_transform
   * does. Default: [0, 0].
   */
  offset?: readonly [number, number];
  /** In radians, counter-clockwise seen on the image. Default: 0. */
  rotation?: number;
  /** Default: [1, 1]. */
  scale?: readonly [number, number];
  /**
   * What red, green, blue and alpha are multiplied by, as linear values; they end at 1. Of a normal
   * map, it is the vector: a normalScale of glTF is [s, s, 1, 1]. Default: [1, 1, 1, 1].
   */
  factor?: readonly [number, number, number, number];
  /** Alpha means nothing: the new image has 1 in its place. Default: false. */
  opaque?: boolean;
}

/**
 * The mesh that the layout was made of, with the texcoords that its images are for. Positions,
 * normals, tangents and parts count for normal maps alone.
 */
export interface BakeMesh
  extends Pick<MeshArrays, 'positions' | 'indices' | 'normals' | 'materials'> {
  /** The old ones, 2 per vertex, with v from the bottom. */
  texcoords: NonNullable<MeshArrays['texcoords']>;
  /**
   * Red, green, blue and alpha per vertex, as linear values from 0 to 1, which what images show is
   * multiplied by. They do not count for normal maps. Default: 1.
   */
  colours?: MeshArrays['positions'];
  /**
   * Those that the old normal map is for, 4 per vertex as in glTF: a unit vector and the sign of the
   * bitangent. 0 in parts without any, which have those of MikkTSpace, as all have by default.
   */
  tangents?: MeshArrays['positions'];
  /**
   * A number per triangle. Tangents are computed for each run of equal numbers, such as a primitive
   * of a glTF, by itself. Default: all triangles are one part.
   */
  parts?: MeshArrays['indices'];
}

/** The new layout of the same triangles: a result of `unwrap` or `pack`, or your own. */
export interface BakeLayout extends Pick<Layout<unknown>, 'uv'> {
  /** Default: those of the mesh. */
  indices?: Uint32Array;
  /** Default: vertices of the layout are those of the mesh. */
  vertexMap?: Uint32Array;
}

export interface BakeProgress extends Omit<Progress, 'stage'> {
  stage: BakeStage;
}

/** The README lists the plain values and their defaults. */
export interface BakeOptions extends Partial<BakeOptionValues> {
  /** Called as rows of the image are done; the numbers of Newton's method are 0. */
  onProgress?: (progress: BakeProgress) => void;
  /** An AbortSignal. Aborting rejects the call with the signal's reason; the next call works. */
  signal?: AbortSignalLike;
}

/** A square image in the new layout, as BakeImage. */
export interface BakedImage {
  data: Uint8ClampedArray;
  width: number;
  height: number;
}
