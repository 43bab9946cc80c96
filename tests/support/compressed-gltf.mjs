// glTF files compressed by Draco and meshopt, by the libraries that pipelines use.

import { Logger, NodeIO } from '@gltf-transform/core';
import {
  ALL_EXTENSIONS,
  EXTMeshoptCompression,
  KHRDracoMeshCompression,
} from '@gltf-transform/extensions';
import { meshopt, weld } from '@gltf-transform/functions';
import draco3d from 'draco3d';
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer';
import { parseGltf } from './glb.mjs';
import { accessor, primitivesOf, trianglesOf } from './gltf.mjs';

await Promise.all([MeshoptDecoder.ready, MeshoptEncoder.ready]);

/** Reads and writes either compression: a file means what its decoder says. */
export const io = new NodeIO()
  .setLogger(new Logger(Logger.Verbosity.SILENT))
  .registerExtensions(ALL_EXTENSIONS)
  .registerDependencies({
    'draco3d.decoder': await draco3d.createDecoderModule(),
    'draco3d.encoder': await draco3d.createEncoderModule(),
    'meshopt.decoder': MeshoptDecoder,
    'meshopt.encoder': MeshoptEncoder,
  });

const draco = (method) => async (document) => {
  await document.transform(weld());
  document
    .createExtension(KHRDracoMeshCompression)
    .setRequired(true)
    .setEncoderOptions({ method: KHRDracoMeshCompression.EncoderMethod[method] });
};

/** Ways to compress a glTF-Transform document. */
export const COMPRESSIONS = {
  'Draco, edgebreaker': draco('EDGEBREAKER'),
  'Draco, sequential': draco('SEQUENTIAL'),
  'meshopt, without loss': async (document) => {
    document.createExtension(EXTMeshoptCompression).setRequired(true);
  },
  'meshopt, quantized': (document) =>
    document.transform(meshopt({ encoder: MeshoptEncoder, level: 'medium' })),
  'meshopt, filtered': (document) =>
    document.transform(meshopt({ encoder: MeshoptEncoder, level: 'high' })),
};

/** Neither compression supports strips or one-byte indices; points get indices. */
function withIndices(document, primitive) {
  const isDrawn = primitive.getMode() >= 4;
  const count = primitive.getAttribute('POSITION').getCount();
  const points = Array.from({ length: count }, (_, i) => i);
  if (!isDrawn) primitive.setIndices(accessor(document, 'SCALAR', Uint16Array.from(points)));
  if (!isDrawn) return;
  primitive.getIndices()?.setArray(Uint16Array.from(trianglesOf(primitive).flat()));
  primitive.setMode(4);
}

/** Meshopt has a filter for rotations. */
function addRotation(document) {
  const [animation] = document.getRoot().listAnimations();
  if (!animation) return;
  const turns = Array.from({ length: 9 }, (_, i) => (Math.PI * i) / 16);
  const rotations = turns.flatMap((turn) => [0, Math.sin(turn), 0, Math.cos(turn)]);
  const sampler = document
    .createAnimationSampler()
    .setInput(accessor(document, 'SCALAR', Float32Array.from(turns)))
    .setOutput(accessor(document, 'VEC4', Float32Array.from(rotations)));
  const channel = document
    .createAnimationChannel()
    .setSampler(sampler)
    .setTargetNode(document.getRoot().listNodes()[0])
    .setTargetPath('rotation');
  animation.addSampler(sampler).addChannel(channel);
}

/** A .glb compressed in one of these ways. */
export async function compressed(glb, how) {
  const document = await io.readBinary(new Uint8Array(glb));
  for (const primitive of primitivesOf(document)) withIndices(document, primitive);
  addRotation(document);
  await COMPRESSIONS[how](document);
  return Buffer.from(await io.writeBinary(document));
}

/** Names of compressions that a file still mentions. */
export function compressionsIn(bytes) {
  const text = JSON.stringify(parseGltf(bytes).json);
  return text.match(/\w+_(draco_mesh|meshopt)_compression/g) ?? [];
}

/** The compressed views of a file, as the file describes them. */
export const meshoptViews = (json) =>
  json.bufferViews.flatMap(({ extensions }) => extensions?.EXT_meshopt_compression ?? []);
