// Vite plugin: what is made of the page's files once all are written.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { BUILD, ROOT } from '../../scripts/lib/paths.mjs';
import { compressFolder } from './compress.mjs';
import { writeWorker } from './offline.mjs';

const WORKER = join(ROOT, 'web/sw.js');

/** Not of pages for development, and not of the first one, which the next replaces at once. */
const isLast = (_, { command, mode }) => command === 'build' && mode === 'production';

/** @returns {import('vite').Plugin} */
export const afterBuild = (headers) => ({
  name: 'abflat-after-build',
  apply: isLast,
  writeBundle: {
    order: 'post',
    sequential: true,
    handler: async ({ dir }) => {
      writeWorker(dir, readFileSync(WORKER, 'utf8'), headers);
      await compressFolder(dir, join(BUILD, 'compressed'));
    },
  },
});
