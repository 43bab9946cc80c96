// Vite plugin: what is made of the page's files once all are written.

import { join } from 'node:path';
import { BUILD } from '../../scripts/lib/paths.mjs';
import { compressFolder } from './compress.mjs';

/** Not of pages for development, and not of the first one, which the next replaces at once. */
const isLast = (_, { command, mode }) => command === 'build' && mode === 'production';

/** @returns {import('vite').Plugin} */
export const afterBuild = () => ({
  name: 'abflat-after-build',
  apply: isLast,
  writeBundle: {
    order: 'post',
    sequential: true,
    handler: ({ dir }) => compressFolder(dir, join(BUILD, 'compressed')),
  },
});
