// Generated from core/schema by scripts/generate.mjs, do not edit.

/** The formats that can be written, in the order in which they are offered. */
export const EXPORT_FORMATS = ['obj', 'ply', 'glb'] as const;

export type ExportFormat = (typeof EXPORT_FORMATS)[number];

/** A kind of file that holds a mesh. */
export interface MeshFile {
  readonly ending: string;
  readonly title: string;
  /** For browsers and systems. */
  readonly type: string;
  readonly format: 'obj' | 'ply' | 'stl' | 'off' | 'gltf';
  /** How a mesh of this format is exported in its own; null if it cannot be. */
  readonly exported: ExportFormat | null;
  /** How a text of the format begins. */
  readonly pasted: RegExp | null;
}

export const MESH_FILES: readonly MeshFile[] = [
  { ending: '.obj', title: 'OBJ', type: 'model/obj', format: 'obj', exported: 'obj', pasted: null },
  { ending: '.ply', title: 'PLY', type: 'model/x-ply', format: 'ply', exported: 'ply', pasted: /^ply\s/ },
  { ending: '.stl', title: 'STL', type: 'model/stl', format: 'stl', exported: null, pasted: /^solid\b[^\n]*\n\s*facet\s/ },
  { ending: '.off', title: 'OFF', type: 'model/x-off', format: 'off', exported: null, pasted: /^(?:ST)?C?N?4?n?OFF\s/ },
  { ending: '.glb', title: 'GLB', type: 'model/gltf-binary', format: 'gltf', exported: 'glb', pasted: null },
  { ending: '.gltf', title: 'glTF', type: 'model/gltf+json', format: 'gltf', exported: 'glb', pasted: /^\{[\s\S]*"asset"\s*:/ },
];

/** What formats and their files are called. */
export const MESH_NAMES = ['OBJ', 'PLY', 'STL', 'OFF', 'glTF', 'GLB'];
