// Meshes in the memory of the module, and the results that it has of them.

import { RESULT_ARRAYS } from './base/generated-arrays.js';
import { Heap } from './heap.js';
import type { InputModule } from './input-module.js';
import type { OwnedMesh } from './messages/protocol.js';

export type ResultName = keyof typeof RESULT_ARRAYS;
export type ResultArray<Name extends ResultName> = InstanceType<
  (typeof RESULT_ARRAYS)[Name]['Kind']
>;

export class MeshHeap extends Heap {
  readonly #native: InputModule;

  constructor(native: InputModule, memory: WebAssembly.Memory, maxBytes: number) {
    super(memory, maxBytes);
    this.#native = native;
  }

  /**
   * Copies the mesh to the module and lets go of its arrays, so that they can be freed
   * while the module works.
   */
  writeMesh(job: number, mesh: OwnedMesh): void {
    this.checkBytes(bytesOf(mesh));
    if ('bytes' in mesh) {
      this.writeName(job, mesh.name);
      this.writeBytes(this.#native._abflatSource(job, mesh.bytes.length), mesh.bytes);
      mesh.bytes = new Uint8Array();
      return;
    }
    const native = this.#native;
    const { positions, indices, texcoords, normals, cornerNormals, materials } = mesh;
    const { vertexObjects } = mesh;
    this.writeName(job, 'arrays');
    this.writeReals(native._abflatPositions(job, positions.length), positions);
    this.writeNumbers(native._abflatIndices(job, indices.length), indices);
    if (texcoords) this.writeReals(native._abflatTexcoords(job, texcoords.length), texcoords);
    if (cornerNormals)
      this.writeReals(native._abflatNormals(job, cornerNormals.length, true), cornerNormals);
    else if (normals) this.writeReals(native._abflatNormals(job, normals.length, false), normals);
    if (materials) this.writeNumbers(native._abflatMaterials(job, materials.length), materials);
    if (vertexObjects)
      this.writeNumbers(native._abflatVertexObjects(job, vertexObjects.length), vertexObjects);
    for (const name of Object.keys(mesh)) delete mesh[name as keyof typeof mesh];
  }

  writeName(job: number, name: string): void {
    this.writeText(name, (bytes) => this.#native._abflatName(job, bytes));
  }

  /** `room` allocates that many bytes and returns their address. */
  writeText(text: string, room: (bytes: number) => number): void {
    const bytes = new TextEncoder().encode(text);
    this.writeBytes(room(bytes.length), bytes);
  }

  writeArray(address: number, array: Uint32Array | Float64Array): void {
    if (array instanceof Float64Array) this.writeReals(address, array);
    else this.writeNumbers(address, array);
  }

  /** A copy of a result. */
  read<Name extends ResultName>(job: number, name: Name): ResultArray<Name> {
    const { field, Kind } = RESULT_ARRAYS[name];
    const start = this.#native._abflatResultData(job, field);
    const copy = this.copy(start, this.#native._abflatResultSize(job, field));
    return new Kind(copy) as ResultArray<Name>;
  }

  readText(job: number): string {
    return new TextDecoder().decode(this.read(job, 'text'));
  }
}

function bytesOf(mesh: OwnedMesh): number {
  if ('bytes' in mesh) return mesh.bytes.length;
  const numbers = (array?: { length: number }) => array?.length ?? 0;
  return (
    8 * (numbers(mesh.positions) + numbers(mesh.texcoords)) +
    8 * numbers(mesh.cornerNormals ?? mesh.normals) +
    4 * (numbers(mesh.indices) + numbers(mesh.materials) + numbers(mesh.vertexObjects))
  );
}
