// Nodes that share a mesh get meshes of their own.

import type { Document, Mesh, Node } from '@gltf-transform/core';

export interface OwnMeshes {
  /** The mesh that a copy was made of, or the mesh itself. */
  originalOf(mesh: Mesh): Mesh;
  /** Takes the copies away again. */
  takeBack(): void;
}

/**
 * Gives nodes of the scene that share one of `meshes` a mesh each: the first node keeps it, the
 * others get copies, which use the same accessors.
 */
export function giveOwnMeshes(document: Document, meshes: ReadonlySet<Mesh>): OwnMeshes {
  const root = document.getRoot();
  const used = new Set<Mesh>();
  const given: { node: Node; mesh: Mesh; copy: Mesh }[] = [];
  (root.getDefaultScene() ?? root.listScenes()[0])?.traverse((node) => {
    const mesh = node.getMesh();
    if (!mesh || !meshes.has(mesh)) return;
    if (used.has(mesh)) given.push({ node, mesh, copy: copyOf(mesh) });
    used.add(mesh);
  });
  for (const { node, copy } of given) node.setMesh(copy);
  const originals = new Map(given.map(({ mesh, copy }) => [copy, mesh]));
  return {
    originalOf: (mesh) => originals.get(mesh) ?? mesh,
    takeBack: () => {
      for (const { node, mesh, copy } of given) {
        node.setMesh(mesh);
        dispose(copy);
      }
    },
  };
}

/** Clones alone would share primitives and morph targets. */
function copyOf(mesh: Mesh): Mesh {
  const copy = mesh.clone();
  for (const primitive of mesh.listPrimitives()) {
    const own = primitive.clone();
    for (const target of primitive.listTargets())
      own.removeTarget(target).addTarget(target.clone());
    copy.removePrimitive(primitive).addPrimitive(own);
  }
  return copy;
}

function dispose(mesh: Mesh): void {
  for (const primitive of mesh.listPrimitives()) {
    for (const target of primitive.listTargets()) target.dispose();
    primitive.dispose();
  }
  mesh.dispose();
}
