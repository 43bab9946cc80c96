declare module 'three/examples/jsm/libs/basis/basis_transcoder.js' {
  interface Level {
    origWidth: number;
    origHeight: number;
  }

  class KTX2File {
    constructor(bytes: Uint8Array);
    isValid(): boolean;
    isHDR(): boolean;
    getImageLevelInfo(level: number, layer: number, face: number): Level;
    getImageTranscodedSizeInBytes(level: number, layer: number, face: number, to: number): number;
    startTranscoding(): boolean;
    transcodeImage(
      pixels: Uint8Array,
      level: number,
      layer: number,
      face: number,
      to: number,
      getAlphaForOpaqueFormats: number,
      channel0: number,
      channel1: number,
    ): boolean;
    close(): void;
    delete(): void;
  }

  export default function createTranscoder(options: {
    wasmBinary: ArrayBuffer;
    printErr: (text: string) => void;
  }): Promise<{ KTX2File: typeof KTX2File; initializeBasis(): void }>;
}
