// What the parts of the page exchange.

import type {
  FlattenResult,
  MeshInput,
  MeshSummary,
  PackProgress,
  PackResult,
  Progress,
  UnwrapProgress,
  UnwrapResult,
} from 'abflat';
import { meshFileOf } from '../base/mesh-files';
import type { ArrayMesh, DisplayMesh } from '../mesh/mesh';
import type { Drawing, FlatDrawing } from './drawing';
import type { NamedParts } from './named-parts';
import type { FlattenSettings, PackSettings, UnwrapSettings } from './settings';
import type { FileStacks, Stack, Stacks } from './stacks';

/** Where a mesh comes from. `name` is for people and for the names of exported files. */
export type Source = { kind: 'sample'; name: string } | FileSource;

export interface FileSource {
  kind: 'file';
  name: string;
  file: File;
  /** Files that came with it: a glTF may consist of several. */
  others: File[];
  /** All meshes that were chosen at once, including this one. */
  together: FileSource[];
  /** The texcoord set of a glTF that is read; 0 if not given. */
  texcoord?: number;
}

/** Whether both are one file, perhaps read with different texcoord sets. */
export const isSameFile = (a: Source, b: Source) =>
  a.kind === 'file' && b.kind === 'file' && a.file === b.file;

export const isGltf = ({ name }: Source) => meshFileOf(name)?.format === 'gltf';

/**
 * A document as it was when it was read. These are copies that the browser stores, so the page need
 * not hold them.
 */
export interface GltfFiles {
  file: File;
  /** The files that it refers to. */
  others: File[];
}

/** A document to read, and the texcoord set that is wanted of it. */
export interface ChosenGltf extends GltfFiles {
  texcoord: number;
}

/** What a glTF has besides its shape and its texcoords. */
export type GltfContent = 'materials' | 'skins' | 'morphTargets' | 'animations' | 'names';

/** What an FBX may have that becomes no part of a glTF. */
export type FbxContent =
  | 'polygons'
  | 'maps'
  | 'skins'
  | 'morphAnimations'
  | 'cameras'
  | 'lights'
  | 'curves';

export interface GltfFile {
  mesh: ArrayMesh;
  /** The first texcoord set that no texture depends on: 0 if no texture uses that set. */
  freeTexcoord: number;
  /** The texcoord sets that it has, in ascending order. */
  texcoordSets: number[];
  /** The sets that textures use. */
  paintedSets: number[];
  /** Whether its materials have textures, or its vertices colours, that can be baked. */
  isPainted: boolean;
  /** Objects and materials. */
  parts: NamedParts;
  /** What it has that other formats would lose. */
  holds: GltfContent[];
  /** What was left out when it was read; only of an FBX. */
  lost: FbxContent[];
  files: GltfFiles;
  /** What to know about how it was read, one sentence each. */
  notes: string[];
  /** How its triangles were compressed, for display. */
  compressions: string[];
  /** What to say when it is opened, as sentences. */
  remarks: string[];
}

export interface Opened {
  source: Source;
  input: MeshInput;
  mesh: DisplayMesh;
  summary: MeshSummary;
  /** What the views show of it. */
  drawing: Drawing;
  /** Set for a glTF, which abflat gets as arrays. */
  gltf?: GltfFile;
}

/** Whether the file has UVs. Vertices of a glTF that were joined have lost them. */
export const hasUvs = ({ summary, gltf }: Pick<Opened, 'summary' | 'gltf'>): boolean =>
  summary.texcoords > 0 || gltf?.mesh.texcoords !== undefined;

interface Made {
  source: Source;
  /** The input. */
  mesh: DisplayMesh;
  /** Set if it came from a glTF. */
  gltf?: GltfFile;
}

export interface Flattened extends Made {
  mode: 'flatten';
  settings: FlattenSettings;
  result: FlattenResult;
}

export interface Unwrapped extends Made {
  mode: 'unwrap';
  settings: UnwrapSettings;
  result: UnwrapResult;
  /** Charts were to stay in place, but left too little room for the others. */
  isRepacked?: boolean;
  /** Charts that share texels; none is a fault. */
  stacks?: Stack[];
  /** How many charts were stacked before, and are not in a stack now. */
  unstacked?: number;
}

/** The UVs of the file, as they are or packed. */
export interface Packed extends Made {
  mode: 'pack';
  settings: PackSettings;
  result: PackResult;
  /** Undefined if nothing overlaps, or the islands are packed. */
  fileStacks?: FileStacks;
}

export type Outcome = Flattened | Unwrapped | Packed;

export type AnyProgress = Progress | UnwrapProgress | PackProgress;

/** Other work on meshes that the session needs, done off the main thread. */
export interface Helpers {
  mesh(mesh: DisplayMesh): Promise<Drawing>;
  outcome(outcome: Outcome): Promise<FlatDrawing>;
  gltf(source: FileSource, signal: AbortSignal): Promise<GltfFile>;
  joined(mesh: ArrayMesh): Promise<ArrayMesh>;
  /** Objects and materials. */
  namedParts(opened: Pick<Opened, 'source' | 'gltf' | 'mesh'>): Promise<NamedParts>;
  /** Islands of a file that share texels on purpose. */
  fileStacks(packed: Packed): Promise<FileStacks>;
  /** Charts of an atlas that share texels. */
  stacks(atlas: AtlasLayout): Promise<Stacks>;
  /** See arrange/stacks.ts. */
  apart(atlas: AtlasLayout, stacks: Stack[], rows: number): Promise<Float64Array | null>;
  restacked(before: AtlasLayout, now: AtlasLayout, stacks: Stack[]): Promise<Float64Array | null>;
}

/** The charts of an atlas and their places. */
export type AtlasLayout = Pick<UnwrapResult, 'uv' | 'indices' | 'chartOfTriangle'>;

/** The arrays of a result, as abflat returns them. */
export interface LayoutArrays {
  uv: Float64Array;
  indices: Uint32Array;
  vertexMap: Uint32Array;
  positions?: Float64Array;
}
