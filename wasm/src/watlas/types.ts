// The types of watlas, by its names.

/** A mesh; strides are in bytes. */
export interface MeshDecl {
  vertexCount: number;
  vertexPositionData: Float32Array | Uint8Array;
  vertexPositionStride: number;
  vertexNormalData?: Float32Array | Uint8Array;
  vertexNormalStride?: number;
  vertexUvData?: Float32Array | Uint8Array;
  vertexUvStride?: number;
  indexData?: Uint32Array | Uint16Array;
  /** Default: all of `indexData`. */
  indexCount?: number;
  /** Added to each index. */
  indexOffset?: number;
  /** Faces of different materials share no chart. */
  faceMaterialData?: Uint32Array;
  /** Faces must be triangles. */
  faceVertexCount?: Uint32Array | Uint8Array;
  faceCount?: number;
  /** Not needed: vertices in the same place are one. */
  epsilon?: number;
}

/** A mesh with a layout, whose charts are packed as they are. */
export interface UvMeshDecl {
  vertexCount: number;
  vertexUvData: Float32Array | Uint8Array;
  vertexStride: number;
  indexData?: Uint32Array | Uint16Array;
  indexCount?: number;
  indexOffset?: number;
  /** Accepted, but charts of different materials lie in the same atlas. */
  faceMaterialData?: Uint32Array;
}

export interface ChartOptions {
  maxChartArea?: number;
  maxBoundaryLength?: number;
  normalDeviationWeight?: number;
  roundnessWeight?: number;
  straightnessWeight?: number;
  normalSeamWeight?: number;
  textureSeamWeight?: number;
  maxCost?: number;
  maxIterations?: number;
  /** Pack the charts of `vertexUvData` as they are, if all meshes have it. */
  useInputMeshUvs?: boolean;
  fixWinding?: boolean;
}

export interface PackOptions {
  maxChartSize?: number;
  padding?: number;
  texelsPerUnit?: number;
  resolution?: number;
  bilinear?: boolean;
  blockAlign?: boolean;
  bruteForce?: boolean;
  rotateChartsToAxis?: boolean;
  rotateCharts?: boolean;
}

export interface Vertex {
  /** -1 for a vertex of a face without area, as `chartIndex`. */
  atlasIndex: number;
  chartIndex: number;
  /** In texels. */
  uv: [number, number];
  /** The vertex of the mesh. */
  xref: number;
}
