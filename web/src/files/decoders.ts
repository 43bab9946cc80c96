// Decoders for compressed glTF files. None of them is loaded with the page.

import dracoWasm from 'draco3d/draco_decoder.wasm?url';
import { loadInWorker } from '../base/load-part';

export type Compression = 'Draco' | 'meshopt';

/** Each decoder is under the name that glTF-Transform asks for. */
const LOADERS: Record<Compression, () => Promise<Record<string, unknown>>> = {
  Draco: async () => ({ 'draco3d.decoder': await loadDraco() }),
  meshopt: async () => ({ 'meshopt.decoder': await loadMeshopt() }),
};

export async function loadDecoders(kinds: Compression[]): Promise<Record<string, unknown>> {
  const loaded = await loadInWorker(Promise.all(kinds.map((kind) => LOADERS[kind]())));
  return Object.assign({}, ...loaded);
}

/**
 * Draco's own loader would look for the module beside the worker, and fall back to blocking
 * requests.
 */
async function loadDraco(): Promise<unknown> {
  const [{ default: createDecoder }, wasmBinary] = await Promise.all([
    import('draco3d/draco_decoder_nodejs.js'),
    fetched(dracoWasm),
  ]);
  return createDecoder({ wasmBinary, printErr: () => undefined });
}

async function loadMeshopt(): Promise<unknown> {
  const { MeshoptDecoder } = await import('meshoptimizer/decoder');
  await MeshoptDecoder.ready;
  return MeshoptDecoder;
}

export async function fetched(url: string): Promise<ArrayBuffer> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${response.url}: ${response.status}`);
  return response.arrayBuffer();
}
