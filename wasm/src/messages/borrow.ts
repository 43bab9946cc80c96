import type { Owned } from './input.js';
import type { OwnedMesh } from './protocol.js';
import { checkBoolean, checkMemory } from './validate.js';

/** The arrays as they are, for a call that has read them when it returns. */
export function borrow<T extends OwnedMesh>(mesh: T, transfer: unknown): Owned<T> {
  checkBoolean('transfer', transfer);
  // A getter of the mesh may have taken an array since it was checked.
  for (const [name, value] of Object.entries(mesh))
    if (ArrayBuffer.isView(value)) checkMemory(name, value);
  return { mesh, buffers: [] };
}
