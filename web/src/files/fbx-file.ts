// Reads an FBX as a glTF.

import type { Document } from '@gltf-transform/core';
import type { FbxContent } from '../model/model';
import { FBX } from '../words/fbx';
import { READING } from '../words/opening';
import { fbxDocument } from './fbx-document';
import { facesOf } from './fbx-polygons';
import { fbxScene } from './fbx-scene';
import { remarksOn } from './missing-files';

interface ReadFbx {
  document: Document;
  lost: FbxContent[];
  /** What to say when it is opened, as sentences. */
  remarks: string[];
}

const BINARY = /^Kaydara FBX Binary/;
/** The version of a binary file is behind its first bytes, that of a text near its beginning. */
const VERSION_AT = 23;
const IN_TEXT = /^[^"]*\bFBXVersion:\s*(\d+)/;
const HEAD = 1 << 16;
const OLDEST = 7000;

export async function readFbx(file: File, others: File[]): Promise<ReadFbx> {
  const { name } = file;
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (bytes.length === 0) throw new Error(READING.empty(name));
  const isBinary = checkVersion(name, bytes);
  const scene = fbxScene(name, bytes, isBinary);
  const { hasPolygons, areWhole } = facesOf(bytes, isBinary);
  if (!areWhole) throw new Error(FBX.damaged(name, FBX.vertexMissing));
  const base = name.replace(/\.[^.]*$/, '');
  const { document, lost, images } = await fbxDocument(base, scene, others);
  if (hasPolygons) lost.add('polygons');
  const triangles = hasPolygons ? FBX.triangles : '';
  return {
    document,
    lost: [...lost],
    remarks: [
      FBX.opened(name),
      triangles,
      FBX.leftOut([...lost]),
      ...remarksOn(name, images.missing, images.undecoded),
    ].filter(Boolean),
  };
}

/** Returns whether it is binary. */
function checkVersion(name: string, bytes: Uint8Array): boolean {
  const start = new TextDecoder('latin1').decode(bytes.subarray(0, HEAD));
  const isBinary = BINARY.test(start) && bytes.length >= VERSION_AT + 4;
  const version = isBinary
    ? new DataView(bytes.buffer).getUint32(VERSION_AT, true)
    : Number(IN_TEXT.exec(start)?.[1] ?? Number.NaN);
  if (Number.isNaN(version)) throw new Error(FBX.notFbx(name));
  if (version < OLDEST) throw new Error(FBX.tooOld(name, version));
  return isBinary;
}
