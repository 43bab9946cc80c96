// Generated from core/schema by scripts/generate.mjs, do not edit.

/** What the module has after a call; `field` is the number of the C++ enum. */
export const RESULT_ARRAYS = {
  /** 2 per output vertex. */
  uv: { field: 0, Kind: Float64Array },
  /** 3 output vertices per triangle. */
  indices: { field: 1, Kind: Uint32Array },
  /** Input vertex of each output vertex. */
  vertexMap: { field: 2, Kind: Uint32Array },
  /** 3 per output vertex, for file input only. */
  positions: { field: 3, Kind: Float64Array },
  /** OBJ text, if asked for. */
  obj: { field: 4, Kind: Uint8Array },
  /** PLY file, if asked for. */
  ply: { field: 5, Kind: Uint8Array },
  /** JSON of a result, or the message of an error. */
  text: { field: 6, Kind: Uint8Array },
  /** Chart of each triangle. */
  chartOfTriangle: { field: 7, Kind: Uint32Array },
  /** Edges that were cut, two input vertices each. */
  seams: { field: 8, Kind: Uint32Array },
  /** Uv before packing. */
  unpacked: { field: 9, Kind: Float64Array },
  /** Input face of each triangle of a loaded file. */
  faces: { field: 10, Kind: Uint32Array },
} as const;
