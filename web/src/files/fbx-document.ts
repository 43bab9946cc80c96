// A scene of three.js, read from an FBX, as a glTF document.

import { Document, type Mesh as GltfMesh, type Node } from '@gltf-transform/core';
import type { AnimationClip, KeyframeTrack, Matrix4, Mesh, Object3D, SkinnedMesh } from 'three';
import type { FbxContent } from '../model/model';
import { FbxImages } from './fbx-images';
import { FbxMaterials } from './fbx-materials';
import type { FbxScene } from './fbx-scene';
import { columnsOf, primitiveOf } from './fbx-vertices';

export interface FbxDocument {
  document: Document;
  lost: Set<FbxContent>;
  images: Pick<FbxImages, 'missing' | 'undecoded'>;
}

/** An FBX counts centimetres times its factor, a glTF metres. */
const CENTIMETRES = 100;

export async function fbxDocument(
  name: string,
  { scene, textures, embedded }: FbxScene,
  others: File[],
): Promise<FbxDocument> {
  const document = new Document();
  document.createBuffer();
  const images = new FbxImages(document, embedded, others);
  const materials = new FbxMaterials(document, images);
  const lost = new Set<FbxContent>();
  const unit = Number(scene.userData.unitScaleFactor ?? 1) / CENTIMETRES;
  const placed = placeRoot(scene, unit);
  const nodes = new Map<Object3D, Node>();
  scene.traverse((object) => {
    if ('isAmbientLight' in object) return; // a setting of the file
    const node = nodeOf(document, object, object === scene ? name : '');
    nodes.get(object.parent as Object3D)?.addChild(node);
    nodes.set(object, node);
    noteLost(object, lost);
  });
  document.createScene().addChild(nodes.get(scene) as Node);
  const meshes = new Map<string, GltfMesh>();
  for (const [object, node] of nodes) {
    if (!isMesh(object)) continue;
    const skinned = isSkinned(object) ? object : null;
    const moved = skinned && placed.clone().multiply(skinned.bindMatrix);
    const key = keyOf(object);
    const mesh = meshes.get(key) ?? (await meshOf(document, object, moved, materials));
    if (!skinned) meshes.set(key, mesh);
    node.setMesh(mesh);
    if (skinned && !addSkin(document, node, skinned, placed, nodes)) lost.add('skins');
  }
  for (const clip of scene.animations) addAnimation(document, clip, { scene, nodes, unit, lost });
  if (materials.leavesOut(textures)) lost.add('maps');
  return { document, lost, images };
}

/** Makes lengths metres; returns where that, and the axis that points up, puts what was placed before. */
function placeRoot(scene: Object3D, unit: number): Matrix4 {
  const before = scene.matrix.clone();
  scene.scale.multiplyScalar(unit);
  scene.position.multiplyScalar(unit);
  scene.updateMatrixWorld(true);
  return scene.matrixWorld.clone().multiply(before.invert());
}

function nodeOf(document: Document, object: Object3D, usual: string): Node {
  const { position, quaternion, scale, name, userData } = object;
  return document
    .createNode(userData.originalName ?? (name || usual))
    .setTranslation(position.toArray())
    .setRotation(quaternion.normalize().toArray() as [number, number, number, number])
    .setScale(scale.toArray());
}

const isMesh = (object: Object3D): object is Mesh => 'isMesh' in object;
const isSkinned = (object: Object3D): object is SkinnedMesh =>
  'isSkinnedMesh' in object && Boolean((object as SkinnedMesh).skeleton);

function noteLost(object: Object3D, lost: Set<FbxContent>): void {
  if ('isCamera' in object) lost.add('cameras');
  if ('isLight' in object) lost.add('lights');
  if ('isLine' in object) lost.add('curves');
}

const materialsOf = ({ material }: Mesh) => (Array.isArray(material) ? material : [material]);

/** Copies share a mesh. */
const keyOf = (mesh: Mesh) => [mesh.geometry, ...materialsOf(mesh)].map(({ uuid }) => uuid).join();

