import { AbflatError } from './errors.js';

/** A module with one vector instruction, i8x16.popcnt, which drafts of the vector proposal did not have yet. */
const WITH_VECTORS = new Uint8Array([
  ...[0x00, 0x61, 0x73, 0x6d, 1, 0, 0, 0], // magic, version
  ...[1, 5, 1, 0x60, 0, 1, 0x7b], // type: () -> v128
  ...[3, 2, 1, 0], // function 0 has it
  ...[10, 10, 1, 8, 0, 0x41, 0, 0xfd, 15, 0xfd, 98, 0x0b], // i32.const 0, i8x16.splat, i8x16.popcnt, end
]);

/** Throws where the modules of the package cannot be compiled, before any is loaded. */
export function checkHost(): void {
  if (typeof WebAssembly === 'undefined')
    throw new AbflatError(
      'UnsupportedHost',
      'abflat needs WebAssembly, which is switched off here, as it is in Lockdown Mode.',
    );
  if (!WebAssembly.validate(WITH_VECTORS))
    throw new AbflatError(
      'UnsupportedHost',
      'abflat needs WebAssembly with 128-bit vectors (SIMD), which is missing here: use Chrome or Edge 91, Firefox 89, ' +
        'Safari 16.4 or anything newer.',
    );
}
