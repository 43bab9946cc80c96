// Several glTF files as one document, so that they share an atlas and stay what they are.

import {
  Document,
  type Extension,
  type Graph,
  getBounds,
  type Node,
  type Property,
  type PropertyResolver,
  PropertyType,
} from '@gltf-transform/core';
import type { GltfFiles } from '../model/model';
import { compressionsOf, decompressed } from './compression';
import { orDamaged } from './gltf-file';
import { glbOf, gltfIo, openGltf } from './gltf-source';
import { joinVariants } from './joined-variants';
import { sideBySide } from './side-by-side';

/** The files as one GLB: what each shows is under a node with its name. */
export async function joinedGlb(files: GltfFiles[]): Promise<Blob> {
  const joined = new Document();
  const scene = joined.createScene();
  const root = joined.getRoot().setDefaultScene(scene);
  for (const { file, others } of files) {
    const document = await orDamaged(file.name, () => read(file, others));
    const parent = joined.createNode(baseOf(file.name));
    for (const node of addTo(joined, document)) parent.addChild(node);
    scene.addChild(parent);
  }
  // The nodes of skinned meshes move nothing.
  if (root.listSkins().length === 0) placeApart(scene.listChildren());
  joinVariants(joined);
  return new Blob([await glbOf(joined)], { type: 'model/gltf-binary' });
}

const baseOf = (name: string) => name.replace(/\.[^.]*$/, '');

async function read(file: File, others: File[]): Promise<Document> {
  const { source } = await openGltf(file, others);
  if (compressionsOf(source).length > 0) return decompressed(file.name, source);
  return gltfIo().readJSON(source);
}

/** Copies all of a document; returns the nodes of the scene that it shows. */
function addTo(joined: Document, document: Document): Node[] {
  for (const used of document.getRoot().listExtensionsUsed()) {
    const made = joined.createExtension(used.constructor as new (document: Document) => Extension);
    if (used.isRequired()) made.setRequired(true);
  }
  addCopyright(joined, document);
  const copyOf = copies(joined, document);
  const scene = document.getRoot().getDefaultScene() ?? document.getRoot().listScenes()[0];
  const all = new Set(
    document
      .getGraph()
      .listEdges()
      .map((edge) => edge.getChild()),
  );
  // Those of a texture are copied with what has them.
  for (const each of all)
    if (each !== scene && each.propertyType !== PropertyType.TEXTURE_INFO)
      copyOf(each).copy(each, copyOf);
  const nodes = scene?.listChildren() ?? document.getRoot().listNodes().filter(isRoot);
  return nodes.map((node) => copyOf(node) as Node);
}

const isRoot = (node: Node) => node.getParentNode() === null;

/** What stands in one document for something in the other; made when it is first asked for. */
function copies(joined: Document, document: Document): PropertyResolver<Property> {
  const made = new Map<Property, Property>([[document.getRoot(), joined.getRoot()]]);
  return <P extends Property>(each: P): P => {
    if (each.propertyType === PropertyType.TEXTURE_INFO) return each;
    const known = made.get(each);
    if (known) return known as P;
    const Kind = each.constructor as new (graph: Graph<Property>) => P;
    const copy = new Kind(joined.getGraph());
    made.set(each, copy);
    return copy;
  };
}

/** Licences ask for the names in it. */
function addCopyright(joined: Document, document: Document): void {
  const [asset, own] = [joined, document].map((each) => each.getRoot().getAsset());
  const names = [asset.copyright, own.copyright].filter(Boolean);
  if (names.length > 0) asset.copyright = [...new Set(names)].join('; ');
}

function placeApart(parents: Node[]): void {
  const moves = sideBySide(parents.map((parent) => getBounds(parent)));
  for (const [i, parent] of parents.entries())
    if (moves[i] !== 0) parent.setTranslation([moves[i], 0, 0]);
}
