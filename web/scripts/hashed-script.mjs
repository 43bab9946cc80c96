// Vite plugin: gives a script that is no module, which Vite leaves as it is, a name with a hash like that of all others.

import { readFileSync } from 'node:fs';
import { basename, join } from 'node:path';

/** @returns {import('vite').Plugin} */
export function hashedScript(path) {
  const name = basename(path);
  let root;
  return {
    name: 'abflat-hashed-script',
    apply: 'build',
    configResolved: (config) => {
      root = config.root;
    },
    buildStart() {
      this.emitFile({ type: 'asset', name, source: readFileSync(join(root, path)) });
    },
    transformIndexHtml: {
      order: 'post',
      handler: (html, { bundle }) => {
        const { fileName } = Object.values(bundle).find(({ names }) => names?.includes(name));
        return html.replace(`"./${path}"`, `"./${fileName}"`);
      },
    },
  };
}
