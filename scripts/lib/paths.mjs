import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

export const ROOT = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
export const BUILD = join(ROOT, 'build');
export const NATIVE_PROGRAM = join(BUILD, 'native/abflat');
export const WEB_DIST = join(ROOT, 'web/dist');
export const WASM_DIST = join(ROOT, 'wasm/dist');
