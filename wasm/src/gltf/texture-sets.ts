// Which texcoord sets the textures of a document use.

import type {
  Document,
  ExtensionProperty,
  Material,
  Primitive,
  TextureInfo,
} from '@gltf-transform/core';
import { isOfTriangles } from './triangles.js';

type Node = Primitive | Material | ReturnType<Primitive['listExtensions']>[number];

/**
 * The sets that textures of the primitives' materials sample, in ascending order; 0 is TEXCOORD_0.
 * Materials from extensions, such as variants, count, as do textures that extensions add; a set
 * given by KHR_texture_transform replaces the texture's own.
 */
export function sampledTexcoords(primitives: Iterable<Primitive>): number[] {
  return setsOf(primitives, () => false);
}

/** The same without the textures that baking replaces: those of the materials' own maps. */
export function keptTexcoords(primitives: Iterable<Primitive>): number[] {
  const all = [...primitives];
  const own = new Set<Node>(all.map((each) => each.getMaterial()).filter((each) => each !== null));
  const others = new Set<Node>();
  // Variants may use a material of a primitive, too, and stay.
  const visit = (node: Node) => {
    for (const child of node.getGraph().listChildren(node)) {
      if (child.propertyType === 'Material') others.add(child as Material);
      else if ('extensionName' in child) visit(child as Node);
    }
  };
  for (const primitive of all) for (const extension of primitive.listExtensions()) visit(extension);
  return setsOf(all, (node) => own.has(node) && !others.has(node));
}

/** `isBaked`: of a material whose own textures do not count. */
function setsOf(primitives: Iterable<Primitive>, isBaked: (node: Node) => boolean): number[] {
  const [found, seen] = [new Set<number>(), new Set<Node>()];
  const visit = (node: Node) => {
    if (seen.has(node)) return;
    seen.add(node);
    const edges = node.getGraph().listChildEdges(node);
    const textured = new Set(
      edges
        .filter((edge) => edge.getChild().propertyType === 'Texture')
        .map((edge) => `${edge.getName()}Info`),
    );
    for (const edge of edges) {
      const child = edge.getChild();
      if (child.propertyType === 'Material' || 'extensionName' in child) visit(child as Node);
      else if (textured.has(edge.getName()) && !isBaked(node))
        found.add(setOf(child as TextureInfo));
    }
  };
  for (const primitive of primitives) visit(primitive);
  return [...found].sort((a, b) => a - b);
}

function setOf(info: TextureInfo): number {
  type Transform = ExtensionProperty & { getTexCoord(): number | null };
  const transform = info.getExtension<Transform>('KHR_texture_transform');
  return transform?.getTexCoord() ?? info.getTexCoord();
}

/**
 * A set for new coordinates that no texture is affected by: 0 if no texture samples it, otherwise
 * the first set that no primitive has and no texture samples.
 */
export function freeTexcoord(document: Document): number {
  return firstFree(document, sampledTexcoords);
}

/** The same if materials are baked. */
export const freeBakedTexcoord = (document: Document) => firstFree(document, keptTexcoords);

function firstFree(
  document: Document,
  sampledBy: (primitives: Iterable<Primitive>) => number[],
): number {
  const primitives = document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives())
    .filter((primitive) => isOfTriangles(primitive.getMode()));
  const sampled = sampledBy(primitives);
  if (!sampled.includes(0)) return 0;
  const isTaken = (set: number) =>
    sampled.includes(set) || primitives.some((each) => each.getAttribute(`TEXCOORD_${set}`));
  let set = 1;
  while (isTaken(set)) ++set;
  return set;
}
