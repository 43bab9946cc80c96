// Generated from core/schema by scripts/generate.mjs, do not edit.

/** What the module has after a call; `field` is the number of the C++ enum. */
export const RESULT_ARRAYS = {
  uv: { field: 0, Kind: Float64Array },
  indices: { field: 1, Kind: Uint32Array },
  vertexMap: { field: 2, Kind: Uint32Array },
  positions: { field: 3, Kind: Float64Array },
  text: { field: 4, Kind: Uint8Array },
  chartOfTriangle: { field: 5, Kind: Uint32Array },
  seams: { field: 6, Kind: Uint32Array },
  unpacked: { field: 7, Kind: Float64Array },
  faces: { field: 8, Kind: Uint32Array },
  faults: { field: 9, Kind: Uint8Array },
  islandOfFace: { field: 10, Kind: Uint32Array },
  obj: { field: 11, Kind: Uint8Array },
  ply: { field: 12, Kind: Uint8Array },
} as const;
