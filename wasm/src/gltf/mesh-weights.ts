// Relative texel densities of the meshes of a document.

import type { Document, Mesh } from '@gltf-transform/core';
import { densitiesFor, type Weights, weightOf } from '../messages/weights.js';
import { type DocumentPart, type Member, meshName } from './document-mesh.js';
import type { OwnMeshes } from './own-meshes.js';

/** Asks for each weight once, before meshes are copied. */
export class MeshWeights {
  readonly #weights: Map<Mesh, number>;

  constructor(document: Document, weights: Weights<Mesh> | undefined) {
    this.#weights = new Map(
      document
        .getRoot()
        .listMeshes()
        .map((mesh) => [mesh, weightOf(mesh, weights, () => meshName(document, mesh))]),
    );
  }

  /** `copies`: once meshes have been copied. */
  takesPart({ mesh }: Member, copies?: OwnMeshes): boolean {
    return this.#of(mesh, copies) > 0;
  }

  /** The option `faceDensities` of an atlas, if it needs any. */
  options(parts: readonly DocumentPart[], copies: OwnMeshes): { faceDensities?: Float64Array } {
    const faceDensities = densitiesFor(
      parts.map(({ mesh, triangleCount }) => ({ weight: this.#of(mesh, copies), triangleCount })),
    );
    return faceDensities ? { faceDensities } : {};
  }

  /** Texels that parts want, relative to others. */
  size(part: DocumentPart, area: number, copies: OwnMeshes): number {
    return area * this.#of(part.mesh, copies) ** 2;
  }

  #of(mesh: Mesh, copies?: OwnMeshes): number {
    return this.#weights.get(copies?.originalOf(mesh) ?? mesh) ?? 1;
  }
}
