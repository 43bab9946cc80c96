declare module 'draco3d/draco_decoder_nodejs.js' {
  export default function createDecoder(options: {
    wasmBinary: ArrayBuffer;
    printErr: (text: string) => void;
  }): Promise<unknown>;
}
