// What the parts of the page tell each other of.

import type {
  FlattenResult,
  MeshInput,
  MeshSummary,
  Progress,
  UnwrapProgress,
  UnwrapResult,
} from 'abflat';
import type { ArrayMesh, DisplayMesh } from '../mesh/mesh';
import type { Drawing, FlatDrawing } from './drawing';
import type { FlattenSettings, UnwrapSettings } from './settings';

/** Where a mesh comes from. `name` is for people and for the names of exported files. */
export type Source = { kind: 'sample'; name: string } | FileSource;

export interface FileSource {
  kind: 'file';
  name: string;
  file: File;
  /** What came with it: a glTF may be of several files. */
  others: File[];
  /** All meshes that were chosen at once, this one included. */
  together: FileSource[];
}

export const isGltf = ({ name }: Source) => /\.(glb|gltf)$/i.test(name);

/** What can be written, in the order in which it is offered. */
export const EXPORT_FORMATS = ['obj', 'ply', 'glb'] as const;

export type ExportFormat = (typeof EXPORT_FORMATS)[number];

/** A file goes back in the format it came in where that holds texcoords. */
export function exportFormat(source: Source): ExportFormat {
  if (isGltf(source)) return 'glb';
  return /\.ply$/i.test(source.name) ? 'ply' : 'obj';
}

/** A document as it was when it was read: copies that the browser keeps where the page need not hold them. */
export interface GltfFiles {
  file: File;
  /** Those that it refers to. */
  others: File[];
}

export interface GltfFile {
  mesh: ArrayMesh;
  /** The first set of coordinates that no texture needs as it is: 0 where no texture uses that. */
  freeTexcoord: number;
  files: GltfFiles;
  /** By what its triangles were compressed, for people. */
  compressions: string[];
}

export interface Opened {
  source: Source;
  input: MeshInput;
  mesh: DisplayMesh;
  summary: MeshSummary;
  /** What the views show of it. */
  drawing: Drawing;
  /** Of a glTF, which abflat knows as arrays. */
  gltf?: GltfFile;
}

interface Made {
  source: Source;
  /** What went in. */
  mesh: DisplayMesh;
  /** Where it came from one. */
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
}

export type Outcome = Flattened | Unwrapped;

export type AnyProgress = Progress | UnwrapProgress;

/** What else the session needs to be done with meshes, away from the page. */
export interface Helpers {
  mesh(mesh: DisplayMesh): Promise<Drawing>;
  outcome(outcome: Outcome): Promise<FlatDrawing>;
  gltf(source: FileSource, signal: AbortSignal): Promise<GltfFile>;
  joined(mesh: ArrayMesh): Promise<ArrayMesh>;
}

/** The arrays of a result, as abflat gives them. */
export interface LayoutArrays {
  uv: Float64Array;
  indices: Uint32Array;
  vertexMap: Uint32Array;
  positions?: Float64Array;
}
