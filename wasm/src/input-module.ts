// What the modules that are given a mesh have in common; see wasm/bindings/input_api.cpp.

/** Pointers and sizes are unsigned in C++ and signed here: add `>>> 0`. */
export interface InputModule {
  _abflatName(job: number, bytes: number): number;
  _abflatSource(job: number, bytes: number): number;
  _abflatPositions(job: number, count: number): number;
  _abflatIndices(job: number, count: number): number;
  _abflatTexcoords(job: number, count: number): number;
  _abflatNormals(job: number, count: number, areOfCorners: boolean): number;
  _abflatMaterials(job: number, count: number): number;
  _abflatVertexObjects(job: number, count: number): number;
  _abflatResultData(job: number, field: number): number;
  _abflatResultSize(job: number, field: number): number;
}
