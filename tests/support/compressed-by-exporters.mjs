// Files as written by exporters for the web: compressed by Draco or by meshopt.

import { NodeIO } from '@gltf-transform/core';
import {
  ALL_EXTENSIONS,
  EXTMeshoptCompression,
  KHRDracoMeshCompression,
  KHRMeshQuantization,
} from '@gltf-transform/extensions';
import draco3d from 'draco3d';
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer';
import { primitivesOf } from './gltf.mjs';

await Promise.all([MeshoptDecoder.ready, MeshoptEncoder.ready]);

/** Reads and writes compressed files. */
export const codecIo = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({
  'draco3d.decoder': await draco3d.createDecoderModule(),
  'draco3d.encoder': await draco3d.createEncoderModule(),
  'meshopt.decoder': MeshoptDecoder,
  'meshopt.encoder': MeshoptEncoder,
});

export function withDraco(document, method = 'edgebreaker') {
  document.createExtension(KHRDracoMeshCompression).setRequired(true).setEncoderOptions({ method });
  return codecIo.writeBinary(document);
}

/** Filters turn normals and the like into integers. */
export function withMeshopt(document, method = 'quantize') {
  document.createExtension(KHRMeshQuantization).setRequired(true);
  document.createExtension(EXTMeshoptCompression).setRequired(true).setEncoderOptions({ method });
  return codecIo.writeBinary(document);
}

/** Positions in 16 bits, as large as the box from -2 to 2 allows. */
export function quantize(document) {
  for (const position of new Set(primitivesOf(document).map((p) => p.getAttribute('POSITION'))))
    position
      .setArray(Int16Array.from(position.getArray(), (x) => Math.round((32767 * x) / 2)))
      .setNormalized(true);
  return document;
}

/** The JSON of a GLB and its bytes, for modification. */
export function partsOf(glb) {
  const bytes = Buffer.from(glb);
  const length = bytes.readUInt32LE(12);
  return {
    json: JSON.parse(bytes.subarray(20, 20 + length)),
    bin: Buffer.from(bytes.subarray(28 + length)),
  };
}

export function glbOf({ json, bin }) {
  const text = Buffer.from(JSON.stringify(json));
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, ' ')]);
  const head = Buffer.from('glTF            JSON        BIN ');
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(28 + padded.length + bin.length, 8);
  head.writeUInt32LE(padded.length, 12);
  head.writeUInt32LE(bin.length, 20);
  head.write('BIN\0', 24);
  return Buffer.concat([head.subarray(0, 20), padded, head.subarray(20, 28), bin]);
}
