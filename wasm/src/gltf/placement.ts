// Where the nodes of a document put its meshes.

import type { Document, Mesh, Node } from '@gltf-transform/core';
import { AS_IT_IS, type Placement, type Usage, usedAt } from '../base/placement.js';

/**
 * Where the nodes of a document put its meshes, or those of its scene if it uses them. All nodes of
 * a mesh share one layout, so only the node that makes it largest counts, the first of several. A
 * skinned mesh is where its vertices are, and so is one that all nodes flatten.
 */
export class Placements {
  readonly #usages = new Map<Mesh, Usage>();

  constructor(document: Document) {
    const root = document.getRoot();
    const inScene: Node[] = [];
    (root.getDefaultScene() ?? root.listScenes()[0])?.traverse((node) => inScene.push(node));
    this.#add(inScene);
    const isOutside = (mesh: Mesh | null) => mesh !== null && !this.#usages.has(mesh);
    this.#add(root.listNodes().filter((node) => isOutside(node.getMesh())));
  }

  #add(nodes: Node[]): void {
    for (const node of nodes) {
      const mesh = node.getMesh();
      if (!mesh) continue;
      const matrix = node.getSkin() ? undefined : node.getWorldMatrix();
      this.#usages.set(mesh, usedAt(matrix, this.#usages.get(mesh)));
    }
  }

  of(mesh: Mesh): Placement {
    return this.#usages.get(mesh)?.placement ?? AS_IT_IS;
  }

  /** Which meshes are in several places, in one note. */
  notes(meshes: Iterable<Mesh>): string[] {
    const shared = [...new Set(meshes)]
      .map((mesh) => this.#usages.get(mesh))
      .filter((usage): usage is Usage => usage !== undefined && usage.places > 1);
    if (shared.length === 0) return [];
    const nodes = shared.reduce((sum, usage) => sum + usage.places, 0);
    const scales = shared.some(({ hasScales }) => hasScales)
      ? '. Their scales differ, so each layout is sized for the largest node'
      : '';
    return [
      `${nodes} nodes share ${shared.length} ${shared.length === 1 ? 'mesh and its' : 'meshes and their'} texels${scales}`,
    ];
  }
}
