// Which triangles of a glTF belong to which object and which material.

import type { Accessor, Document, ExtensionProperty, Mesh, Node } from '@gltf-transform/core';
import type { DocumentPart } from 'abflat/gltf';
import type { NamedPart, NamedParts } from '../model/named-parts';

type Instancing = ExtensionProperty & { listAttributes(): Accessor[] };

export function namedParts(document: Document, parts: DocumentPart[]): NamedParts {
  const nodes = document.getRoot().listNodes();
  const objects = [...grouped(parts, ({ mesh }) => mesh)].map(([mesh, runs]) =>
    objectOf(
      mesh,
      nodes.filter((node) => node.getMesh() === mesh),
      runs,
    ),
  );
  const all = grouped(parts, ({ primitive }) => primitive.getMaterial());
  const materials = [...all].map(([material, runs]) => ({
    name: material?.getName() ?? '',
    isThere: material !== null,
    copies: 1,
    runs,
  }));
  return { objects, materials };
}

type Runs = NamedPart['runs'];

function grouped<K>(parts: DocumentPart[], keyOf: (part: DocumentPart) => K): Map<K, Runs> {
  const groups = new Map<K, Runs>();
  for (const part of parts) {
    const runs = groups.get(keyOf(part)) ?? [];
    runs.push([part.firstTriangle, part.triangleCount]);
    groups.set(keyOf(part), runs);
  }
  return groups;
}

/** What several nodes have in common is the mesh. */
function objectOf(mesh: Mesh, nodes: Node[], runs: Runs): NamedPart {
  const [first] = nodes;
  const own = nodes.length === 1 ? first.getName() : '';
  const name = own || mesh.getName() || (first ? nameAround(first) : '');
  const copies = nodes.reduce((sum, node) => sum + copiesOf(node), 0);
  return { name, isThere: true, copies, runs };
}

function nameAround(node: Node): string {
  for (let at: Node | null = node; at; at = at.getParentNode())
    if (at.getName()) return at.getName();
  return '';
}

/** A node may draw its mesh many times. */
function copiesOf(node: Node): number {
  const instancing = node.getExtension<Instancing>('EXT_mesh_gpu_instancing');
  return instancing?.listAttributes()[0]?.getCount() ?? 1;
}