/** A primitive for each material, whose triangles keep their order. */
async function meshOf(
  document: Document,
  object: Mesh,
  moved: Matrix4 | null,
  materials: FbxMaterials,
): Promise<GltfMesh> {
  const { geometry } = object;
  const mesh = document.createMesh(geometry.name || object.name);
  const columns = columnsOf(object, moved);
  const count = geometry.attributes.position.count;
  const whole = [{ start: 0, count, materialIndex: 0 }];
  const cornersOf = new Map<number, number[]>();
  for (const group of geometry.groups.length > 0 ? geometry.groups : whole) {
    const index = group.materialIndex ?? 0;
    const corners = cornersOf.get(index) ?? [];
    cornersOf.set(index, corners);
    for (let c = group.start; c < group.start + group.count; ++c) corners.push(c);
  }
  const known = materialsOf(object);
  for (const [index, corners] of cornersOf) {
    if (corners.length === 0) continue;
    const material = known[index];
    const primitive = primitiveOf(document, columns, corners);
    mesh.addPrimitive(primitive.setMaterial(material ? await materials.of(material) : null));
  }
  const targets = geometry.morphAttributes.position ?? [];
  if (targets.length > 0)
    mesh.setWeights(targets.map((_, i) => object.morphTargetInfluences?.[i] ?? 0));
  return mesh;
}

/** Returns whether all bones are there. The vertices of the mesh are where its bones hold them. */
function addSkin(
  document: Document,
  node: Node,
  { skeleton: { bones, boneInverses } }: SkinnedMesh,
  placed: Matrix4,
  nodes: Map<Object3D, Node>,
): boolean {
  const joints = bones.map((bone) => nodes.get(bone));
  if (joints.length === 0 || joints.some((joint) => !joint)) {
    dropJoints(node);
    return false;
  }
  const back = placed.clone().invert();
  const matrices = boneInverses.flatMap((inverse) => inverse.clone().multiply(back).toArray());
  const accessor = document
    .createAccessor()
    .setType('MAT4')
    .setBuffer(document.getRoot().listBuffers()[0])
    .setArray(new Float32Array(matrices));
  const skin = document.createSkin().setInverseBindMatrices(accessor);
  for (const joint of joints) skin.addJoint(joint as Node);
  node.setSkin(skin);
  return true;
}

function dropJoints(node: Node): void {
  for (const primitive of node.getMesh()?.listPrimitives() ?? [])
    for (const semantic of ['JOINTS_0', 'WEIGHTS_0']) primitive.setAttribute(semantic, null);
}

const PATHS = { position: 'translation', quaternion: 'rotation', scale: 'scale' } as const;

interface Animated {
  scene: Object3D;
  nodes: Map<Object3D, Node>;
  unit: number;
  lost: Set<FbxContent>;
}

function addAnimation(document: Document, clip: AnimationClip, animated: Animated): void {
  const animation = document.createAnimation(clip.name);
  for (const track of clip.tracks) addTrack(document, animation, track, animated);
  if (animation.listChannels().length === 0) animation.dispose();
}

function addTrack(
  document: Document,
  animation: ReturnType<Document['createAnimation']>,
  { name, times, values }: KeyframeTrack,
  { scene, nodes, unit, lost }: Animated,
): void {
  const [, of, property] = /^(.*)\.([^.]*)$/.exec(name) ?? [];
  if (property?.startsWith('morphTargetInfluences')) lost.add('morphAnimations');
  const path = PATHS[property as keyof typeof PATHS];
  const object = scene.getObjectByName(of ?? '');
  const node = object && nodes.get(object);
  if (!path || !node || times.length === 0) return;
  const scaled = object === scene && path !== 'rotation' ? unit : 1;
  const buffer = document.getRoot().listBuffers()[0];
  const accessor = () => document.createAccessor().setBuffer(buffer);
  const sampler = document
    .createAnimationSampler()
    .setInput(accessor().setArray(Float32Array.from(times)))
    .setOutput(
      accessor()
        .setType(path === 'rotation' ? 'VEC4' : 'VEC3')
        .setArray(Float32Array.from(values, (x) => scaled * x)),
    );
  const channel = document
    .createAnimationChannel()
    .setTargetNode(node)
    .setTargetPath(path)
    .setSampler(sampler);
  animation.addSampler(sampler).addChannel(channel);
}
