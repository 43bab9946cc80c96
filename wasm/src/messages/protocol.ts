// What client and worker say to each other. One call at a time: the worker answers it before the client sends the next.

import type { Build } from '../base/builds.js';
import type { StatusName, WrittenFormat } from '../base/generated.js';
import type {
  BakedImage,
  BakeProgress,
  CompareProgress,
  Comparison,
  FlattenResult,
  MeshSummary,
  PackProgress,
  PackResult,
  PinWeights,
  Progress,
  TriangleMesh,
  UnwrapProgress,
  UnwrapResult,
  VerifyProgress,
  VerifyResult,
} from '../types/index.js';

export interface OwnedFile {
  bytes: Uint8Array;
  name: string;
}

type Reals = Float32Array | Float64Array;
type Whole = Uint8Array | Uint16Array | Uint32Array;

export interface OwnedArrays {
  positions: Float32Array | Float64Array;
  indices: Whole;
  texcoords?: Float32Array | Float64Array;
  normals?: Float32Array | Float64Array;
  cornerNormals?: Float32Array | Float64Array;
  materials?: Whole;
  vertexObjects?: Whole;
}

/** A mesh in buffers that belong to the call. */
export type OwnedMesh = OwnedArrays | OwnedFile;

/** Vertex, u, v and face, which is 2^32 - 1 if none is given. */
export type PinNumbers = [vertex: number, u: number, v: number, face: number];

/** What the calls that return a layout share. */
export interface LayoutRequest {
  mesh: OwnedMesh;
  files: WrittenFormat[];
  wantsProgress: boolean;
  roundsForGltf: boolean;
}

export interface FlattenRequest extends LayoutRequest {
  kind: 'flatten';
  /** One number per option of FLATTEN_OPTIONS, in its order. */
  values: number[];
  pins: PinNumbers[];
  /** Vertex and t of each bound in turn. */
  bounds: number[];
  straight: [from: number, to: number][];
  normalizes: boolean;
}

/** The `known` result of an earlier call, in arrays that belong to this one. */
export interface KnownArrays {
  /** Encoded as in `values` of a request. */
  t: number;
  balance: number;
  straightSeams: boolean;
  /** `uv` only if charts stay where they are. */
  arrays: Pick<UnwrapResult, 'unpacked' | 'indices' | 'vertexMap' | 'chartOfTriangle'> &
    Partial<Pick<UnwrapResult, 'uv'>>;
}

export interface UnwrapRequest extends LayoutRequest {
  kind: 'unwrap';
  /** One number per option of UNWRAP_OPTIONS, in its order. */
  values: number[];
  pins: PinNumbers[];
  /** Where to cut, as text; without it the module uses its default. */
  seams?: string;
  /** One place per array of UNWRAP_ARRAYS, in its order. */
  arrays: (Uint32Array | Float64Array | undefined)[];
  keepsUv: boolean;
  keepsValidOnly: boolean;
  keepsPlaces: boolean;
  known?: KnownArrays;
}

export interface PackRequest extends LayoutRequest {
  kind: 'pack';
  /** One number per option of PACK_OPTIONS, in its order. */
  values: number[];
  arrays: OwnPackArrays;
}

export interface VerifyRequest {
  kind: 'verify';
  mesh: OwnedMesh;
  /** In place of the texcoords of the mesh. */
  uv: Float64Array | undefined;
  /** One number per option of VERIFY_OPTIONS, in its order. */
  values: number[];
  wantsProgress: boolean;
}

/** PackArrays that belong to the call. */
export interface OwnPackArrays {
  uv: Float64Array | undefined;
  islands: Uint32Array | undefined;
  tileOfIsland: Uint32Array | undefined;
}

/** The mesh of a bake, as BakeMesh, in arrays that belong to the call. */
export interface BakeArrays {
  positions: Reals;
  texcoords: Reals;
  normals?: Reals;
  colours?: Reals;
  tangents?: Reals;
  indices: Whole;
  materials?: Whole;
  parts?: Whole;
}

/** A use of an image: its place among the images, and wraps in the order of BakeWrap. */
export interface BakeTexture {
  image: number;
  width: number;
  height: number;
  wrapU: number;
  wrapV: number;
  hasOpacity: boolean;
}

/** A BakeSource in numbers; `texture` is the place of the texture, if there is one. */
export interface SourceNumbers {
  texture?: number;
  offset: [number, number];
  rotation: number;
  scale: [number, number];
  factor: [number, number, number, number];
}

export interface BakeRequest {
  kind: 'bake';
  mesh: BakeArrays;
  layout: { uv: Reals; indices: Whole; vertexMap?: Whole };
  images: (Uint8Array | Uint8ClampedArray)[];
  textures: BakeTexture[];
  sources: SourceNumbers[];
  /** No source is transparent. */
  isOpaque: boolean;
  /** One number per option of BAKE_OPTIONS, in its order. */
  values: number[];
  wantsProgress: boolean;
}

export type Request =
  | { kind: 'describe' }
  | FlattenRequest
  | UnwrapRequest
  | PackRequest
  | VerifyRequest
  | BakeRequest
  | { kind: 'compare'; mesh: OwnedMesh; wantsProgress: boolean }
  | { kind: 'inspect'; mesh: OwnedMesh }
  | { kind: 'pinWeights'; mesh: OwnedArrays; pins: number[] }
  | { kind: 'load'; mesh: OwnedFile }
  | { kind: 'sample'; name: string; detail: number };

/** Names that the module knows, to compare with those that this package knows. */
export interface Description {
  build: Build;
  statuses: string[];
  samples: string[];
}

export type Answer =
  | Description
  | FlattenResult
  | UnwrapResult
  | PackResult
  | VerifyResult
  | BakedImage
  | Comparison
  | MeshSummary
  | TriangleMesh
  | PinWeights;

export type AnyProgress =
  | Progress
  | UnwrapProgress
  | PackProgress
  | VerifyProgress
  | BakeProgress
  | CompareProgress;

/** `stopped`: shared memory with the number of the call to cancel. */
export type ToWorker =
  | { type: 'start'; module: WebAssembly.Module; maxMemory: number; stopped?: Int32Array }
  | { type: 'call'; request: Request; number: number };

/** `isSpent`: the worker cannot or should not take another call. */
export type FromWorker =
  | { type: 'progress'; progress: AnyProgress }
  | { type: 'done'; answer: Answer; isSpent: boolean }
  | { type: 'failed'; code: StatusName; message: string; isSpent: boolean };
