import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
export const DIST = join(ROOT, 'wasm/dist');
export const NATIVE = join(ROOT, 'build/native/abflat');
export const MESHES = join(ROOT, '../shared/meshes');
export const NEEDS_MESHES = {
  skip: existsSync(MESHES) ? false : 'there is no folder ../shared/meshes',
};
