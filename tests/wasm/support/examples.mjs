import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from './paths.mjs';

/** The code blocks of the package's README, or of another file, by the name in the comment above them. */
export function examples(file = 'wasm/README.md') {
  const text = readFileSync(join(ROOT, file), 'utf8');
  const blocks = text.matchAll(/<!-- example: (\S+) -->\s*```\w+\n(.*?)```/gs);
  return Object.fromEntries([...blocks].map(([, name, code]) => [name, code]));
}

export const EXAMPLE_OBJ = 'v 0 0 0\nv 2 0 0\nv 2 2 1\nv 0 2 0\nf 1 2 3 4\n';
