// Pixels of KTX2 textures, as a glTF has them: Basis Universal.

import transcoderWasm from 'three/examples/jsm/libs/basis/basis_transcoder.wasm?url';
import { loadInWorker } from '../base/load-part';
import { startOnce } from '../base/start-once';
import { KTX2_IMAGE } from '../words/ktx2';
import { fetched } from './decoders';

export const KTX2 = 'image/ktx2';

export interface Pixels {
  /** RGBA. */
  data: Uint8Array<ArrayBuffer>;
  width: number;
  height: number;
}

/** For baking: null for other images. */
export const decodeKtx2 = async ({ bytes, mimeType }: { bytes: Uint8Array; mimeType: string }) =>
  mimeType === KTX2 ? ktx2Pixels(bytes) : null;

const RGBA = 13;

const transcoder = startOnce(() => loadInWorker(loadTranscoder()));

async function loadTranscoder() {
  const [{ default: createTranscoder }, wasmBinary] = await Promise.all([
    import('three/examples/jsm/libs/basis/basis_transcoder.js'),
    fetched(transcoderWasm),
  ]);
  const module = await createTranscoder({ wasmBinary, printErr: () => undefined });
  module.initializeBasis();
  return module;
}

/** Of the largest level. Throws a sentence without the name of the file. */
export async function ktx2Pixels(bytes: Uint8Array): Promise<Pixels> {
  const { KTX2File } = await transcoder();
  const file = new KTX2File(bytes);
  try {
    if (!file.isValid() || file.isHDR()) throw new Error(KTX2_IMAGE.notBasis);
    const { origWidth: width, origHeight: height } = file.getImageLevelInfo(0, 0, 0);
    const data = new Uint8Array(file.getImageTranscodedSizeInBytes(0, 0, 0, RGBA));
    const isRead =
      file.startTranscoding() &&
      data.length === 4 * width * height &&
      file.transcodeImage(data, 0, 0, 0, RGBA, 0, -1, -1);
    if (!isRead) throw new Error(KTX2_IMAGE.damaged);
    return { data, width, height };
  } finally {
    file.close();
    file.delete();
  }
}
