import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

export const ROOT = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
export const BUILD = join(ROOT, 'build');
export const NATIVE_PROGRAM = join(BUILD, 'native/abflat');
/** The folder for PYTHONPATH. */
export const PYTHON_DIST = join(BUILD, 'native/python');
export const WEB_DIST = join(ROOT, 'web/dist');
export const WASM_DIST = join(ROOT, 'wasm/dist');
