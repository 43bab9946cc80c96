// Meshes.

/** Coordinates; Float32Array and Float64Array are passed on as they are, others are copied. */
export type RealArray =
  | Float32Array
  | Float64Array
  | Int8Array
  | Int16Array
  | Int32Array
  | WholeArray;

/**
 * Whole numbers from 0; Uint8Array, Uint16Array and Uint32Array are passed on as they are, others
 * are copied.
 */
export type WholeArray = Uint8Array | Uint16Array | Uint32Array | Int32Array | readonly number[];

/**
 * A triangle mesh as arrays. `positions`: xyz per vertex. `indices`: 3 vertices per triangle,
 * counter-clockwise; without them, every three vertices form a triangle.
 */
export interface MeshArrays {
  positions: RealArray;
  indices?: WholeArray;
  /**
   * The mesh's existing texcoords, 2 per vertex, NaN for a vertex without any: for `pack`,
   * `seams: 'uv'` and `fixedFaces`.
   */
  texcoords?: RealArray;
  /**
   * Shading normals, 3 per vertex and of any length: for seams `'hard'` and `'auto'`. 0 for a
   * vertex without any, which then has those of its triangles.
   */
  normals?: RealArray;
  /** The same with 3 per corner of a triangle, in place of `normals`. */
  cornerNormals?: RealArray;
  /** One number per triangle: for seams `'material'` and `'auto'`, and for `stack`. */
  materials?: WholeArray;
  /**
   * One number per vertex, that of the object it is part of. Vertices of different objects are apart
   * for `unwrap`, even in one place. Default: there is one object.
   */
  vertexObjects?: WholeArray;
}

/**
 * The bytes of an OBJ, PLY, STL or OFF file. `name` helps to tell the format and appears in
 * messages.
 */
export interface MeshFile {
  bytes: Uint8Array | ArrayBuffer;
  name?: string;
}

export type MeshInput = MeshArrays | MeshFile;

/** Positions: 3 per vertex. Indices: 3 per triangle. */
export interface TriangleMesh {
  positions: Float64Array;
  indices: Uint32Array;
}

/** `faces`: for each triangle, the face of the file that it came from. */
export interface LoadedMesh extends TriangleMesh {
  faces: Uint32Array;
}
